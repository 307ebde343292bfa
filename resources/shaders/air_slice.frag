// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// The values on a plane as colours; clear where there are none.
in vec2 vPlace;
layout(binding = 7) uniform sampler2D uValues;  // place on the scale times presence, presence
uniform vec4 uColours[9];
layout(location = 0) out vec4 oColour;

void main() {
  vec2 value = texture(uValues, vPlace).rg;
  if (value.g < 0.5) discard;
  float stops = clamp(value.r / value.g, 0.0, 1.0) * 8.0;
  int lower = min(int(stops), 7);
  oColour = vec4(mix(uColours[lower].rgb, uColours[lower + 1].rgb, stops - float(lower)), 0.92);
}
