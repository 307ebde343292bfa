// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
in vec3 vShape;
in float vOpacity;
layout(binding = 7) uniform sampler2DArray uShapes;
layout(location = 0) out vec4 oColour;

void main() {
  float alpha = vOpacity * min(texture(uShapes, vShape).r * 1.5, 1.0);
  vec3 colour = uSun.rgb * 0.45 + uSky.rgb * 0.62 + uBounce.rgb * 0.35;
  oColour = vec4(shoulder(colour), alpha);
}
