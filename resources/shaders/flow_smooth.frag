// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Smooths distances along one axis. Going outwards, a side ends where the next distance leaps behind the last
// one; a leap before counts as a small step only, so that edges keep their place and the rim of a near lump
// does not bleed. Slopes are followed, however steep.
layout(binding = 7) uniform sampler2D uDistance;
uniform vec4 uStep;   // axis, reach (m), most taps on a side
uniform vec4 uRange;  // leap that ends a side (m), step before (m), pixels that 1 m covers at 1 m, unused
layout(location = 0) out float oDistance;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float own = texelFetch(uDistance, at, 0).r;
  oDistance = own;
  if (own <= 0.0) return;
  float reach = clamp(uStep.z * uRange.z / own, 2.4, 24.0);
  int taps = int(min(ceil(reach), uStep.w));
  float stride = reach / float(taps);
  float slope = 3.0 * stride * own / uRange.z;
  float ahead = own, behind = own, sum = own, weights = 1.0;
  for (int k = 1; k <= taps; ++k) {
    ivec2 away = ivec2(round(uStep.xy * (stride * float(k))));
    float a = texelFetch(uDistance, at + away, 0).r, b = texelFetch(uDistance, at - away, 0).r;
    // Both sides together or none: one alone would tilt the surface at rims.
    if (a <= 0.0 || b <= 0.0 || a > ahead + uRange.x + slope || b > behind + uRange.x + slope) break;
    ahead = max(a, ahead - uRange.y - slope);
    behind = max(b, behind - uRange.y - slope);
    float share = float(k) / float(taps);
    float weight = exp(-2.0 * share * share);
    sum += weight * (ahead + behind);
    weights += 2.0 * weight;
  }
  oDistance = sum / weights;
}
