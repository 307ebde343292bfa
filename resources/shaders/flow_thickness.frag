// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Sums up what a ray passes of each sphere.
flat in vec4 vLook;
flat in vec4 vSphere;
uniform float uFilled;  // volume that a particle stands for, over the volume of its sphere
layout(location = 0) out vec4 oThickness;

void main() {
  vec2 d = gl_PointCoord * 2.0 - 1.0;
  float square = dot(d, d);
  if (square > 1.0) discard;
  float thickness = 2.0 * vSphere.y * sqrt(1.0 - square) * vSphere.z * uFilled;
  oThickness = thickness * vec4(1.0, vLook.y, vLook.z, vLook.w);
}
