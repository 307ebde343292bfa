// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Models into a shadow map; the light's matrix stands in for the view.
layout(location = 0) in vec3 aPosition;
layout(location = 2) in vec2 aUv;
uniform mat4 uLightModel;
out vec2 vUv;

void main() {
  vUv = aUv;
  gl_Position = uLightModel * vec4(aPosition, 1.0);
}
