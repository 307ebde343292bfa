// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Marked cells of the terrain, on the snow, a little nearer to the eye than the ground that they tint.
layout(location = 0) in vec3 aPosition;
layout(location = 1) in float aShare;
layout(binding = 6) uniform sampler2D uSnowDepth;
out float vShare;

void main() {
  ivec2 cell = ivec2(round((aPosition.xy - uTerrainGrid.xy) * uTerrainGrid.z));
  float depth = uTerrainSize.z > 0.5 ? texelFetch(uSnowDepth, cell, 0).r : 0.0;
  vShare = aShare;
  gl_Position = uViewProjection * vec4(aPosition + vec3(0.0, 0.0, depth + 0.15), 1.0);
  gl_Position.z *= 1.01;
}
