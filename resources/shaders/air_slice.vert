// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// A plane through the air.
uniform vec4 uCorner;
uniform vec4 uAlong;
uniform vec4 uUp;
out vec2 vPlace;

void main() {
  vPlace = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = uViewProjection * vec4(uCorner.xyz + vPlace.x * uAlong.xyz + vPlace.y * uUp.xyz, 1.0);
}
