// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/flow_reading.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "core/fields/terrain_surface.h"
#include "editor/render/flow_scale.h"

namespace spin {
namespace {

/// Of spacings: half the diagonal of a square of particles, so that no ray slips through a layer.
constexpr double kReach = 0.75;
constexpr double kPixels = 2.0;

std::optional<std::size_t> particleAt(const ParticleSet& set, const ViewFrame& view, Vec2d pixel,
                                      double spacing) {
  const ViewRay ray = view.ray(pixel);
  const Vec3d along = normalized(ray.direction);
  const double perMetre = view.metresPerPixel(ray.origin + view.forward());
  std::optional<std::size_t> found;
  double nearest = 1e300;
  for (std::size_t k = 0; k < set.positions.size(); ++k) {
    const Vec3d to = set.positions[k].to<double>() - ray.origin;
    const double t = dot(to, along);
    if (t <= 0.0 || t >= nearest) continue;
    const double reach = std::max(kReach * spacing, kPixels * perMetre * t);
    if (dot(to, to) - t * t > reach * reach) continue;
    nearest = t;
    found = k;
  }
  return found;
}

double valueOf(const ParticleSet& set, FlowDisplay shows, std::size_t particle) {
  return static_cast<double>(flowValue(set, shows, particle).value_or(0.0f));
}

QString number(double value) {
  // Three figures, but no powers: 0.00 m/s is at rest, 12400 Pa is pressed.
  const double size = std::abs(value);
  return QLocale().toString(value, 'f', size < 10.0 ? 2 : size < 100.0 ? 1 : 0);
}

QString say(const char* text) {
  return QCoreApplication::translate("FlowReading", text);
}

}  // namespace

std::optional<FlowReading> readFlow(const SceneSnapshot& scene, const Frame* frame, double filmTime,
                                    const ViewFrame& view, Vec2d pixel) {
  const auto* flow = frame ? frame->part<ParticlePart>("flow") : nullptr;
  if (!flow) return std::nullopt;
  const auto told = frame->info.figures.find("flow_spacing_m");
  const double spacing = told != frame->info.figures.end() ? told->second : 0.0;
  const ParticleSet& set = flow->particles;
  const auto particle = particleAt(set, view, pixel, spacing);
  if (!particle) return std::nullopt;
  FlowReading reading;
  reading.point = set.positions[*particle].to<double>();
  reading.speed = valueOf(set, FlowDisplay::Speed, *particle);
  reading.density = valueOf(set, FlowDisplay::Density, *particle);
  reading.shows = scene.settings<RenderNode>(filmTime).flowDisplay;
  reading.value = valueOf(set, reading.shows, *particle);
  const Vec3d& p = reading.point;
  std::optional<double> ground = 0.0;
  if (scene.terrain) ground = TerrainSurface(scene.terrain->heights).heightAt(p.x, p.y);
  if (ground) reading.high = std::max(p.z + 0.5 * spacing - *ground, 0.0);
  return reading;
}

QString readingText(const FlowReading& reading) {
  QStringList parts;
  parts << say(QT_TRANSLATE_NOOP("FlowReading", "Flow %1 m/s")).arg(number(reading.speed));
  if (reading.high)
    parts << say(QT_TRANSLATE_NOOP("FlowReading", "%1 m above the ground"))
                 .arg(QLocale().toString(*reading.high, 'f', 2));
  parts << QStringLiteral("%1 kg/m\u00b3").arg(QLocale().toString(reading.density, 'f', 0));
  const bool told = reading.shows == FlowDisplay::Material || reading.shows == FlowDisplay::Speed ||
                    reading.shows == FlowDisplay::Density;
  if (told) return parts.join(QStringLiteral("  \u00b7  "));
  const char* label = kFlowDisplayChoices[static_cast<std::size_t>(reading.shows)].label;
  QString value = number(reading.value);
  const auto kind = static_cast<std::size_t>(std::max(reading.value, 0.0));
  if (reading.shows == FlowDisplay::ParticleClass && kind < kFlowClassLabels.size())
    value = QCoreApplication::translate("Properties", kFlowClassLabels[kind]);
  const QString unit = QString::fromUtf8(flowUnit(reading.shows));
  parts << QStringLiteral("%1 %2 %3")
               .arg(QCoreApplication::translate("Properties", label), value, unit)
               .trimmed();
  return parts.join(QStringLiteral("  \u00b7  "));
}

}  // namespace spin
