// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Lays the cloud over the picture: of the four nearest pixels of its half-sized picture those that were
// marched to a like distance. And the cloud's shadow on what the picture shows.
in vec2 vScreen;
layout(binding = 7) uniform sampler2D uLook;
layout(binding = 8) uniform sampler2D uPlace;
layout(binding = 9) uniform sampler2D uDepth;
layout(binding = 10) uniform sampler3D uThrough;
uniform vec4 uShade;      // corner of the light's box, 1 if the cloud throws a shadow
uniform vec4 uShadeSize;  // its size, half a voxel
layout(location = 0, index = 0) out vec4 oColour;
layout(location = 0, index = 1) out vec4 oKept;  // share of what is behind

const float kFar = 1e6;

// Share of the light that the cloud leaves to a place; where the sun stands behind the box, what passes the
// whole of it.
float leftBy(vec3 p) {
  vec3 inverse = 1.0 / mix(uToSun.xyz, vec3(1e-5), lessThan(abs(uToSun.xyz), vec3(1e-5)));
  vec3 a = (uShade.xyz - p) * inverse, b = (uShade.xyz + uShadeSize.xyz - p) * inverse;
  vec3 low = min(a, b), high = max(a, b);
  float enter = max(max(low.x, max(low.y, low.z)), 0.0), leave = min(high.x, min(high.y, high.z));
  vec3 place = (p + enter * uToSun.xyz - uShade.xyz) / uShadeSize.xyz;
  float through = texture(uThrough, place).r;
  float share = dot(uSun.rgb, vec3(0.21, 0.72, 0.07)) * max(uToSun.z, 0.25);
  share /= share + dot(uSky.rgb, vec3(0.21, 0.72, 0.07)) + 1e-4;
  float lit = mix(1.0, texture(uTerrainLight, terrainUv(p.xy)).a, uTerrainGrid.w);
  return leave > enter && uToSun.z > 0.0 ? 1.0 - share * lit * (1.0 - through) : 1.0;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy), last = textureSize(uLook, 0) - 1;
  float depth = texelFetch(uDepth, pixel, 0).r;
  float scene = depth > 0.0 ? min(uViewProjection[3][2] / depth, kFar) : kFar;
  ivec2 corner = (pixel - 1) >> 1;
  vec2 part = 0.25 + 0.5 * vec2((pixel - 1) & 1);
  vec4 look = vec4(0.0);
  float weights = 0.0;
  for (int k = 0; k < 4; ++k) {
    ivec2 step = ivec2(k & 1, k >> 1);
    ivec2 at = clamp(corner + step, ivec2(0), last);
    vec2 near = mix(1.0 - part, part, vec2(step));
    float other = texelFetch(uPlace, at, 0).x;
    float weight = (near.x * near.y + 1e-3) * (exp2(-12.0 * abs(other - scene) / min(other, scene)) + 1e-6);
    look += weight * texelFetch(uLook, at, 0);
    weights += weight;
  }
  look /= weights;
  float shade = 1.0;
  if (uShade.w > 0.5 && depth > 0.0) {
    vec3 up = cross(uRight.xyz, uForward.xyz);
    shade = leftBy(uEye.xyz + scene * (uForward.xyz + uForward.w * (vScreen.x * uRight.w * uRight.xyz + vScreen.y * up)));
  }
  oColour = vec4(look.rgb, 1.0);
  oKept = vec4(vec3(look.a * shade), 1.0);
}
