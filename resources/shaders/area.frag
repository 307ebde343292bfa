// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
in float vShare;
layout(location = 0) out vec4 oColour;

void main() {
  oColour = vec4(0.95, 0.36, 0.05, 0.38 * smoothstep(0.3, 0.7, vShare));
}
