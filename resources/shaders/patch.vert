// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Snow on a model: a cover patch in the node's axes, raised by its own thickness, lit per vertex.
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec4 aSnow;  // thickness (m), normal
uniform vec4 uOffset;
out vec3 vPosition;
out vec3 vNormal;
out vec3 vOpen;  // thickness, share of the sky, of the sun
out vec4 vHaze;

void main() {
  vPosition = aPosition + uOffset.xyz + vec3(0.0, 0.0, aSnow.x);
  vNormal = aSnow.yzw;
  vOpen.x = aSnow.x;
  vOpen.y = mix(0.35, 1.0, zenithVisibility(vPosition + vec3(0.0, 0.0, 0.3)));
  vOpen.z = sunVisibility(vPosition + vNormal * 0.08);
  vHaze = hazeAt(vPosition);
  gl_Position = uViewProjection * vec4(vPosition, 1.0);
}
