// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
in vec2 vPlace;
flat in vec2 vStreak;
flat in vec3 vFrames;
flat in float vOpacity;
flat in int vSamples;
flat in float vSwarm;
#ifdef AIR_KEPT
flat in float vDistance;
#endif
uniform int uShapeCount;
layout(binding = 7) uniform sampler2DArray uShapes;
layout(location = 0) out vec4 oColour;

// What a picture that is looked up so blurred shows at a place: its smallest levels fill the whole square, so
// they are drawn as a soft disc of the same cover (2.17 times 0.46 of the square).
float rounded(vec2 place, vec2 dx, vec2 dy) {
  float texels = float(textureSize(uShapes, 0).x) * sqrt(max(dot(dx, dx), dot(dy, dy)));
  float blur = clamp((log2(max(texels, 1.0)) - 1.0) / 3.0, 0.0, 1.0);
  return mix(1.0, 2.17 * (1.0 - smoothstep(0.25, 0.5, length(place))), blur);
}

// Cover of the flake at a place in widths from its centre. The rim of a picture is clear. Gradients come from
// outside: a place that jumps with the sample would have none.
float coverAt(vec2 place, vec2 dx, vec2 dy) {
  if (uShapeCount == 0) return max(1.0 - 4.0 * dot(place, place), 0.0);
  // The smallest pictures of a flake have no clear rim.
  if (max(abs(place.x), abs(place.y)) > 0.5) return 0.0;
  vec2 uv = place + 0.5;
  float one = textureGrad(uShapes, vec3(uv, vFrames.x), dx, dy).r;
  if (vSamples == 0) return one;
  return mix(one, textureGrad(uShapes, vec3(uv, vFrames.y), dx, dy).r, vFrames.z) * rounded(place, dx, dy);
}

const float kFrames = 18.0;  // of a flake, as in flake.vert

vec4 hash4(vec2 cell) {
  vec4 h = fract(vec4(cell.xyxy + vSwarm * 91.7) * vec4(0.1031, 0.1030, 0.0973, 0.1099));
  h += dot(h, h.wzxy + 33.33);
  return fract((h.xxyz + h.yzzw) * h.zywx);
}

// Cover of nine flakes of different size, turn and shape in three rows, none of which leaves its cell.
float swarmAt(vec2 place, vec2 dx, vec2 dy) {
  vec2 q = 3.0 * place + 1.5, cell = floor(q);
  if (any(lessThan(cell, vec2(0.0))) || any(greaterThan(cell, vec2(2.0)))) return 0.0;
  vec4 h = hash4(cell), more = hash4(cell + 7.0);
  float scale = 3.0 / mix(0.45, 0.72, h.z), angle = 6.2831853 * h.w, c = cos(angle), s = sin(angle);
  mat2 turn = scale * mat2(c, s, -s, c);
  vec2 at = turn * (q - cell - 0.5 - 0.26 * (h.xy - 0.5)) / 3.0;
  if (max(abs(at.x), abs(at.y)) > 0.5) return 0.0;
  float shape = min(floor(more.x * float(uShapeCount)), float(uShapeCount) - 1.0);
  float layer = kFrames * shape + mod(vFrames.x + floor(kFrames * more.y), kFrames);
  vec2 du = turn * dx, dv = turn * dy;
  return textureGrad(uShapes, vec3(at + 0.5, layer), du, dv).r * rounded(at, du, dv);
}

void main() {
  vec2 dx = dFdx(vPlace), dy = dFdy(vPlace);
  float cover = vSamples < 0 ? 1.0 : 0.0;
  int samples = max(vSamples, 1);
  // Few samples along a long way would show as a comb: each is as blurred as its part of the way is long.
  vec2 part = 0.7 * vStreak / float(samples);
  if (dot(part, part) > dot(dx, dx)) dx = part;
  for (int k = 0; k < samples && vSamples >= 0; ++k) {
    vec2 place = vPlace - vStreak * ((float(k) + 0.5) / float(samples) - 0.5);
    cover += vSwarm < 0.0 ? coverAt(place, dx, dy) : swarmAt(place, dx, dy);
  }
  vec3 colour = uSun.rgb * 0.45 + uSky.rgb * 0.62 + uBounce.rgb * 0.35;
  oColour = vec4(shoulder(colour), vOpacity * cover / float(samples));
#ifdef AIR_KEPT
  oColour.a *= airKept(gl_FragCoord.xy / uViewport.xy, vDistance);
#endif
}
