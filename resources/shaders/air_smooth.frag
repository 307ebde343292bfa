// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Evens out the pattern of the ray starts among pixels that show the scene at like distances, then haze and
// tone curve.
layout(binding = 7) uniform sampler2D uLook;
layout(binding = 8) uniform sampler2D uPlace;
uniform float uNatural;  // 0: the colours stand for values
layout(location = 0) out vec4 oLook;
layout(location = 1) out vec4 oPlace;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(uLook, 0) - 1;
  vec4 own = texelFetch(uPlace, at, 0), look = vec4(0.0);
  vec2 place = vec2(0.0);
  float weights = 0.0, clouds = 0.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      ivec2 beside = clamp(at + ivec2(x, y), ivec2(0), last);
      vec4 p = texelFetch(uPlace, beside, 0), l = texelFetch(uLook, beside, 0);
      float weight = float((2 - abs(x)) * (2 - abs(y))) * exp2(-12.0 * abs(p.x - own.x) / min(p.x, own.x));
      look += weight * l;
      weights += weight;
      float cloud = weight * (1.0 - l.a);
      place += cloud * p.yz;
      clouds += cloud;
    }
  look /= weights;
  place = clouds > 1e-5 ? place / clouds : own.yz;
  float share = 1.0 - look.a;
  if (uNatural > 0.5 && share > 1e-4) {
    vec2 screen = 4.0 * gl_FragCoord.xy / uViewport.xy - 1.0;
    vec3 ray = uForward.xyz + uForward.w * (screen.x * uRight.w * uRight.xyz + screen.y * cross(uRight.xyz, uForward.xyz));
    look.rgb = finish(look.rgb / share, hazeAt(uEye.xyz + min(place.x, 1e5) * ray)) * share;
  }
  oLook = look;
  oPlace = vec4(own.x, place, 0.0);
}
