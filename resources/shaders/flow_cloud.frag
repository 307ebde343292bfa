// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// The dust before the surface, as a whole: how dense, and at what distance on the average.
in vec2 vScreen;
layout(binding = 7) uniform sampler2D uDust;
uniform vec4 uTarget;  // their pixels per pixel of the picture, margin, 1 / width, 1 / height
uniform vec4 uFlow;    // spacing (m), unused
layout(location = 0) out vec4 oColour;

void main() {
  vec2 at = (gl_FragCoord.xy * uTarget.x + uTarget.y) * uTarget.zw;
  vec2 dust = texture(uDust, at).rg;
  if (dust.r < 0.004) discard;
  float distance = 100.0 * dust.g / dust.r - 2.0 * uFlow.x;
  vec3 up = cross(uRight.xyz, uForward.xyz);
  vec3 p = uEye.xyz + distance * (uForward.xyz + uForward.w * (vScreen.x * uRight.w * uRight.xyz + vScreen.y * up));
  gl_FragDepth = uViewProjection[3][2] / max(distance, 0.11);
  float sunlit = mix(1.0, texture(uTerrainLight, terrainUv(p.xy)).a, uTerrainGrid.w);
  vec3 colour = uSun.rgb * (0.62 * sunlit) + uSky.rgb * 0.62 + uBounce.rgb * 0.3;
  oColour = vec4(finish(colour, hazeAt(p)), 1.0 - exp(-dust.r));
}
