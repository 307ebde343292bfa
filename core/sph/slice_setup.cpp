// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sph/slice_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/physics/kernels.h"

namespace spin {
namespace {

/// Memory for cells is bounded: 2^28 bins are 1 GiB.
constexpr double kMaxBins = 268435456.0;
constexpr double kBinsPerCell = 1 << (kCellBits - kBinBits);

Error badConfig(const char* property, std::string why) {
  return badInput("The particle solver cannot start", property, std::move(why));
}

double cellsAlong(const SphSliceConfig& c, int axis) {
  return (c.domainMax[axis] - c.domainMin[axis]) / c.support();
}

/// Rounding must not make a box of exactly n cells one larger.
std::int32_t wholeCells(double cells) {
  return std::max(1, static_cast<std::int32_t>(std::ceil(cells - 1e-6)));
}

Status checkAxis(const SphSliceConfig& c, int axis, bool periodic) {
  const double cells = cellsAlong(c, axis);
  if (!(cells > 0.0)) return badConfig("domainMax", "the box is empty");
  if (cells > kMaxCells)
    return badConfig("domainMax",
                     fmt::format("{:.0f} cells along an axis, at most {} fit", cells, kMaxCells));
  if (periodic && (cells < 2.5 || std::abs(cells - std::round(cells)) > 1e-6))
    return badConfig("domainMax",
                     fmt::format("a periodic axis must be 3 or more whole supports long, this is {}", cells));
  return {};
}

/// Position in units, NaN-safe: what is not within the limit fails.
bool toUnits(double metres, double support, std::int32_t& units) {
  const double cells = metres / support;
  if (!(std::abs(cells) <= kMaxCells)) return false;
  units = static_cast<std::int32_t>(std::min(std::lround(cells * kCellUnits), 0x3fffffffL));
  return true;
}

std::int32_t wrapUnits(std::int32_t units, std::int32_t cells, bool periodic) {
  if (!periodic) return units;
  const std::int32_t period = cells << kCellBits;
  const std::int32_t rest = units % period;
  return rest < 0 ? rest + period : rest;
}

}  // namespace

double SphSliceConfig::stableTimeStep() const {
  const double acoustic = 0.25 * spacing / soundSpeed;
  const double viscous = viscosity > 0.0 ? 0.1 * spacing * spacing * restDensity / viscosity : acoustic;
  return std::min(acoustic, viscous);
}

Status checkSliceConfig(const SphSliceConfig& c) {
  const auto positive = [](double v) { return std::isfinite(v) && v > 0.0; };
  if (!positive(c.spacing)) return badConfig("spacing", "it must be above 0");
  if (!positive(c.restDensity)) return badConfig("restDensity", "it must be above 0");
  if (!positive(c.soundSpeed)) return badConfig("soundSpeed", "it must be above 0");
  if (!(std::isfinite(c.viscosity) && c.viscosity >= 0.0))
    return badConfig("viscosity", "it must not be below 0");
  if (!std::isfinite(c.gravity)) return badConfig("gravity", "it must be finite");
  const bool periodic[] = {c.periodicX, c.periodicY, false};
  double bins = kBinsPerCell;
  for (int axis = 0; axis < 3; ++axis) {
    if (const Status ok = checkAxis(c, axis, periodic[axis]); !ok) return ok;
    bins *= wholeCells(cellsAlong(c, axis));
  }
  if (bins > kMaxBins)
    return Error{ErrorKind::OutOfResources, "The particle solver cannot start", "domainMax",
                 fmt::format("the box has {:.3g} bins, at most {:.3g} are allowed", bins, kMaxBins),
                 "Make the box smaller or the spacing larger"};
  return {};
}

SliceGrid sliceGrid(const SphSliceConfig& c) {
  return {wholeCells(cellsAlong(c, 0)), wholeCells(cellsAlong(c, 1)), wholeCells(cellsAlong(c, 2)),
          c.periodicX, c.periodicY};
}

SliceConstants sliceConstants(const SphSliceConfig& c) {
  const double h = c.support();
  const double massNorm = c.particleMass() * CubicSpline::kNorm;
  SliceConstants k;
  k.densityFactor = static_cast<float>(massNorm / (c.restDensity * h * h * h));
  k.pressureFactor = static_cast<float>(massNorm / (h * h * h * h));
  k.viscosityFactor = static_cast<float>(2.0 * c.viscosity * massNorm / (h * h * h * h * h));
  k.restDensity = static_cast<float>(c.restDensity);
  k.soundSpeed = static_cast<float>(c.soundSpeed);
  k.gravity = static_cast<float>(c.gravity);
  k.support = static_cast<float>(h);
  k.unitsPerMetre = static_cast<float>(kCellUnits / h);
  k.floor = c.floor;
  k.clampTension = c.clampTension;
  return k;
}

std::size_t sliceBinCount(const SliceGrid& grid) {
  return static_cast<std::size_t>(grid.rows()) * static_cast<std::size_t>(grid.binsX());
}

Result<SliceHostState> sliceHostState(const SphSliceConfig& c, const std::vector<Vec3d>& positions,
                                      const std::vector<Vec3d>& velocities) {
  const std::size_t n = positions.size();
  constexpr const char* kWhat = "The particles cannot be used";
  if (n > INT32_MAX) return badInput(kWhat, {}, "there are more than 2^31");
  if (!velocities.empty() && velocities.size() != n)
    return badInput(kWhat, {}, fmt::format("{} positions but {} velocities", n, velocities.size()));
  const SliceGrid grid = sliceGrid(c);
  SliceHostState s;
  for (auto* axis : {&s.x, &s.y, &s.z}) axis->resize(n + kPairPadding);
  s.records.resize(n + kPairPadding);
  s.ids.resize(n + kPairPadding);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3d p = positions[i] - c.domainMin;
    const Vec3d v = velocities.empty() ? Vec3d{} : velocities[i];
    if (!toUnits(p.x, c.support(), s.x[i]) || !toUnits(p.y, c.support(), s.y[i]) ||
        !toUnits(p.z, c.support(), s.z[i]) || !isFinite(v))
      return badInput(kWhat, fmt::format("particle {}", i),
                      "a position or velocity is not finite or far outside");
    s.x[i] = wrapUnits(s.x[i], grid.cellsX, grid.periodicX);
    s.y[i] = wrapUnits(s.y[i], grid.cellsY, grid.periodicY);
    const Vec3f f = v.to<float>();
    s.records[i] = {f.x, f.y, f.z, 0.0f, 0.0f};
    s.ids[i] = static_cast<std::uint32_t>(i);
  }
  return s;
}

SphParticle sliceParticle(const SphSliceConfig& c, const SliceHostState& state, std::size_t i, float excess) {
  const double unit = c.support() / kCellUnits;
  const PairRecord& r = state.records[i];
  SphParticle p;
  p.position = c.domainMin + Vec3d{state.x[i] * unit, state.y[i] * unit, state.z[i] * unit};
  p.velocity = Vec3f{r.vx, r.vy, r.vz}.to<double>();
  p.density = c.restDensity * (1.0 + static_cast<double>(excess));
  return p;
}

}  // namespace spin
