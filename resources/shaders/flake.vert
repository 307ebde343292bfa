// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Falling flakes as sprites. Each hides what the real flakes that it stands for hide: first by its size, and
// where that is below a pixel or its picture covers too much, by its opacity.
layout(std430, binding = 0) readonly buffer Records { float values[]; };  // arrays in FlakeValue's order
uniform int uCount;      // sprites
uniform int uShapeCount; // flakes in the atlas, 0 = none
uniform vec4 uLook;      // exposure time (s), smallest width (px), cover of a flake, of its picture
uniform vec4 uSizeLaw;   // A, B, C of S_final = h S / sqrt(A + B D + C D^2)
out vec2 vPlace;            // in widths of the sprite, from its centre
flat out vec2 vStreak;      // motion during the exposure, in widths
flat out vec3 vFrames;      // two layers of the atlas and the share of the second
flat out float vOpacity;
flat out int vSamples;      // along the motion; 0: the sprite itself is drawn out, -1: and even all over
flat out float vSwarm;      // of a swarm: which one, 0..1; < 0: a single flake
#ifdef AIR_KEPT
flat out float vDistance;   // before the eye, m
#endif

const int kFrames = 18;        // of a flake, as core/flake/flake_atlas.h has them
const float kBlurred = 6.0;    // px, width from which a sprite's shape is blurred along its motion
const float kShaped = 3.0;     // px, width from which it has a shape
const float kLongestStreak = 400.0;
const float kSwarmWeight = 4.0; // real flakes from which a sprite shows a swarm of nine small ones
// A swarm's width over that of the one flake that would hide as much, and the width of its flakes over that.
// Nine flakes of 0.45 to 0.72 of a cell hide 9 * 0.35 cells.
const float kSwarmWidth = 1.69, kSwarmFlake = 0.33;

float value(int which, int k) { return values[which * uCount + k]; }

void hide() {
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  vPlace = vStreak = vec2(0.0);
  vFrames = vec3(0.0);
  vOpacity = 0.0;
  vSamples = 0;
  vSwarm = -1.0;
}

vec4 clipOf(vec3 fromEye) {
  vec4 clip = uViewProjection * vec4(fromEye, 0.0);
  clip.z = uViewProjection[3].z;
  return clip;
}

void main() {
  int k = gl_VertexID >> 2;
  vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
  hide();
  vec3 p = vec3(value(0, k), value(1, k), value(2, k)), v = vec3(value(3, k), value(4, k), value(5, k));
  float diameter = value(6, k), weight = value(7, k), character = value(9, k);
  vec4 clip = clipOf(p);
#ifdef AIR_KEPT
  vDistance = clip.w;
#endif
  if (clip.w < 0.03) return;

  vec2 halfScreen = 0.5 * uViewport.xy;
  float d = clip.w;
  float size = uViewport.y * diameter * inversesqrt(uSizeLaw.x + uSizeLaw.y * d + uSizeLaw.z * d * d);
  float wanted = weight * size * size * uLook.z;  // cover in px^2, over pi/4
  float opaque = min(uLook.z / uLook.w, 1.0);     // of a flake drawn at its true size
  float width = max(sqrt(wanted / (uLook.w * opaque)), uLook.y);
  vOpacity = min(wanted / (uLook.w * width * width), 1.0) * value(8, k);
  // What fills the picture is out of focus in any camera.
  vOpacity *= 1.0 - smoothstep(0.12, 0.3, width / uViewport.y);
  if (vOpacity < 0.0007) {
    hide();
    return;
  }

  bool swarm = weight >= kSwarmWeight && width >= kShaped && uShapeCount > 0;
  float flake = swarm ? kSwarmFlake * width : width;
  if (swarm) width *= kSwarmWidth;
  vSwarm = swarm ? character : -1.0;

  vec4 end = clipOf(p + v * uLook.x);
  vec2 streak = end.w > 0.01 ? (end.xy / end.w - clip.xy / clip.w) * halfScreen : vec2(0.0);
  float drawn = min(length(streak), kLongestStreak);
  vec2 along = drawn > 0.01 ? normalize(streak) : vec2(1.0, 0.0), across = vec2(-along.y, along.x);
  float longer = 0.5 * (width + drawn);
  bool blurred = swarm || width >= kBlurred;
  if (!blurred) vOpacity *= width / (width + drawn);
  // Blurred, the sprite also holds the corners of a turned picture.
  vec2 extent = blurred ? vec2(longer + 0.21 * width, 0.71 * width) : vec2(longer, 0.5 * width);
  vec2 offset = along * (corner.x * extent.x) + across * (corner.y * extent.y);
  gl_Position = vec4(clip.xy + (offset + 0.5 * drawn * along) / halfScreen * clip.w, min(clip.z, clip.w), clip.w);

  // Each flake is turned by an angle of its own besides what its frames show.
  float angle = 6.2831853 * fract(character * 57.31), c = cos(angle), s = sin(angle);
  mat2 turn = mat2(c, s, -s, c);
  int steps = int((swarm ? 2.0 : 5.0) * drawn / flake) + 1;
  vSamples = blurred ? clamp(steps, 1, swarm ? 5 : 32) : width < kShaped ? -1 : 0;
  // A square that hides what the circle in it would.
  if (vSamples < 0) vOpacity *= 0.785 * uLook.w;
  vPlace = blurred ? turn * offset / width : 0.5 * corner;
  vStreak = blurred ? turn * along * (drawn / width) : vec2(0.0);
  float frame = fract(value(10, k)) * float(kFrames), first = floor(frame);
  float shape = min(floor(character * float(uShapeCount)), float(uShapeCount) - 1.0) * float(kFrames);
  vFrames = vec3(shape + mod(first, float(kFrames)), shape + mod(first + 1.0, float(kFrames)), frame - first);
}
