// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in vec2 aUv;
uniform mat4 uModel;
uniform mat4 uNormalMatrix;
out vec3 vPosition;
out vec3 vNormal;
out vec2 vUv;
out vec2 vOpen;  // share of the sky, of the sun
out vec4 vHaze;

void main() {
  vPosition = (uModel * vec4(aPosition, 1.0)).xyz;
  vNormal = normalize(mat3(uNormalMatrix) * aNormal);
  vUv = aUv;
  vOpen.x = mix(0.35, 1.0, zenithVisibility(vPosition + vNormal * 0.25));
#ifdef CUTOUT
  vOpen.y = sunVisibility(vPosition + vNormal * 0.2);
#else
  vOpen.y = texture(uTerrainLight, terrainUv(vPosition.xy)).a;
#endif
  vHaze = hazeAt(vPosition);
  gl_Position = uViewProjection * vec4(vPosition, 1.0);
}
