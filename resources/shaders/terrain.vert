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
#else
layout(binding = 6) uniform sampler2D uSnowDepth;
#endif
out vec3 vPosition;
out vec4 vHaze;

void main() {
#ifdef FINE
  float depth = aSnow.x;
#else
  ivec2 cell = ivec2(round((aPosition.xy - uTerrainGrid.xy) * uTerrainGrid.z));
  float depth = uTerrainSize.z > 0.5 ? texelFetch(uSnowDepth, cell, 0).r : 0.0;
#endif
  vPosition = aPosition + vec3(0.0, 0.0, depth);
#ifdef FINE
  vSnow = vec4(aSnow.xyz, aSnow.w * mix(0.25, 1.0, zenithVisibility(vPosition)));
#if defined(VALUES) || defined(PUBLISHED)
  vLook = aLook;
#endif
#endif
  vHaze = hazeAt(vPosition);
  gl_Position = uViewProjection * vec4(vPosition, 1.0);
}
