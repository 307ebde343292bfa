// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
in vec2 vScreen;
layout(location = 0) out vec4 oColour;

void main() {
  vec3 up = cross(uRight.xyz, uForward.xyz);
  vec3 ray = normalize(uForward.xyz + uForward.w * (vScreen.x * uRight.w * uRight.xyz + vScreen.y * up));
  vec3 colour = skyColour(ray);
  float cloud = uSun.w;
  if (ray.z > 0.0) {
    // A layer of cloud seen in perspective; the horizon keeps its haze.
    vec2 plane = ray.xy / (ray.z + 0.22);
    float shape = 0.6 * texture(uNoise, plane * 0.09).r + 0.4 * texture(uNoise, plane * 0.31 + 0.37).r;
    float share = smoothstep(0.62 - 0.40 * cloud, 0.80 - 0.34 * cloud, shape) * (1.0 - pow(1.0 - ray.z, 9.0));
    float body = 0.80 + 0.36 * texture(uNoise, plane * 0.17 + 0.71).r;
    vec3 lit = uSky.rgb * 0.72 + uSun.rgb * 0.16;
    colour = mix(colour, lit * body, share * min(1.2 * cloud, 0.95));
    float disc = smoothstep(0.99985, 0.99995, dot(ray, uToSun.xyz));
    colour += uSun.rgb * disc * (1.0 - share) * (1.0 - cloud) * 8.0;
  }
  oColour = vec4(shoulder(colour), 1.0);
}
