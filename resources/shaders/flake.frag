// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
in vec2 vPlace;
flat in vec2 vStreak;
flat in vec3 vFrames;
flat in float vOpacity;
flat in int vSamples;
uniform int uShapeCount;
layout(binding = 7) uniform sampler2DArray uShapes;
layout(location = 0) out vec4 oColour;

// Cover of the flake at a place in widths from its centre. The rim of a picture is clear. Gradients come from
// outside: a place that jumps with the sample would have none.
float coverAt(vec2 place, vec2 dx, vec2 dy) {
  if (uShapeCount == 0) return max(1.0 - 4.0 * dot(place, place), 0.0);
  vec2 uv = place + 0.5;
  float one = textureGrad(uShapes, vec3(uv, vFrames.x), dx, dy).r;
  if (vSamples == 0) return one;
  return mix(one, textureGrad(uShapes, vec3(uv, vFrames.y), dx, dy).r, vFrames.z);
}

void main() {
  vec2 dx = dFdx(vPlace), dy = dFdy(vPlace);
  float cover = vSamples < 0 ? 1.0 : 0.0;
  int samples = max(vSamples, 1);
  for (int k = 0; k < samples && vSamples >= 0; ++k)
    cover += coverAt(vPlace - vStreak * ((float(k) + 0.5) / float(samples) - 0.5), dx, dy);
  vec3 colour = uSun.rgb * 0.45 + uSky.rgb * 0.62 + uBounce.rgb * 0.35;
  oColour = vec4(shoulder(colour), vOpacity * cover / float(samples));
}
