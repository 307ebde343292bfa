// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// What a ray meets of mist and powder on its way to the scene: a picture of half the size. Variant VALUES: the
// colours stand for values. Distances are those before the eye, along its forward axis.
layout(binding = 7) uniform sampler2D uDepth;    // of the whole picture
layout(binding = 8) uniform usampler3D uIndex;   // 1 + slot of a block
layout(binding = 9) uniform sampler3D uDensity;  // extinction, 1/m; place times presence, presence
#ifdef VALUES
uniform vec4 uColours[9];
uniform vec4 uValue;       // extinction where presence is 1, 1/m
#else
layout(binding = 10) uniform sampler3D uLight;  // scattered more than once and from all sides; share of the sun
uniform vec4 uPhase;       // mean cosine of the peak, of the rest, its alpha, its share
uniform vec4 uLightShift;  // from cells to places in uLight
uniform vec4 uLightScale;
uniform vec4 uBehind;      // colour of an open cloud by sky and ground alone; share that is scattered ahead
#endif
uniform vec4 uAir;         // corner of block 0 seen from the eye, in cells; cells per m
uniform ivec4 uBlocks;     // along x, y, z
uniform ivec4 uSlots;      // of the texture along x, y
uniform vec4 uTexel;       // 1 / texels of the texture
uniform vec4 uMarch;       // longest step in cells, shortest, longest for far ones, size of a pixel at 1 m
layout(location = 0) out vec4 oLook;
layout(location = 1) out vec4 oPlace;

const float kSide = 16.0, kPadded = 18.0;
const int kMostSteps = 1024;
const float kFar = 1e6;
// As bright as the sun's own disc is drawn; the peak of diffraction is narrower than that.
const float kBrightest = 8.0;

float least(vec3 v) { return min(v.x, min(v.y, v.z)); }
float most(vec3 v) { return max(v.x, max(v.y, v.z)); }

#ifndef VALUES
// Phase function of Draine 2003 times pi.
float lobe(float g, float alpha, float cosine) {
  float d = 1.0 + g * g - 2.0 * g * cosine;
  return 0.25 * (1.0 - g * g) * (1.0 + alpha * cosine * cosine) /
         ((1.0 + alpha * (1.0 + 2.0 * g * g) / 3.0) * d * sqrt(d));
}

// The sun's light on its way into the eye. Deflected many times by little on its way here, it comes from a
// wider range: the mean cosine falls by exp(-t), t the optical depth times (1 - mean cosine).
vec3 lightAt(vec3 cell, float cosine) {
  vec4 light = texture(uLight, cell * uLightScale.xyz + uLightShift.xyz);
  float through = clamp(light.a, 0.0, 1.0);
  float narrow = exp(-(1.0 / max(through, 1e-3) - 1.0) * (4.0 / 3.0));
  float bright = mix(lobe(uPhase.x * narrow, 0.0, cosine), lobe(uPhase.y * narrow, uPhase.z * narrow, cosine), uPhase.w);
  return light.rgb + uSun.rgb * (through * min(bright, kBrightest));
}
#endif

// Distance of the scene. Of four pixels the nearest or the farthest in turns, so that both are at hand where
// they differ.
float sceneDistance(ivec2 spot) {
  ivec2 at = 2 * spot, last = textureSize(uDepth, 0) - 1;
  vec4 d = vec4(texelFetch(uDepth, min(at, last), 0).r, texelFetch(uDepth, min(at + ivec2(1, 0), last), 0).r,
                texelFetch(uDepth, min(at + ivec2(0, 1), last), 0).r, texelFetch(uDepth, min(at + 1, last), 0).r);
  float near = max(max(d.x, d.y), max(d.z, d.w)), far = min(min(d.x, d.y), min(d.z, d.w));
  float chosen = ((spot.x + spot.y) & 1) == 0 ? near : far;
  return chosen > 0.0 ? min(uViewProjection[3][2] / chosen, kFar) : kFar;
}

void main() {
  ivec2 spot = ivec2(gl_FragCoord.xy);
  float scene = sceneDistance(spot);
  vec2 screen = 4.0 * gl_FragCoord.xy / uViewport.xy - 1.0;
  vec3 ray = uForward.xyz + uForward.w * (screen.x * uRight.w * uRight.xyz + screen.y * cross(uRight.xyz, uForward.xyz));
  float metres = length(ray);  // per unit of distance
  vec3 way = ray * uAir.w, eye = -uAir.xyz;
  way = mix(way, vec3(1e-5), lessThan(abs(way), vec3(1e-5)));
  vec3 inverse = 1.0 / way;
  vec3 sideA = -eye * inverse, sideB = (vec3(uBlocks.xyz) * kSide - eye) * inverse;
  float unit = 1.0 / (uAir.w * metres);  // distance per cell
  float at = max(most(min(sideA, sideB)), 0.11), end = min(least(max(sideA, sideB)), scene);
  float start = at, leave = at, width = 0.0, kept = 1.0;
  // Four starts that differ by a quarter of a step; smoothing over a few pixels then sees steps of a quarter.
  float jitter = 0.125 + 0.25 * float((spot.x & 1) == 0 ? 2 * (spot.y & 1) : 3 - 2 * (spot.y & 1));
  bool filled = false;
  vec3 shift = vec3(0.0), colour = vec3(0.0);
  vec2 moments = vec2(0.0);
#ifndef VALUES
  float cosine = clamp(dot(ray, uToSun.xyz) / metres, -1.0, 1.0);
#endif
  for (int k = 0; k < kMostSteps && at < end && kept > 0.004; ++k) {
    float longest = unit * clamp(uMarch.w * at * uAir.w, uMarch.x, uMarch.z * uMarch.x);
    if (at >= leave) {
      ivec3 block = clamp(ivec3(floor((eye + way * (at + 0.01 * unit)) / kSide)), ivec3(0), uBlocks.xyz - 1);
      vec3 sides = ((vec3(block) + step(vec3(0.0), way)) * kSide - eye) * inverse;
      leave = max(least(sides), at + 0.02 * unit);
      int slot = int(texelFetch(uIndex, block, 0).r) - 1;
      filled = slot >= 0;
      ivec3 place = ivec3(slot % uSlots.x, (slot / uSlots.x) % uSlots.y, slot / (uSlots.x * uSlots.y));
      shift = vec3(place) * kPadded + 1.0 - vec3(block) * kSide;
      width = jitter * longest;
    }
    if (!filled) {
      at = leave;
      continue;
    }
    float stop = min(min(at + width, leave), end);
    float middle = 0.5 * (at + stop);
    vec3 cell = eye + way * middle;
    vec3 texel = (cell + shift) * uTexel.xyz;
#ifdef VALUES
    vec2 value = texture(uDensity, texel).rg;
    float depth = uValue.x * value.g * (stop - at) * metres;
    float stops = clamp(value.r / max(value.g, 1e-5), 0.0, 1.0) * 8.0;
    int lower = min(int(stops), 7);
    vec3 own = mix(uColours[lower].rgb, uColours[lower + 1].rgb, stops - float(lower));
#else
    float depth = texture(uDensity, texel).r * (stop - at) * metres;
    // Into what is dense in small steps.
    if (depth > 0.7 && stop - at > 1.01 * uMarch.y * unit) {
      width = max((stop - at) * max(0.25, 0.5 / depth), uMarch.y * unit);
      continue;
    }
    vec3 own = depth > 1e-6 ? lightAt(cell, cosine) : vec3(0.0);
#endif
    float passed = exp(-depth), weight = kept * (1.0 - passed), far = middle - start;
    colour += weight * own;
    moments += weight * vec2(far, far * far);
    kept *= passed;
    width = min(longest, 2.0 * max(stop - at, uMarch.y * unit));
    at = stop;
  }
  // What is left of an opaque cloud counts as all of it.
  float whole = kept <= 0.004 ? 0.0 : kept;
  colour *= (1.0 - whole) / max(1.0 - kept, 1e-6);
#ifndef VALUES
  // Drops scatter ahead: thin mist before the bright sky is as bright as that, not as the mean of all sides
  // (scaled as J. H. Joseph, W. J. Wiscombe, J. A. Weinman 1976).
  if (scene >= kFar) {
    float direct = max(kept, 1e-3);
    colour += max(pow(direct, 1.0 - uBehind.w) - direct, 0.0) * (skyColour(ray / metres) - uBehind.rgb);
  }
#endif
  vec2 mean = moments / max(1.0 - kept, 1e-6);
  oLook = vec4(colour, whole);
  oPlace = vec4(scene, kept < 1.0 ? start + mean.x : kFar, sqrt(max(mean.y - mean.x * mean.x, 0.0)), 0.0);
}
