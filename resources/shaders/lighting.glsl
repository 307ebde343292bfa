// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
layout(binding = 0) uniform sampler2D uNoise;           // makeNoiseTile()
layout(binding = 1) uniform sampler2DShadow uShadowMap; // models as the sun sees them
layout(binding = 2) uniform sampler2DShadow uZenithMap; // models as the zenith sees them
layout(binding = 3) uniform sampler2D uTerrainLight;    // normal x, y, sky share, sun share

// Software drivers run both sides of a branch: what is not always needed stands in variants of the programs
// or in the vertex stage, not in branches.

// Share of the sun's beam that models let through.
float modelShadow(vec3 p) {
  vec3 s = (uShadowMatrix * vec4(p, 1.0)).xyz;
  float rim = max(abs(s.x), abs(s.y));
  float lit = texture(uShadowMap, vec3(s.xy * 0.5 + 0.5, s.z - 0.0012));
  return mix(1.0, lit, uZenith.w * (1.0 - smoothstep(0.85, 0.98, rim)));
}

// Share of the sun's beam that the terrain and the models let through to a point near the ground.
float sunVisibility(vec3 p) {
  return modelShadow(p) * texture(uTerrainLight, terrainUv(p.xy)).a;
}

// Share of the sky above a point that models leave open, from two wide looks into the zenith map.
float zenithVisibility(vec3 p) {
  vec3 s = (uZenithMatrix * vec4(p, 1.0)).xyz;
  float rim = max(abs(s.x), abs(s.y));
  vec2 uv = s.xy * 0.5 + 0.5;
  float d = s.z - 0.0012;
  float open = texture(uZenithMap, vec3(uv + vec2(0.0058, 0.0037), d)) +
               texture(uZenithMap, vec3(uv - vec2(0.0058, 0.0037), d));
  return mix(1.0, 0.5 * open, uZenith.w * (1.0 - smoothstep(0.85, 0.98, rim)));
}

// Colour of the sky in a direction: what the haze fades to.
vec3 skyColour(vec3 direction) {
  float up = clamp(direction.z, 0.0, 1.0);
  vec3 colour = mix(uHorizon.rgb, uZenith.rgb, 1.0 - exp(-3.2 * up));
  float towards = clamp(dot(direction, uToSun.xyz), 0.0, 1.0);
  float clear = 1.0 - uSun.w;
  float t2 = towards * towards, t8 = t2 * t2 * t2 * t2;
  return colour + uSun.rgb * (0.10 * t8 + 0.05 * t2) * (0.35 + 0.65 * clear);
}

// Light that a diffuse surface reflects: sun, sky above, surroundings below.
vec3 diffuseLight(vec3 normal, float sunlit, float skyOpen) {
  float sunCos = max(dot(normal, uToSun.xyz), 0.0);
  float up = 0.5 + 0.5 * normal.z;
  return uSun.rgb * (sunCos * sunlit) + uSky.rgb * (up * skyOpen) +
         uBounce.rgb * ((1.0 - up) * (0.4 + 0.6 * skyOpen) + up * (1.0 - skyOpen) * 0.35);
}

#ifdef PUBLISHED
// The published shading, C_p = I_a K_a + I_d K_d (L.N) + K_s (N.H)^n: I_a the open sky's light, I_d the sun's,
// which the highlight has too; all of the sun's part ends where its beam does.
vec3 snowColour(vec3 normal, vec3 toEye, float sunlit, float skyOpen) {
  float sunCos = max(dot(normal, uToSun.xyz), 0.0);
  float mirrored = max(dot(normal, normalize(uToSun.xyz + toEye)), 0.0);
  float highlight = sunCos > 0.0 ? pow(mirrored, uSnowPhong.w) : 0.0;
  return uSky.rgb * uSnowPhong.x + uSun.rgb * (sunlit * (uSnowPhong.y * sunCos + uSnowPhong.z * highlight));
}
#else
// Fresh snow: bright in all directions; light that enters comes out again beside, so that the edge of shade
// is soft (wrapped cosine) and shade itself is bluish.
vec3 snowColour(vec3 normal, vec3 toEye, float sunlit, float skyOpen) {
  const vec3 albedo = vec3(0.87, 0.88, 0.90);
  float sunCos = dot(normal, uToSun.xyz);
  float wrapped = max((sunCos + 0.22) / 1.22, 0.0);
  float up = 0.5 + 0.5 * normal.z;
  vec3 shade = uSky.rgb * (up * skyOpen) * vec3(0.94, 0.98, 1.04);
  vec3 around = uBounce.rgb * ((1.0 - up) + up * (1.0 - skyOpen) * 0.5);
  return albedo * (uSun.rgb * (mix(wrapped, max(sunCos, 0.0), 0.5) * sunlit) + shade + around);
}
#endif

// A colour that stands for a value, with just enough relief to read the ground's form. `look` holds the root
// of the colour times the share that has a value, and that share; the rest is grey.
vec3 valueColour(vec4 look, vec3 normal) {
  float shade = 0.35 + 0.65 * max(dot(normal, vec3(-0.42, -0.32, 0.85)), 0.0);
  // Samples at the rim of a triangle lie outside of it.
  vec3 root = clamp(look.rgb / max(look.a, 1e-3), 0.0, 1.0);
  return mix(vec3(0.16, 0.165, 0.175), root * root, clamp(look.a, 0.0, 1.0)) * shade;
}

// Sun that single crystals mirror into the eye; only where texels of the white noise are seen apart.
vec3 snowSparkle(float white, vec3 normal, vec3 toEye, float distance, float sunlit) {
  float glint = smoothstep(0.975, 1.0, white) * (1.0 - smoothstep(6.0, 16.0, distance));
  float lobe = max(dot(normal, normalize(uToSun.xyz + toEye)), 0.0);
  return uSun.rgb * (glint * sunlit * 1.4 * lobe * lobe * lobe);
}

// Tone curve: linear below 0.7, then a shoulder that keeps highlights from clipping.
vec3 shoulder(vec3 colour) {
  vec3 high = max(colour - 0.7, 0.0);
  return min(colour, 0.7) + 0.4 * high / (high + 0.4);
}

// Colour of the haze before a point and, in w, the share of the point's own light that passes it. It varies
// slowly: the vertex stage computes it.
vec4 hazeAt(vec3 p) {
  vec3 ray = p - uEye.xyz;
  float distance = length(ray);
  float kept = exp(-uHorizon.w * distance);
  return vec4(skyColour(ray / max(distance, 1e-3)) * (1.0 - kept), kept);
}

// The finished picture value of a surface: veiled by haze, then the tone curve.
vec3 finish(vec3 colour, vec4 haze) {
  return shoulder(colour * haze.w + haze.rgb);
}

// How much of the ground snow hides. Thin snow sinks between stems and stones: `roughness` (m) is how far
// they stand out, and `grain` in 0..1 says where.
float snowCoverage(float depth, float roughness, float grain) {
  float level = depth - roughness * grain;
  return clamp(level / (0.35 * roughness) + 0.15, 0.0, 1.0) * smoothstep(0.0, 0.004, depth);
}

#ifdef AIR_KEPT
layout(binding = 11) uniform sampler2D uAirLook;   // a: share of what is behind the cloud that is seen
layout(binding = 12) uniform sampler2D uAirPlace;  // y, z: mean distance of the cloud before the eye, deviation

// Share of what stands at a distance that the cloud in the air lets through, at a place 0..1 of the picture.
float airKept(vec2 place, float distance) {
  vec4 p = texture(uAirPlace, place);
  float passed = smoothstep(-1.7, 1.7, (distance - p.y) / max(p.z, 0.01 * distance));
  return pow(max(texture(uAirLook, place).a, 1e-4), passed);
}
#endif
