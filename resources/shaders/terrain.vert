// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Coarse terrain (heights raised by the coarse cover), or with FINE a fine cover grid.
layout(location = 0) in vec3 aPosition;
#ifdef FINE
layout(location = 1) in vec3 aSnow;  // depth and its slope along x and y
out vec3 vSnow;
#else
layout(binding = 6) uniform sampler2D uSnowDepth;
#endif
out vec3 vPosition;

void main() {
#ifdef FINE
  vSnow = aSnow;
  float depth = aSnow.x;
#else
  ivec2 cell = ivec2(round((aPosition.xy - uTerrainGrid.xy) * uTerrainGrid.z));
  float depth = uTerrainSize.z > 0.5 ? texelFetch(uSnowDepth, cell, 0).r : 0.0;
#endif
  vPosition = aPosition + vec3(0.0, 0.0, depth);
  gl_Position = uViewProjection * vec4(vPosition, 1.0);
}
