// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// The dust before the surface, as a whole: how dense, and at what distance on the average.
in vec2 vScreen;
layout(binding = 7) uniform sampler2D uDust;
layout(binding = 9) uniform sampler2D uDistance;  // of the surface, m; 0 = none
uniform vec4 uTarget;  // their pixels per pixel of the picture, margin, 1 / width, 1 / height
uniform vec4 uFlow;    // spacing (m), unused
layout(location = 0) out vec4 oColour;

void main() {
  vec2 texel = gl_FragCoord.xy * uTarget.x + uTarget.y;
  vec2 dust = texture(uDust, texel * uTarget.zw).rg;
  if (dust.r < 0.004) discard;
  float distance = 100.0 * dust.g / dust.r - 2.0 * uFlow.x;
  // Dust thins out where it comes to lie behind the surface, and what lies before it is never cut off by it.
  float surface = texelFetch(uDistance, ivec2(texel), 0).r;
  float before = (surface - distance) / uFlow.x;
  float share = surface > 0.0 ? smoothstep(-5.0, 3.0, before) : 1.0;
  distance = surface > 0.0 ? min(distance, surface - 0.1 * uFlow.x) : distance;
  vec3 up = cross(uRight.xyz, uForward.xyz);
  vec3 p = uEye.xyz + distance * (uForward.xyz + uForward.w * (vScreen.x * uRight.w * uRight.xyz + vScreen.y * up));
  gl_FragDepth = uViewProjection[3][2] / max(distance, 0.11);
  float sunlit = mix(1.0, texture(uTerrainLight, terrainUv(p.xy)).a, uTerrainGrid.w) *
                 modelShadow(p + uToSun.xyz * (3.0 * uFlow.x));
  // Billows: thick dust bulges towards the eye, and stands in its own shade.
  vec2 uv = texel * uTarget.zw, step = 3.0 * uTarget.zw;
  float across = texture(uDust, uv + vec2(step.x, 0.0)).r - texture(uDust, uv - vec2(step.x, 0.0)).r;
  float along = texture(uDust, uv + vec2(0.0, step.y)).r - texture(uDust, uv - vec2(0.0, step.y)).r;
  vec3 bulge = normalize(-uForward.xyz - (across * uRight.xyz + along * up) / (0.4 + 0.5 * dust.r));
  float facing = clamp(0.5 + 0.5 * dot(bulge, uToSun.xyz), 0.0, 1.0), deep = 1.0 - exp(-0.3 * dust.r);
  float lit = mix(0.62, mix(0.24, 0.66, facing), deep);
  vec3 colour = uSun.rgb * (lit * sunlit) + uSky.rgb * mix(0.62, 0.5 + 0.2 * bulge.z, deep) + uBounce.rgb * 0.3;
  oColour = vec4(finish(colour, hazeAt(p)), share * (1.0 - exp(-0.7 * dust.r)));
}
