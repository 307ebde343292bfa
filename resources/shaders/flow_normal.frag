// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Normals of the smooth surface, and how open it lies among what stands before it.
layout(binding = 7) uniform sampler2D uDistance;
uniform vec4 uTarget;  // width, height of the picture in these pixels, margin, unused
uniform vec4 uRange;   // size of a lump (m), pixels that 1 m covers at 1 m, unused
layout(location = 0) out vec4 oNormal;

vec3 pointAt(ivec2 at, float distance) {
  vec2 screen = (vec2(at) + 0.5 - uTarget.z) / uTarget.xy * 2.0 - 1.0;
  vec3 up = cross(uRight.xyz, uForward.xyz);
  return distance * (uForward.xyz + uForward.w * (screen.x * uRight.w * uRight.xyz + screen.y * up));
}

// The step to the neighbour at the side where the surface goes on.
vec3 stepAlong(ivec2 at, ivec2 axis, float own, vec3 here) {
  float ahead = texelFetch(uDistance, at + axis, 0).r, behind = texelFetch(uDistance, at - axis, 0).r;
  bool hasAhead = ahead > 0.0, hasBehind = behind > 0.0;
  bool forward = hasAhead && (!hasBehind || abs(ahead - own) < abs(behind - own));
  if (forward) return pointAt(at + axis, ahead) - here;
  return here - pointAt(at - axis, hasBehind ? behind : own);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float own = texelFetch(uDistance, at, 0).r;
  oNormal = vec4(0.0);
  if (own <= 0.0) return;
  vec3 here = pointAt(at, own);
  vec3 normal = normalize(cross(stepAlong(at, ivec2(1, 0), own, here), stepAlong(at, ivec2(0, 1), own, here)));
  float hidden = 0.0;
  float reach = clamp(uRange.x * uRange.y / own, 2.0, 24.0);
  for (int k = 0; k < 8; ++k) {
    float angle = 0.785 * float(k) + 0.3;
    ivec2 away = ivec2(round(reach * (k % 2 == 0 ? 1.0 : 0.55) * vec2(cos(angle), sin(angle))));
    float other = texelFetch(uDistance, at + away, 0).r;
    vec3 to = pointAt(at + away, other) - here;
    float rise = dot(to, normal) / max(length(to), 1e-4);
    hidden += other > 0.0 ? clamp(rise - 0.08, 0.0, 0.7) * (1.0 - smoothstep(2.0, 5.0, length(to) / uRange.x)) : 0.0;
  }
  oNormal = vec4(normal, 1.0 - min(hidden / 3.4, 0.8));
}
