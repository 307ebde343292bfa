// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Variant CUTOUT: foliage, lit per vertex, with texels cut away.
in vec3 vPosition;
in vec3 vNormal;
in vec2 vUv;
in vec2 vOpen;
in vec4 vHaze;
layout(binding = 6) uniform sampler2D uSnowDepth;  // m, of the ground
layout(binding = 7) uniform sampler2D uTexture;
uniform vec4 uBaseColour;
uniform vec4 uSurface;    // textured, double-sided, roughness, dusting 0..1
uniform vec4 uHighlight;  // colour and strength
layout(location = 0) out vec4 oColour;

// What carries no cover of its own is as white on top as the open ground beside it is deep in snow.
vec3 dusted(vec3 colour, vec3 normal, vec3 toEye, float sunlit) {
  if (uSurface.w <= 0.0 || uTerrainSize.w > 0.5) return colour;
  float depth = texture(uSnowDepth, terrainUv(vPosition.xy)).r * uTerrainSize.z;
  vec4 close = texture(uNoise, (vPosition.xy + vPosition.z * vec2(0.37, 0.61)) * (1.0 / 2.3));
#ifdef CUTOUT
  // Needles hold little before it slips through them.
  float up = smoothstep(0.3, 0.9, normal.z + 0.6 * (close.r - 0.5));
  float cover = uSurface.w * up * snowCoverage(depth * vOpen.x, 0.08, close.a);
#else
  float up = smoothstep(0.15, 0.65, normal.z + 0.5 * (close.r - 0.5));
  float cover = uSurface.w * up * snowCoverage(depth * vOpen.x, 0.02, close.a);
#endif
#ifdef PUBLISHED
  cover *= vOpen.x;
#endif
  vec3 n = normalize(normal + vec3((close.gb - 0.5) * 0.3, 0.4));
  return mix(colour, snowColour(n, toEye, sunlit, vOpen.x), cover);
}

void main() {
  vec4 texel = texture(uTexture, vUv);
  texel.rgb *= texel.rgb;  // stored as roots
  vec4 base = uBaseColour * mix(vec4(1.0), texel, uSurface.x);
#ifdef CUTOUT
  // Mip levels thin out cut-outs; raising alpha with the level keeps their area.
  float level = max(textureQueryLod(uTexture, vUv).x, 0.0);
  if (base.a * (1.0 + 0.22 * level) < 0.5) discard;
#endif
  vec3 toEye = normalize(uEye.xyz - vPosition);
  vec3 normal = normalize(vNormal);
  float facing = dot(normal, toEye);
#ifdef CUTOUT
  // Light shines through needles: the far side is as bright as the near one.
  vec3 colour = base.rgb * diffuseLight(normal, vOpen.y, vOpen.x);
  colour = dusted(colour, facing < 0.0 ? -normal : normal, toEye, vOpen.y);
#else
  if (uSurface.y > 0.5 && facing < 0.0) normal = -normal;
  float sunlit = vOpen.y * modelShadow(vPosition + normal * 0.03);
  vec3 colour = base.rgb * diffuseLight(normal, sunlit, vOpen.x);
  float gloss = max(0.9 - uSurface.z, 0.0), rim = 1.0 - abs(facing);
  float rim2 = rim * rim;
  colour += gloss * skyColour(reflect(-toEye, normal)) * (0.05 + 0.6 * rim2 * rim2);
  colour = dusted(colour, normal, toEye, sunlit);
#endif
  colour = mix(colour, uHighlight.rgb, uHighlight.a * (1.0 - 0.65 * abs(facing)));
  oColour = vec4(finish(colour, vHaze), 1.0);
}
