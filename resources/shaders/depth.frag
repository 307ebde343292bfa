// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
in vec2 vUv;
layout(binding = 7) uniform sampler2D uTexture;
uniform float uCutout;

void main() {
  if (uCutout > 0.5 && texture(uTexture, vUv).a < 0.5) discard;
}
