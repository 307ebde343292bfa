// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
in vec3 vPosition;
in vec3 vNormal;
in float vThickness;
layout(location = 0) out vec4 oColour;

void main() {
  vec4 close = texture(uNoise, vPosition.xy * (1.0 / 2.3));
  float coverage = snowCoverage(vThickness, 0.012, clamp(0.2 + close.r * 0.6 + 0.3 * close.a, 0.0, 1.0));
  if (coverage < 0.02) discard;
  vec3 normal = normalize(normalize(vNormal) + vec3((close.gb - 0.5) * 0.12, 0.0));
  float distance = length(vPosition - uEye.xyz);
  vec3 toEye = (uEye.xyz - vPosition) / distance;
  float sunlit = sunVisibility(vPosition + normal * 0.08);
  float skyOpen = mix(0.35, 1.0, zenithVisibility(vPosition + vec3(0.0, 0.0, 0.3)));
  vec3 colour = snowColour(normal, sunlit, skyOpen) + snowSparkle(vPosition, normal, toEye, distance, sunlit);
  oColour = vec4(finish(colour, vPosition), coverage);
}
