// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
in vec3 vPosition;
in vec3 vNormal;
in vec3 vOpen;
in vec4 vHaze;
layout(location = 0) out vec4 oColour;

void main() {
  vec4 close = texture(uNoise, vPosition.xy * (1.0 / 2.3));
  float coverage = snowCoverage(vOpen.x, 0.012, clamp(0.2 + close.r * 0.6 + 0.3 * close.a, 0.0, 1.0));
  if (coverage < 0.02) discard;
  vec3 normal = normalize(vNormal + vec3((close.gb - 0.5) * 0.12, 0.0));
  oColour = vec4(finish(snowColour(normal, vOpen.z, vOpen.y), vHaze), coverage);
}
