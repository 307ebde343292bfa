// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// One triangle over the picture, at the far end of the depth range.
out vec2 vScreen;

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  vScreen = corner;
  gl_Position = vec4(corner, 0.0, 1.0);
}
