// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Puffs of dust over fast snow: one of some particles stands for all of them.
layout(std430, binding = 0) readonly buffer Positions { float positions[]; };
layout(std430, binding = 1) readonly buffer Looks { vec4 looks[]; };
uniform vec4 uFlow;   // radius (m), pixels that 1 m covers at 1 m, unused
uniform vec4 uScale;  // of clip x and y for the margins
uniform int uStride;
flat out vec4 vPuff;  // distance before the eye (m), opacity, place in the noise

void main() {
  int k = gl_VertexID * uStride;
  vec3 random = scatter(uint(k));
  float dust = looks[k].y > 0.5 ? 0.0 : looks[k].z;
  float high = looks[k].x * (0.6 + 0.4 * random.x);
  float least = uFlow.x * (3.2 + 1.4 * random.x) * (0.5 + 0.5 * dust), radius = least + 0.8 * high;
  vec3 place = vec3(positions[3 * k], positions[3 * k + 1], positions[3 * k + 2]);
  place += uFlow.x * vec3(1.5 * random.yz, 0.8 + 1.6 * dust) + high * vec3(0.8 * random.yz, 0.7 + 0.5 * random.y);
  vec4 clip = uViewProjection * vec4(place, 1.0);
  float pixels = radius * uFlow.y / max(clip.w, 1e-3);
  // What is smaller than a pixel counts by its area.
  float drawn = max(pixels, 1.0);
  // The same dust, spread over more.
  float thin = least / radius;
  vPuff = vec4(clip.w, 0.5 * dust * thin * min(pixels * pixels, 1.0), 0.5 + 0.5 * random.xy);
  gl_PointSize = min(2.0 * drawn, 120.0);
  bool shown = dust > 0.05 && clip.w > 0.3 + 2.0 * radius;
  gl_Position = shown ? vec4(clip.xy * uScale.xy, clip.zw) : vec4(2.0, 2.0, 2.0, 1.0);
}
