// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Parcels of drops as streaks: where each is at the moment, drawn out by half of its motion to either side.
layout(std430, binding = 0) readonly buffer Puffs { vec4 puffs[]; };  // position, area; velocity, radius
uniform vec4 uSpray;   // exposure time (s), smallest width (px), pixels that 1 m covers at 1 m
out vec2 vPlace;           // from the streak's middle, in radii
flat out vec2 vBody;       // half the length of the streak without its ends, in radii; optical depth
flat out vec3 vWhere;      // distance before the eye (m), radius (m), a number of its own
flat out vec3 vColour;

// Drops that are large against the wavelength, without the peak of diffraction (mean cosine 0.77), times pi.
float dropLobe(float cosine) {
  const float g = 0.77;
  float d = 1.0 + g * g - 2.0 * g * cosine;
  return 0.25 * (1.0 - g * g) / (d * sqrt(d));
}

void main() {
  vec4 first = puffs[2 * gl_InstanceID], second = puffs[2 * gl_InstanceID + 1];
  vec4 clip = uViewProjection * vec4(first.xyz, 1.0);
  float radius = second.w, pixels = radius * uSpray.z / max(clip.w, 1e-3);
  float drawn = max(pixels, 0.5 * uSpray.y);
  vec4 moved = uViewProjection * vec4(first.xyz + second.xyz * uSpray.x, 1.0);
  vec2 halfScreen = 0.5 * uViewport.xy;
  vec2 streak = moved.w > 0.05 ? (moved.xy / moved.w - clip.xy / clip.w) * halfScreen : vec2(0.0);
  float extent = min(length(streak), 400.0);
  vec2 along = extent > 0.01 ? streak / length(streak) : vec2(1.0, 0.0), across = vec2(-along.y, along.x);
  float body = 0.5 * extent / drawn;
  vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
  vPlace = corner * vec2(1.0 + body, 1.0);
  vec2 offset = drawn * (along * vPlace.x + across * vPlace.y);
  // The same drops over what is drawn of them.
  float face = 3.14159265 * radius * radius * (drawn * drawn) / max(pixels * pixels, 1e-6) * (1.0 + 1.27 * body);
  vBody = vec2(body, first.w / max(face, 1e-6));
  vWhere = vec3(clip.w, radius, 0.5 + 0.5 * scatter(uint(gl_InstanceID)).x);
  bool shown = clip.w > 0.2 + radius && drawn < 0.5 * uViewport.y;
  gl_Position = shown ? vec4(clip.xy + offset / halfScreen * clip.w, clip.zw) : vec4(2.0, 2.0, 2.0, 1.0);
  float cosine = dot(normalize(first.xyz - uEye.xyz), uToSun.xyz);
  float sunlit = mix(1.0, textureLod(uTerrainLight, terrainUv(first.xy), 0.0).a, uTerrainGrid.w);
  vec3 colour = uSun.rgb * (sunlit * (0.3 + min(dropLobe(cosine), 2.0))) + 0.5 * (uSky.rgb + uBounce.rgb);
  vColour = finish(colour, hazeAt(first.xyz));
}
