// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
flat in vec4 vPuff;
layout(location = 0) out vec2 oDust;

void main() {
  vec2 d = gl_PointCoord * 2.0 - 1.0;
  float fall = 1.0 - dot(d, d);
  if (fall <= 0.0) discard;
  float shape = 0.35 + 1.3 * textureLod(uNoise, vPuff.zw + 0.13 * gl_PointCoord, 0.0).r;
  float depth = vPuff.y * fall * fall * max(shape - 0.45, 0.0) * 2.0;
  oDust = depth * vec2(1.0, 0.01 * vPuff.x);
}
