// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/view_uniforms.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/nodes/settings_nodes.h"
#include "core/physics/snow_visibility.h"
#include "core/sim/scene_time.h"
#include "core/snow/snow_weather.h"

namespace spin {
namespace {

struct Basis {
  Vec3d right, up, forward;
};

Basis lookAlong(Vec3d direction) {
  const Vec3d f = length(direction) > 0.0 ? normalized(direction) : Vec3d{0, 1, 0};
  const Vec3d side = cross(f, Vec3d{0, 0, 1});
  const Vec3d right = length(side) > 1e-6 ? normalized(side) : Vec3d{1, 0, 0};
  return {right, cross(right, f), f};
}

Vec3d mix(Vec3d a, Vec3d b, double t) {
  return a * (1.0 - t) + b * t;
}

double luminance(Vec3d c) {
  return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}

/// Colour of direct sunlight after its way through the air: Beer's law with the optical depths of a clean
/// mountain atmosphere at 610, 550 and 465 nm (Rayleigh 0.064, 0.097, 0.19 and a little aerosol).
Vec3d sunTransmittance(double sinElevation) {
  const double mass = 1.0 / (std::max(sinElevation, 0.0) + 0.05);
  return {std::exp(-0.09 * mass), std::exp(-0.125 * mass), std::exp(-0.22 * mass)};
}

}  // namespace

Matrix4 viewProjection(const RenderCamera& camera, double aspect, double nearPlane) {
  const Basis b = lookAlong(camera.target - camera.position);
  const double f = 1.0 / std::tan(0.5 * degreesToRadians(camera.fovDegrees));
  const Vec3d x = b.right * (f / aspect), y = b.up * f, p = camera.position;
  // Clip: (x.q, y.q, near, forward.q) for q = point - eye; z/w = near / distance (reversed, infinite).
  const auto value = [](double v) { return static_cast<float>(v); };
  Matrix4 m{};
  for (int c = 0; c < 3; ++c) {
    m[static_cast<std::size_t>(c * 4)] = value(x[c]);
    m[static_cast<std::size_t>(c * 4 + 1)] = value(y[c]);
    m[static_cast<std::size_t>(c * 4 + 3)] = value(b.forward[c]);
  }
  m[12] = value(-dot(x, p));
  m[13] = value(-dot(y, p));
  m[14] = value(nearPlane);
  m[15] = value(-dot(b.forward, p));
  return m;
}

Matrix4 lightMatrix(Vec3d centre, Vec3d toLight, double halfSize, double depthRange, int texels) {
  const Basis b = lookAlong(-toLight);
  double cx = dot(b.right, centre), cy = dot(b.up, centre), cz = dot(b.forward, centre);
  if (texels > 0) {
    // Sixteen texels at a time: the map is drawn again only when the camera has gone that far.
    const double unit = 16.0 * 2.0 * halfSize / texels;
    cx = std::round(cx / unit) * unit;
    cy = std::round(cy / unit) * unit;
    cz = std::round(cz / unit) * unit;
  }
  Matrix4 m{};
  const auto row = [&](int r, Vec3d axis, double scale, double offset) {
    for (int c = 0; c < 3; ++c) m[static_cast<std::size_t>(c * 4 + r)] = static_cast<float>(axis[c] * scale);
    m[static_cast<std::size_t>(12 + r)] = static_cast<float>(offset);
  };
  row(0, b.right, 1.0 / halfSize, -cx / halfSize);
  row(1, b.up, 1.0 / halfSize, -cy / halfSize);
  row(2, b.forward, 0.5 / depthRange, 0.5 - 0.5 * cz / depthRange);
  m[15] = 1.0f;
  return m;
}

double readableHaze(double extinction, double distance) {
  constexpr double kMaxDepth = 0.7;
  const double depth = extinction * distance;
  return depth > kMaxDepth ? kMaxDepth / depth : 1.0;
}

LightModel lightModel(const SceneSnapshot& scene, double filmTime, double snowShare) {
  const auto weather = scene.settings<WeatherNode>(filmTime);
  const auto picture = scene.settings<RenderNode>(filmTime);
  LightModel m;
  m.cloud = std::clamp(weather.cloudCover, 0.0, 1.0);
  m.toSun = picturedSun(scene, filmTime);
  const double up = std::max(m.toSun.z, 0.0);
  const double dusk = std::clamp(m.toSun.z * 8.0 + 0.9, 0.02, 1.0);
  // Direct light falls off with the clouds' share, the total as 1 - 0.75 N^3.4 (Kasten and Czeplak 1980).
  const Vec3d beam = m.toSun.z > 0.0 ? sunTransmittance(up) * (1.0 - m.cloud) : Vec3d{};
  const double total = (0.25 + 0.75 * up) * (1.0 - 0.75 * std::pow(m.cloud, 3.4));
  const Vec3d clearSky = Vec3d{0.42, 0.62, 1.0} * (0.22 * dusk);
  const Vec3d greySky = Vec3d{0.88, 0.95, 1.05} * (0.95 * dusk * total);
  const Vec3d sky = mix(clearSky, greySky, m.cloud * (0.4 + 0.6 * m.cloud));
  const double level = luminance(beam) * up + luminance(sky);
  // A photographer's exposure: level snow comes out bright, dim weather stays a little darker.
  const double gain = 0.90 * std::pow(std::max(level, 1e-4), -0.88) * std::exp2(picture.exposure);
  m.sun = beam * gain;
  m.sky = sky * gain;
  m.bounce = (beam * up + sky) * (gain * (0.12 + 0.55 * snowShare));
  const Vec3d clearZenith = Vec3d{0.16, 0.33, 0.72} * (0.55 * dusk * gain);
  const Vec3d clearHorizon =
      mix(Vec3d{0.62, 0.74, 0.9}, Vec3d{0.95, 0.72, 0.5}, 0.5 * std::exp(-6.0 * up)) * (0.62 * dusk * gain);
  m.zenith = mix(clearZenith, sky * (0.62 * gain), m.cloud);
  m.horizon = mix(clearHorizon, sky * (0.80 * gain), m.cloud);
  // Clean mountain air: 80 km of sight. Falling snow adds the share that the picture settings ask for.
  double falling = 0.0;
  if (scene.first<SnowfallNode>())
    falling =
        picture.snowfallHaze * snowExtinction(snowWeatherAt(scene, filmTime).spectrum.massConcentration);
  m.hazeExtinction = 3.912 / 80e3 + falling;
  return m;
}

}  // namespace spin
