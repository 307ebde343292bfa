// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// The surface of a flow in the picture. Variant VALUES: coloured by the value of the nearest particle.
in vec2 vScreen;
layout(binding = 7) uniform sampler2D uDistance;   // smoothed, m
layout(binding = 8) uniform sampler2D uNormal;     // normal, openness
layout(binding = 9) uniform sampler2D uRaw;        // distance, place on the scale
layout(binding = 10) uniform sampler2D uThickness; // thickness (m), of it water, foam, loose
uniform vec4 uTarget;  // their pixels per pixel of the picture, margin, 1 / width, 1 / height
uniform vec4 uFlow;    // spacing (m), pixels that 1 m covers at 1 m (of theirs), unused
#ifdef VALUES
uniform vec4 uColours[9];
#endif
layout(location = 0, index = 0) out vec4 oColour;
layout(location = 0, index = 1) out vec4 oKept;  // share of what is behind

// Distance at a place between texels, without those of nothing and of what stands clearly behind; w: share of
// the four texels that hold something.
vec2 distanceAt(vec2 at) {
  vec2 corner = floor(at - 0.5), part = at - 0.5 - corner;
  vec4 weight = vec4((1.0 - part.x) * (1.0 - part.y), part.x * (1.0 - part.y), (1.0 - part.x) * part.y,
                     part.x * part.y);
  ivec2 c = ivec2(corner);
  vec4 d = vec4(texelFetch(uDistance, c, 0).r, texelFetch(uDistance, c + ivec2(1, 0), 0).r,
                texelFetch(uDistance, c + ivec2(0, 1), 0).r, texelFetch(uDistance, c + ivec2(1, 1), 0).r);
  vec4 there = vec4(greaterThan(d, vec4(0.0)));
  float covered = dot(weight, there);
  vec4 far = mix(vec4(1e9), d, there);
  float nearest = min(min(far.x, far.y), min(far.z, far.w));
  weight *= there * vec4(lessThan(far, vec4(nearest + 2.0 * uFlow.x)));
  return vec2(dot(weight, d) / max(dot(weight, vec4(1.0)), 1e-6), covered);
}

#ifndef VALUES
// What is broken lies rough: lumps shade each other and pores hold light, so it is darker than the smooth cover
// round it, the more where its lumps are too small to be seen (`fine` 0) and shade nothing in the picture.
float roughShade(vec2 along, float fine) {
  float lumps = texture(uNoise, along * (1.0 / 13.0)).r + texture(uNoise, along * (1.0 / 37.0)).g - 1.0;
  return mix(0.76, 0.92, fine) * (1.0 + mix(0.42, 0.14, fine) * lumps);
}

vec3 snowSurface(vec3 p, vec3 normal, float open, float loose, float fine, float sunlit, float skyOpen,
                 float distance) {
  vec2 along = p.xy + 0.73 * p.zz * vec2(1.0, -1.0);
  vec4 coarse = texture(uNoise, along * (1.0 / 5.3)), grain = texture(uNoise, along * (1.0 / 0.61));
  float nearness = 1.0 - smoothstep(25.0, 90.0, distance);
  vec2 lumps = texture(uNoise, along * (1.0 / 17.0)).gb - 0.5;
  vec2 wrinkle = (coarse.gb - 0.5) * 0.34 + (grain.gb - 0.5) * (0.42 * nearness) + lumps * mix(0.5, 0.2, nearness);
  vec3 n = normalize(normal + wrinkle.x * uRight.xyz + wrinkle.y * cross(uRight.xyz, uForward.xyz));
  float shade = (0.93 + 0.14 * (coarse.r - 0.5) + 0.2 * (grain.r - 0.5) * nearness) * mix(0.62, 1.0, open);
  shade *= roughShade(along, fine);
  vec3 toEye = normalize(uEye.xyz - p);
  vec3 colour = snowColour(n, toEye, sunlit * mix(0.7, 1.0, open), skyOpen * mix(0.55, 1.0, open)) * shade;
  return colour + snowSparkle(grain.a, n, toEye, distance, sunlit) * (1.0 - loose);
}

vec3 waterSurface(vec3 p, vec3 normal, float foam, float sunlit, float skyOpen, out vec3 reflectance) {
  vec3 toEye = normalize(uEye.xyz - p);
  vec2 ripple = texture(uNoise, p.xy * (1.0 / 1.7) + 0.37 * p.z).gb - 0.5;
  vec3 n = normalize(normal + vec3(0.16 * ripple, 0.0));
  float facing = clamp(dot(n, toEye), 0.0, 1.0), rim = 1.0 - facing, rim2 = rim * rim;
  float fresnel = 0.02 + 0.98 * rim2 * rim2 * rim;  // Schlick 1994, water in air
  vec3 mirrored = reflect(-toEye, n);
  mirrored.z = abs(mirrored.z);
  float lobe = pow(max(dot(n, normalize(uToSun.xyz + toEye)), 0.0), 260.0);
  reflectance = vec3(fresnel);
  return fresnel * skyColour(mirrored) * mix(0.45, 1.0, skyOpen) + uSun.rgb * (lobe * sunlit * 2.5);
}
#endif

void main() {
  vec2 at = gl_FragCoord.xy * uTarget.x + uTarget.y;
  vec2 found = distanceAt(at);
  if (found.y < 0.02) discard;
  float distance = found.x;
  vec3 up = cross(uRight.xyz, uForward.xyz);
  vec3 p = uEye.xyz + distance * (uForward.xyz + uForward.w * (vScreen.x * uRight.w * uRight.xyz + vScreen.y * up));
  gl_FragDepth = uViewProjection[3][2] / distance;
  vec4 surface = texture(uNormal, at * uTarget.zw);
  vec3 normal = normalize(surface.xyz + 1e-4 * uForward.xyz);
#ifdef VALUES
  float place = texelFetch(uRaw, ivec2(at), 0).g * 8.0;
  int stop = min(int(place), 7);
  vec3 colour = mix(uColours[stop].rgb, uColours[stop + 1].rgb, place - float(stop));
  float light = 0.70 + 0.30 * max(dot(normal, normalize(vec3(-0.42, -0.32, 0.85))), 0.0);
  oColour = vec4(colour * light * mix(0.8, 1.0, surface.w) * found.y, 1.0);
  oKept = vec4(1.0 - found.y);
#else
  vec4 thick = texture(uThickness, at * uTarget.zw);
  float all = max(thick.x, 1e-5);
  float water = clamp(thick.y / all, 0.0, 1.0), foam = clamp(thick.z / all, 0.0, 1.0);
  float loose = clamp(thick.w / all, 0.0, 1.0), open = surface.w;
  // Where a particle is smaller than a pixel the surface is that of the ground it flows on.
  vec4 light = texture(uTerrainLight, terrainUv(p.xy));
  vec2 tilt = light.xy * (255.0 / 127.0) - (128.0 / 127.0);
  vec3 ground = vec3(tilt, sqrt(max(1.0 - dot(tilt, tilt), 0.01)));
  float fine = smoothstep(0.35, 1.6, uFlow.x * uFlow.y / distance);
  normal = normalize(mix(mix(normal, ground, 0.6 * uTerrainGrid.w), normal, fine));
  // Drops and crumbs are too small to have a lit and a dark side.
  normal = normalize(mix(normal, vec3(0.0, 0.0, 1.0), (0.35 + 0.45 * water) * loose));
  float sunlit = modelShadow(p + uToSun.xyz * (1.6 * uFlow.x)) * mix(1.0, light.a, uTerrainGrid.w);
  float skyOpen = mix(1.0, light.z, uTerrainGrid.w);
  vec3 snow = snowSurface(p, normal, open, loose, fine, sunlit, skyOpen, distance);
  vec3 snowKept = vec3(exp(-2.2 * all / uFlow.x));
  vec3 reflectance;
  vec3 mirror = waterSurface(p, normal, foam, sunlit, skyOpen, reflectance);
  // Clear mountain water holds a little silt: what it takes from light per metre, and what it throws back.
  vec3 passed = exp(-all * vec3(1.1, 0.42, 0.36));
  vec3 body = vec3(0.07, 0.15, 0.16) * diffuseLight(normal, sunlit, skyOpen) * (1.0 - passed);
  vec2 streak = p.xy + p.zz * vec2(0.9, -0.6);
  float bubbles = texture(uNoise, streak * (1.0 / 2.9)).r + texture(uNoise, streak * (1.0 / 0.7)).r - 1.0;
  // What falls is drawn out into strands, which go down with it.
  float steep = 1.0 - smoothstep(0.25, 0.7, abs(normal.z));
  float fallen = p.z + 12.0 * uBounce.w;
  vec2 strand = vec2(dot(p.xy, vec2(0.62, 0.79)), 0.14 * fallen);
  float strands = texture(uNoise, strand * (1.0 / 1.3)).r + texture(uNoise, strand * (1.0 / 0.37) + 0.4).g - 1.0;
  bubbles = mix(bubbles, 1.3 * strands, 0.75 * steep);
  vec3 froth = vec3(0.80, 0.85, 0.88) * diffuseLight(normal, sunlit, skyOpen * mix(0.6, 1.0, open));
  froth *= (0.95 + 0.4 * bubbles) * mix(0.72, 1.0, open);
  // Foam covers by patches; spray thins out towards its rims.
  float white = smoothstep(0.22, 0.8, foam + 0.55 * bubbles) * (1.0 - exp(-mix(2.2, 1.1, loose) * all / uFlow.x));
  float film = 1.0 - loose * exp(-2.0 * all / uFlow.x);
  vec3 wet = film * (1.0 - white) * (mirror + body * (1.0 - reflectance)) + white * froth;
  vec3 wetKept = mix(vec3(1.0), (1.0 - reflectance) * passed, film) * (1.0 - white);
  vec3 colour = mix(snow, wet, water);
  vec3 kept = mix(snowKept, wetKept, water);
  vec4 haze = hazeAt(p);
  // The snow's own light is weighted by its opacity; the water's parts are so already.
  colour *= mix(1.0 - snowKept, vec3(1.0), water);
  vec3 hazed = shoulder(colour * haze.w + haze.rgb * (1.0 - kept));
  oColour = vec4(hazed * found.y, 1.0);
  oKept = vec4(mix(vec3(1.0), kept, found.y), 1.0);
#endif
}
