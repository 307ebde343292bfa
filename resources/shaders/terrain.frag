// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
in vec3 vPosition;
#ifdef FINE
in vec3 vSnow;
#endif
layout(binding = 5) uniform sampler2D uGround;     // colour, roughness / 0.1 m
layout(binding = 6) uniform sampler2D uSnowDepth;  // m
#ifdef CUT
uniform vec4 uCuts[16];  // x0, y0, x1, y1 drawn by fine grids
uniform int uCutCount;
#endif
layout(location = 0) out vec4 oColour;

vec3 groundColour(vec4 ground, vec4 broad, vec4 close, float roughness) {
  // Growth varies more than mineral ground, towards dry straw.
  float growth = smoothstep(0.045, 0.06, roughness);
  vec3 dry = mix(vec3(1.0), vec3(2.3, 1.45, 1.35), growth * smoothstep(0.30, 0.62, 0.6 * broad.r + 0.4 * close.r));
  return ground.rgb * dry * (0.55 + 0.55 * broad.r + 0.45 * close.r) * (0.92 + 0.16 * close.a);
}

void main() {
#ifdef CUT
  for (int k = 0; k < uCutCount; ++k) {
    vec4 cut = uCuts[k];
    if (vPosition.x > cut.x && vPosition.y > cut.y && vPosition.x < cut.z && vPosition.y < cut.w) discard;
  }
#endif
  vec2 uv = terrainUv(vPosition.xy);
  vec4 light = texture(uTerrainLight, uv);
  vec3 normal = vec3(light.xy, sqrt(max(1.0 - dot(light.xy, light.xy), 0.0)));
  vec4 broad = texture(uNoise, vPosition.xy * (1.0 / 61.0));
  vec4 close = texture(uNoise, vPosition.yx * (1.0 / 5.3));
  // Types blend over a ragged seam instead of along the raster.
  vec4 ground = texture(uGround, uv + (broad.gb - 0.5) * (2.2 / uTerrainSize.xy));
  if (uTerrainSize.w > 0.5) {
    oColour = vec4(finish(ground.rgb * (0.35 + 0.65 * max(dot(normal, normalize(vec3(-0.4, -0.3, 0.8))), 0.0)), vPosition), 1.0);
    return;
  }
  float roughness = max(ground.a * 0.1, 0.002);
  float sunlit = sunVisibility(vPosition);
  float skyOpen = light.z * mix(0.25, 1.0, zenithVisibility(vPosition));
#ifdef FINE
  float depth = vSnow.x;
  vec3 snowNormal = normalize(normal / normal.z - vec3(vSnow.yz, 0.0));
#else
  float depth = uTerrainSize.z > 0.5 ? texture(uSnowDepth, uv).r : 0.0;
  vec3 snowNormal = normal;
#endif
  float distance = length(vPosition - uEye.xyz);
  vec2 wrinkle = close.gb - 0.5;
  if (distance < 40.0) {
    // Close to the eye: tufts, crumbs and the grain of the snow surface.
    vec4 grain = texture(uNoise, vPosition.xy * (1.0 / 0.83));
    float near = 1.0 - smoothstep(15.0, 40.0, distance);
    wrinkle += (grain.gb - 0.5) * (0.55 * near);
    close.r += (grain.r - 0.5) * (0.9 * near);
  }
  float coverage = snowCoverage(depth, roughness, clamp(0.30 + 1.6 * (close.r - 0.5) + 0.55 * close.a, 0.0, 1.0));
  vec3 colour = vec3(0.0);
  if (coverage < 0.999) {
    vec3 bare = normalize(normal + vec3(wrinkle * 1.4 + (broad.gb - 0.5) * 0.8, 0.0));
    colour = groundColour(ground, broad, close, roughness) * diffuseLight(bare, sunlit, skyOpen);
  }
  if (coverage > 0.001) {
    vec4 drift = texture(uNoise, vPosition.xy * (1.0 / 17.0));
    vec3 n = normalize(snowNormal + vec3(wrinkle * 0.10 + (drift.gb - 0.5) * 0.22, 0.0));
    vec3 toEye = (uEye.xyz - vPosition) / distance;
    vec3 snow = snowColour(n, sunlit, skyOpen) * (0.97 + 0.06 * drift.r);
    colour = mix(colour, snow + snowSparkle(vPosition, n, toEye, distance, sunlit), coverage);
  }
  oColour = vec4(finish(colour, vPosition), 1.0);
}
