// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Falling flakes: the copy of each that lies nearest to the eye, as a sprite of its true size, drawn out along
// its way during the exposure.
layout(std430, binding = 0) readonly buffer Positions { float positions[]; };
layout(std430, binding = 1) readonly buffer Diameters { float diameters[]; };
layout(std430, binding = 2) readonly buffer Velocities { float velocities[]; };
uniform vec4 uBox;    // period (m, 0 = none), real flakes per sprite, exposure time (s), smallest width (px)
uniform vec4 uFlake;  // default diameter (m), has diameters, has velocities, turn of the shapes
out vec3 vShape;
out float vOpacity;

vec3 fetch3(int k, int which) {
  return which == 0 ? vec3(positions[3 * k], positions[3 * k + 1], positions[3 * k + 2])
                    : vec3(velocities[3 * k], velocities[3 * k + 1], velocities[3 * k + 2]);
}

void main() {
  int k = gl_VertexID >> 2;
  vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  vShape = vec3(0.0);
  vOpacity = 0.0;
  vec3 p = fetch3(k, 0);
  if (uBox.x > 0.0) p -= uBox.x * round((p - uEye.xyz) / uBox.x);
  vec4 clip = uViewProjection * vec4(p, 1.0);
  float range = uBox.x > 0.0 ? 0.5 * uBox.x : 1e6;
  if (clip.w < 0.3 || clip.w > range || abs(clip.x) > 1.2 * clip.w || abs(clip.y) > 1.2 * clip.w) return;

  vec2 halfScreen = 0.5 * uViewport.xy;
  float size = (uFlake.y > 0.5 ? diameters[k] : uFlake.x) * uViewport.z / clip.w;
  float width = max(size, uBox.w);
  vec2 streak = vec2(0.0);
  if (uFlake.z > 0.5) {
    vec4 end = uViewProjection * vec4(p + fetch3(k, 1) * uBox.z, 1.0);
    streak = (end.xy / end.w - clip.xy / clip.w) * halfScreen;
  }
  float drawn = length(streak);
  vec2 along = drawn > 0.01 ? streak / drawn : vec2(1.0, 0.0);
  drawn = min(drawn, 400.0);
  vec2 across = vec2(-along.y, along.x);
  vec2 offset = along * (corner.x * 0.5 * (width + drawn)) + across * (corner.y * 0.5 * width);
  gl_Position = clip;
  gl_Position.xy += offset / halfScreen * clip.w;

  // A sprite below the smallest width stands for so many flakes that they fill it, if there are that many.
  float filled = min(uBox.y * size * size / (width * width), 1.0);
  float crossing = filled * width / (width + drawn);
  // Drawn out, a flake is thin; of the many that a sprite stands for, up to four are laid over one another.
  vOpacity = 1.0 - pow(1.0 - min(crossing, 0.999), clamp(uBox.y, 1.0, 4.0));
  vOpacity *= smoothstep(0.3, 1.2, clip.w) * (1.0 - smoothstep(0.75, 1.0, clip.w / range));
  vShape = vec3(0.5 + 0.5 * corner, float(k % 8));
}
