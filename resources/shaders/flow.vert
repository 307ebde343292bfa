// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Particles as round points of the size of their spheres.
layout(std430, binding = 0) readonly buffer Positions { float positions[]; };
layout(std430, binding = 1) readonly buffer Looks { vec4 looks[]; };
uniform vec4 uFlow;   // radius (m), pixels that 1 m covers at 1 m, smallest radius (px), scatter (radii)
uniform vec4 uScale;  // of clip x and y for the margins
uniform int uStride;  // one of so many particles is drawn
flat out vec4 vLook;    // place on the scale, share of water, foam, looseness
flat out vec4 vSphere;  // distance before the eye (m), radius (m), share of the disc that it really covers

void main() {
  int k = gl_VertexID * uStride;
  // Rows in which particles were laid out would be seen as furrows.
  vec3 moved = scatter(uint(k)) * (uFlow.w * uFlow.x);
  vec4 clip = uViewProjection * vec4(vec3(positions[3 * k], positions[3 * k + 1], positions[3 * k + 2]) + moved, 1.0);
  vLook = looks[k];
  float radius = uFlow.x * (1.0 + 0.3 * moved.x / uFlow.x - (0.3 + 0.25 * vLook.y) * vLook.w);
  float pixels = radius * uFlow.y / max(clip.w, 1e-3);
  float drawn = max(pixels, uFlow.z);
  vSphere = vec4(clip.w, radius, pixels * pixels / (drawn * drawn), 0.0);
  gl_PointSize = 2.0 * drawn;
  // Beyond 1: drawn as spray.
  bool hidden = clip.w < 0.2 + radius || vLook.w > 1.5;
  gl_Position = hidden ? vec4(2.0, 2.0, 2.0, 1.0) : vec4(clip.xy * uScale.xy, clip.zw);
}
