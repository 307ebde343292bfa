// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Coarse terrain (heights raised by the coarse cover), or with FINE a fine cover grid.
layout(location = 0) in vec3 aPosition;
#ifdef FINE
layout(location = 1) in vec4 aSnow;  // depth, its slope along x and y, sky that a hollow leaves
out vec4 vSnow;                      // the same, and of the sky what models leave open as well
#if defined(VALUES) || defined(PUBLISHED)
layout(location = 2) in vec4 aLook;
out vec4 vLook;
#endif
layout(std430, binding = 2) readonly buffer FinePositions { float finePositions[]; };  // x, y, z
layout(std430, binding = 3) readonly buffer FineSnow { vec4 fineSnow[]; };             // w = 0: no surface
uniform ivec4 uLattice;  // columns, rows, cells along a drawn quad, cells along a block
uniform float uMorph;    // 0: as it is, 1: on the surface that every second vertex draws alone

// Moves a vertex that the next coarser lattice of its block lacks onto the line between the two that it has.
void morph(inout float height, inout vec4 snow) {
  ivec2 at = ivec2(gl_VertexID % uLattice.x, gl_VertexID / uLattice.x);
  ivec2 local = at % uLattice.w, end = min(at - local + uLattice.w, uLattice.xy - 1);
  ivec2 between = ivec2(notEqual(local % (2 * uLattice.z), ivec2(0))) * ivec2(notEqual(at, end));
  ivec2 low = at - between * uLattice.z, high = mix(at, min(at + uLattice.z, end), equal(between, ivec2(1)));
  int a = low.y * uLattice.x + low.x, b = high.y * uLattice.x + high.x;
  if (a == b || fineSnow[a].w < 0.5 || fineSnow[b].w < 0.5) return;
  float t = between.x == 1 ? float(at.x - low.x) / float(high.x - low.x) : float(at.y - low.y) / float(high.y - low.y);
  height = mix(height, mix(finePositions[3 * a + 2], finePositions[3 * b + 2], t), uMorph);
  snow = mix(snow, mix(fineSnow[a], fineSnow[b], t), uMorph);
}
#else
layout(binding = 6) uniform sampler2D uSnowDepth;
#endif
out vec3 vPosition;
out vec4 vHaze;

void main() {
#ifdef FINE
  vec4 snow = aSnow;
  float height = aPosition.z;
  if (uMorph > 0.0) morph(height, snow);
  vPosition = vec3(aPosition.xy, height + snow.x);
#else
  ivec2 cell = ivec2(round((aPosition.xy - uTerrainGrid.xy) * uTerrainGrid.z));
  float depth = uTerrainSize.z > 0.5 ? texelFetch(uSnowDepth, cell, 0).r : 0.0;
  vPosition = aPosition + vec3(0.0, 0.0, depth);
#endif
#ifdef FINE
  vSnow = vec4(snow.xyz, snow.w * mix(0.25, 1.0, zenithVisibility(vPosition)));
#if defined(VALUES) || defined(PUBLISHED)
  vLook = aLook;
#endif
#endif
  vHaze = hazeAt(vPosition);
  gl_Position = uViewProjection * vec4(vPosition, 1.0);
}
