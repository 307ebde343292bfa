// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
layout(binding = 7) uniform sampler2D uSum;
layout(binding = 8) uniform sampler2D uThrough;
layout(location = 0) out vec4 oColour;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float cover = 1.0 - texelFetch(uThrough, at, 0).r;
  if (cover < 0.002) discard;
  vec4 sum = texelFetch(uSum, at, 0);
  oColour = vec4(sum.rgb / max(sum.a, 1e-6), cover);
}
