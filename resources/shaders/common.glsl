// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
layout(std140, binding = 0) uniform FrameBlock {
  mat4 uViewProjection;
  mat4 uShadowMatrix;
  mat4 uZenithMatrix;
  vec4 uEye;
  vec4 uForward;
  vec4 uRight;
  vec4 uToSun;
  vec4 uSun;
  vec4 uSky;
  vec4 uBounce;
  vec4 uZenith;
  vec4 uHorizon;
  vec4 uTerrainGrid;
  vec4 uTerrainSize;
  vec4 uViewport;
  vec4 uSnowPhong;
};

// Texture coordinates of a local position in the terrain's rasters (cell centres at texel centres).
vec2 terrainUv(vec2 local) {
  return ((local - uTerrainGrid.xy) * uTerrainGrid.z + 0.5) / uTerrainSize.xy;
}

// Three numbers in -1..1 from one, the same on every machine.
vec3 scatter(uint n) {
  n = (n ^ (n >> 16)) * 0x7feb352du;
  n = (n ^ (n >> 15)) * 0x846ca68bu;
  n ^= n >> 16;
  return vec3(n & 1023u, (n >> 10) & 1023u, (n >> 20) & 1023u) * (2.0 / 1023.0) - 1.0;
}
