// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
in vec3 vPosition;
in vec3 vNormal;
in vec2 vUv;
layout(binding = 7) uniform sampler2D uTexture;
uniform vec4 uBaseColour;
uniform vec4 uSurface;    // textured, alpha cut-out, double-sided, roughness
uniform vec4 uHighlight;  // colour and strength
layout(location = 0) out vec4 oColour;

void main() {
  vec4 base = uBaseColour;
  if (uSurface.x > 0.5) base *= texture(uTexture, vUv);
  if (uSurface.y > 0.5) {
    // Mip levels thin out cut-outs; raising alpha with the level keeps their area.
    float alpha = base.a * (1.0 + 0.25 * max(textureQueryLod(uTexture, vUv).x, 0.0));
    if (alpha < 0.5) discard;
  }
  vec3 toEye = normalize(uEye.xyz - vPosition);
  vec3 normal = normalize(vNormal);
  if (uSurface.z > 0.5 && dot(normal, toEye) < 0.0) normal = -normal;
  float sunlit = sunVisibility(vPosition + normal * 0.03);
  float skyOpen = mix(0.35, 1.0, zenithVisibility(vPosition + normal * 0.25));
  vec3 colour = base.rgb * diffuseLight(normal, sunlit, skyOpen);
  float gloss = 1.0 - uSurface.w;
  if (gloss > 0.05) {
    float lobe = pow(max(dot(normal, normalize(uToSun.xyz + toEye)), 0.0), 8.0 + 120.0 * gloss * gloss);
    float rim = pow(1.0 - max(dot(normal, toEye), 0.0), 5.0);
    colour += gloss * (uSun.rgb * (sunlit * lobe * 0.5) + skyColour(reflect(-toEye, normal)) * (0.04 + 0.5 * rim));
  }
  colour = mix(colour, uHighlight.rgb, uHighlight.a * (0.35 + 0.65 * pow(1.0 - abs(dot(normal, toEye)), 2.0)));
  oColour = vec4(finish(colour, vPosition), 1.0);
}
