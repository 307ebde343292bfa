// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Particles into a shadow map.
layout(std430, binding = 0) readonly buffer Positions { float positions[]; };
uniform mat4 uLightModel;
uniform float uSize;  // texels across
uniform int uStride;  // one of so many particles is drawn
out vec2 vUv;

void main() {
  int k = gl_VertexID * uStride;
  vUv = vec2(0.0);
  gl_Position = uLightModel * vec4(positions[3 * k], positions[3 * k + 1], positions[3 * k + 2], 1.0);
  gl_PointSize = uSize;
}
