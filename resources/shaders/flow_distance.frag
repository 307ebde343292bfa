// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
flat in vec4 vLook;
flat in vec4 vSphere;
layout(location = 0) out vec2 oDistance;

void main() {
  vec2 d = gl_PointCoord * 2.0 - 1.0;
  float square = dot(d, d);
  if (square > 1.0) discard;
  float distance = vSphere.x - vSphere.y * sqrt(1.0 - square);
  oDistance = vec2(distance, vLook.x);
  gl_FragDepth = uViewProjection[3][2] / distance;
}
