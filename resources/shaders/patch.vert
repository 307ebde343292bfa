// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Snow on a model: a cover patch in the node's axes, raised by its own thickness, lit per vertex. With distance
// it sinks to the model's own surface and is only a colour blended over it, C = f_p C_snow + (1 - f_p) C_object.
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec4 aSnow;  // thickness (m), normal
uniform vec4 uOffset;  // w = lift, m
uniform vec4 uSink;    // distances, m, from and to which it sinks; height, m at 1 m distance, at which it is kept
#if defined(VALUES) || defined(PUBLISHED)
layout(location = 2) in vec4 aLook;
out vec4 vLook;
#endif
out vec3 vPosition;
out vec3 vNormal;
out vec3 vOpen;  // thickness, share of the sky, of the sun
out vec4 vHaze;

void main() {
  float distance = length(aPosition + uOffset.xyz - uEye.xyz);
  float raised = aSnow.x * (1.0 - smoothstep(uSink.x, uSink.y, distance));
  raised = max(raised, min(aSnow.x, uSink.z * distance));
  vPosition = aPosition + uOffset.xyz + vec3(0.0, 0.0, raised + uOffset.w);
  vNormal = aSnow.yzw;
#if defined(VALUES) || defined(PUBLISHED)
  vLook = aLook;
#endif
  vOpen.x = aSnow.x;
  vOpen.y = mix(0.35, 1.0, zenithVisibility(vPosition + vec3(0.0, 0.0, 0.3)));
  vOpen.z = sunVisibility(vPosition + vNormal * 0.08);
  vHaze = hazeAt(vPosition);
  gl_Position = uViewProjection * vec4(vPosition, 1.0);
}
