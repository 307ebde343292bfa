// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Variants: FINE (a fine cover grid), NEAR (cut by fine grids, shaded by models, with the grain that only near
// ground shows), FALSE_COLOURS (painted layers as they are), VALUES (colours that the cover's values have; cut as
// well), PUBLISHED (shading and blend of snow as published).
in vec3 vPosition;
in vec4 vHaze;
#ifdef FINE
in vec4 vSnow;
#endif
// The colour of the cell's value and whether it has one, or the share f_p of snow in w.
#if defined(VALUES) || defined(PUBLISHED)
#ifdef FINE
in vec4 vLook;
#else
layout(binding = 8) uniform sampler2D uCoverLook;
#endif
#endif
layout(binding = 5) uniform sampler2D uGround;     // roots of the colour, roughness / 0.1 m
layout(binding = 6) uniform sampler2D uSnowDepth;  // m
#if defined(NEAR) || defined(VALUES)
uniform vec4 uCuts[16];  // x0, y0, x1, y1 drawn by fine grids
uniform int uCutCount;
#endif
layout(location = 0) out vec4 oColour;

vec3 groundColour(vec4 ground, float broad, float close, float roughness) {
  // Growth varies more than mineral ground, towards dry straw.
  float growth = smoothstep(0.045, 0.06, roughness);
  vec3 dry = mix(vec3(1.0), vec3(2.3, 1.45, 1.35), growth * smoothstep(0.30, 0.62, 0.6 * broad + 0.4 * close));
  return ground.rgb * dry * (0.60 + 0.55 * broad + 0.45 * close);
}

void main() {
#if (defined(NEAR) || defined(VALUES)) && !defined(FINE)
  for (int k = 0; k < uCutCount; ++k) {
    vec4 cut = uCuts[k];
    if (vPosition.x > cut.x && vPosition.y > cut.y && vPosition.x < cut.z && vPosition.y < cut.w) discard;
  }
#endif
  vec2 uv = terrainUv(vPosition.xy);
  vec4 light = texture(uTerrainLight, uv);
  vec2 tilt = light.xy * (255.0 / 127.0) - (128.0 / 127.0);
  vec3 normal = vec3(tilt, sqrt(max(1.0 - dot(tilt, tilt), 0.01)));
#if (defined(VALUES) || defined(PUBLISHED)) && !defined(FINE)
  vec4 vLook = texture(uCoverLook, uv);
#endif
#ifdef VALUES
#ifdef FINE
  normal = normalize(normal / normal.z - vec3(vSnow.yz, 0.0));
#endif
  oColour = vec4(finish(valueColour(vLook, normal), vHaze), 1.0);
#elif defined(FALSE_COLOURS)
  float shade = 0.35 + 0.65 * max(dot(normal, vec3(-0.42, -0.32, 0.85)), 0.0);
  vec3 root = texture(uGround, uv).rgb;
  oColour = vec4(finish(root * root * shade, vHaze), 1.0);
#else
  vec4 broad = texture(uNoise, vPosition.xy * (1.0 / 61.0));
  // Types blend over a ragged seam instead of along the raster.
  vec4 ground = texture(uGround, uv + (broad.gb - 0.5) * (2.2 / uTerrainSize.xy));
  ground.rgb *= ground.rgb;
  float roughness = max(ground.a * 0.1, 0.002);
  float sunlit = light.a, skyOpen = light.z;
#ifdef FINE
  float depth = vSnow.x;
  vec3 snowNormal = normal / normal.z - vec3(vSnow.yz, 0.0);
  skyOpen *= vSnow.w;
#else
  float depth = texture(uSnowDepth, uv).r * uTerrainSize.z;
  vec3 snowNormal = normal;
#endif
#ifdef NEAR
  float distance = length(vPosition - uEye.xyz);
  float nearness = 1.0 - smoothstep(15.0, 40.0, distance);
  vec4 close = texture(uNoise, vPosition.yx * (1.0 / 5.3));
  vec4 grain = texture(uNoise, vPosition.xy * (1.0 / 0.83));
  vec2 wrinkle = close.gb - 0.5 + (grain.gb - 0.5) * (0.55 * nearness);
  float detail = close.r + (grain.r - 0.5) * (0.9 * nearness), white = close.a;
  sunlit *= modelShadow(vPosition);
#else
  vec2 wrinkle = broad.bg - 0.5;
  float detail = broad.r, white = broad.a;
#endif
  float coverage = snowCoverage(depth, roughness, clamp(0.30 + 1.6 * (detail - 0.5) + 0.55 * white, 0.0, 1.0));
  vec3 toEye = normalize(uEye.xyz - vPosition);
#ifdef PUBLISHED
  coverage *= vLook.a;
#endif
  vec2 drift = broad.gb - 0.5;
  vec3 bare = normalize(normal + vec3(wrinkle * 1.4 + drift * 0.8, 0.0));
  vec3 soil = groundColour(ground, broad.r, detail, roughness) * diffuseLight(bare, sunlit, skyOpen);
  vec3 n = normalize(snowNormal + vec3(wrinkle * 0.13 + drift * 0.20, 0.0));
  vec3 snow = snowColour(n, toEye, sunlit, skyOpen);
#ifndef PUBLISHED
  // Under an even sky only hollows, which see less of it, show the form of what the wind has left.
  snow *= 0.89 + 0.15 * detail + 0.07 * broad.r;
#endif
#if defined(NEAR) && !defined(PUBLISHED)
  snow += snowSparkle(grain.a, n, toEye, distance, sunlit);
#endif
  oColour = vec4(finish(mix(soil, snow, coverage), vHaze), 1.0);
#endif
}
