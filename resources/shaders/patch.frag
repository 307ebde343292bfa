// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
in vec3 vPosition;
in vec3 vNormal;
in vec3 vOpen;
#if defined(VALUES) || defined(PUBLISHED)
in vec4 vLook;
#endif
in vec4 vHaze;
layout(location = 0) out vec4 oColour;

void main() {
#ifdef VALUES
  if (vLook.a < 0.5) discard;
  oColour = vec4(finish(valueColour(vec4(vLook.rgb / vLook.a, 1.0), normalize(vNormal)), vHaze), 1.0);
#else
  vec4 close = texture(uNoise, vPosition.xy * (1.0 / 2.3));
  float coverage = snowCoverage(vOpen.x, 0.012, clamp(0.2 + close.r * 0.6 + 0.3 * close.a, 0.0, 1.0));
#ifdef PUBLISHED
  coverage *= vLook.a;
#endif
  if (coverage < 0.02) discard;
  vec3 normal = normalize(vNormal + vec3((close.gb - 0.5) * 0.12, 0.0));
  vec3 toEye = normalize(uEye.xyz - vPosition);
  oColour = vec4(finish(snowColour(normal, toEye, vOpen.z, vOpen.y), vHaze), coverage);
#endif
}
