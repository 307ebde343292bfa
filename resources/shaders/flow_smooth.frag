// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Smooths distances along one axis. Neighbours far behind do not count; those far before count as if they stood
// a little before, so that edges keep their place and the rim of a near lump does not bleed.
layout(binding = 7) uniform sampler2D uDistance;
uniform vec4 uStep;   // axis, reach (m), most taps on a side
uniform vec4 uRange;  // counts behind (m), stands before (m), pixels that 1 m covers at 1 m, unused
layout(location = 0) out float oDistance;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float own = texelFetch(uDistance, at, 0).r;
  oDistance = own;
  if (own <= 0.0) return;
  float reach = clamp(uStep.z * uRange.z / own, 1.6, 24.0);
  int taps = int(min(ceil(reach), uStep.w));
  float stride = reach / float(taps);
  float sum = own, weights = 1.0;
  for (int k = 1; k <= taps; ++k) {
    ivec2 away = ivec2(round(uStep.xy * (stride * float(k))));
    float a = texelFetch(uDistance, at + away, 0).r, b = texelFetch(uDistance, at - away, 0).r;
    float share = float(k) / float(taps);
    // Both sides together or none: one alone would tilt the surface at rims.
    bool kept = a > 0.0 && b > 0.0 && a < own + uRange.x && b < own + uRange.x;
    float weight = kept ? exp(-2.0 * share * share) : 0.0;
    sum += weight * (max(a, own - uRange.y) + max(b, own - uRange.y));
    weights += 2.0 * weight;
  }
  oDistance = sum / weights;
}
