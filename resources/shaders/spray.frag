// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
in vec2 vPlace;
flat in vec2 vBody;
flat in vec3 vWhere;
flat in vec3 vColour;
layout(binding = 7) uniform sampler2D uDepth;
layout(location = 0) out vec4 oSum;
layout(location = 1) out float oCover;

void main() {
  vec2 d = vec2(max(abs(vPlace.x) - vBody.x, 0.0), vPlace.y);
  float fall = 1.0 - dot(d, d);
  if (fall <= 0.0) discard;
  float depth = texelFetch(uDepth, ivec2(gl_FragCoord.xy), 0).r;
  float before = depth > 0.0 ? uViewProjection[3][2] / depth - vWhere.x : 1e6;
  // Into what stands there it sinks softly.
  float soft = clamp(before / vWhere.y + 0.5, 0.0, 1.0);
  // Drops come in clots; the mean of the square is about 1. Where there is much water its rim is torn by them.
  vec2 own = vWhere.z * vec2(7.1, 3.7);
  float clots = 2.0 * textureLod(uNoise, vec2(0.16, 0.45) * vPlace + own, 0.0).r;
  float torn = textureLod(uNoise, vec2(0.4, 0.9) * vPlace + own.yx, 0.0).r;
  float shape = clamp(1.25 * fall - (1.0 - torn), 0.0, 1.0);
  float cover = 1.0 - exp(-2.7 * vBody.y * shape * shape * clots * clots);
  cover *= soft * airKept(gl_FragCoord.xy / uViewport.xy, vWhere.x);
  if (cover < 0.002) discard;
  // Weight by distance in the manner of equation 8 of McGuire and Bavoil 2013; sums of halves bear no more.
  float z = vWhere.x / 30.0;
  float weight = cover * clamp(10.0 / (1e-5 + z * z * z), 1e-2, 30.0);
  oSum = vec4(vColour * cover, cover) * weight;
  oCover = cover;
}
