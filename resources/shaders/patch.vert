// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Snow on a model: a cover patch in the node's axes, raised by its own thickness.
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec4 aSnow;  // thickness (m), normal
uniform vec4 uOffset;
out vec3 vPosition;
out vec3 vNormal;
out float vThickness;

void main() {
  vThickness = aSnow.x;
  vNormal = aSnow.yzw;
  vPosition = aPosition + uOffset.xyz + vec3(0.0, 0.0, aSnow.x);
  gl_Position = uViewProjection * vec4(vPosition, 1.0);
}
