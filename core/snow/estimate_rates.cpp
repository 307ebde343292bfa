// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/math/sampling.h"
#include "core/snow/domain_faces.h"
#include "core/snow/exposure_field.h"

namespace spin {
namespace {

constexpr std::size_t kSamples =
    65536;  ///< per face, set of exits or model; a power of two keeps the net even
constexpr std::size_t kChunk = 1024;

enum class Sink { Ground, Models, Left, Lost };

struct Estimate {
  const SceneSnapshot& snapshot;
  const SnowGround& ground;
  const SnowScene& scene;
  const ExposureSettings& settings;
  const Workshop& workshop;
  std::vector<std::array<std::uint32_t, 4>> points = sobolPoints(kSamples);
  std::array<DomainSide, 4> sides = domainSides(scene);

  UInt4 shiftOf(std::uint32_t stream) const {
    return CounterRandom{settings.seed, 0x72617465u}.words(stream);
  }
  Vec3d directionOf(std::size_t i, const UInt4& shift) const {
    return settings.cone.direction(shifted(points[i][2], shift.z), shifted(points[i][3], shift.w));
  }
};

/// Flow that reaches a set of surfaces: mean over samples of visibility x make's weight. make(i, u, v, w)
/// gives the point, the unit normal of the side in question and the weight, m2.
struct Exit {
  Vec3d point{}, side{0, 0, 1};
  double weight = 0.0;
};
template <class Make>
double gatherFlow(const Estimate& e, std::uint32_t stream, const Make& make) {
  const UInt4 shift = e.shiftOf(stream);
  std::vector<double> partial((kSamples + kChunk - 1) / kChunk, 0.0);
  e.workshop.backend.forChunks(
      "mass budget", kSamples, kChunk, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        if (e.workshop.cancel.cancelled()) return;
        std::array<Ray, kChunk> rays;
        std::array<double, kChunk> weights;
        std::array<std::uint8_t, kChunk> blocked;
        std::size_t count = 0;
        for (std::size_t i = begin; i < end; ++i) {
          const Vec3d w = e.directionOf(i, shift);
          const Exit exit = make(shifted(e.points[i][0], shift.x), shifted(e.points[i][1], shift.y), w);
          if (exit.weight <= 0.0) continue;
          rays[count] = e.scene.towardsSky(exit.point, exit.side, w);
          weights[count++] = exit.weight;
        }
        e.scene.rays->occludedMany(rays.data(), count, blocked.data());
        for (std::size_t k = 0; k < count; ++k)
          if (!blocked[k]) partial[chunk] += weights[k];
      });
  double sum = 0.0;
  for (const double p : partial) sum += p;
  return sum / static_cast<double>(kSamples);
}

// --- what leaves, gathered -------------------------------------------------------------------------------

double gatherSides(const Estimate& e) {
  double sum = 0.0;
  for (std::uint32_t s = 0; s < e.sides.size(); ++s) {
    const DomainSide& side = e.sides[s];
    sum += gatherFlow(e, 10 + s, [&](double u, double v, Vec3d w) {
      const double out = -levelFluxFactor(side.outward(), w);
      return out > 0.0 ? Exit{side.at(u, v), -side.outward(), out * side.area()} : Exit{};
    });
  }
  return sum;
}

double gatherFloor(const Estimate& e) {
  const Vec3d low = e.scene.domain.min, size = e.scene.domain.size();
  return gatherFlow(e, 20, [&](double u, double v, Vec3d) {
    return Exit{{low.x + u * size.x, low.y + v * size.y, e.scene.level}, {0, 0, 1}, size.x * size.y};
  });
}

double gatherSkirts(const Estimate& e) {
  std::vector<const SkirtEdge*> edges;
  std::vector<double> areaToHere;
  double total = 0.0;
  const auto height = [&](const SkirtEdge& k) { return 0.5 * (k.from.z + k.to.z) - e.scene.level; };
  for (const SkirtEdge& edge : e.scene.skirts) {
    if (edge.onBorder) continue;
    edges.push_back(&edge);
    areaToHere.push_back(total +=
                         length(Vec3d{edge.to.x - edge.from.x, edge.to.y - edge.from.y, 0}) * height(edge));
  }
  if (edges.empty()) return 0.0;
  return gatherFlow(e, 21, [&](double u, double v, Vec3d w) {
    const auto found = std::upper_bound(areaToHere.begin(), areaToHere.end(), u * total);
    const auto k = std::min(static_cast<std::size_t>(found - areaToHere.begin()), edges.size() - 1);
    const SkirtEdge& edge = *edges[k];
    const double factor = levelFluxFactor(edge.outward, w);
    if (factor <= 0.0) return Exit{};
    const double before = k == 0 ? 0.0 : areaToHere[k - 1];
    const double t = (u * total - before) / (areaToHere[k] - before);
    // Uniform along the edge; the column's height against the mean one corrects the weight.
    const Vec3d top = edge.from + (edge.to - edge.from) * t;
    const double column = top.z - e.scene.level;
    const Vec3d p{top.x, top.y, e.scene.level + v * column};
    return Exit{p, edge.outward, factor * total * column / height(edge)};
  });
}

// --- what bare parts of models shed, gathered
// ---------------------------------------------------------------

double gatherBare(const Estimate& e, std::size_t m) {
  const StandingModel& model = e.scene.models[m];
  const std::vector<BareTriangle>& bare = e.ground.models[m].bare;
  std::vector<double> areaToHere;
  double total = 0.0;
  for (const BareTriangle& b : bare)
    areaToHere.push_back(total += 0.5 * length(model.triangles[b.triangle].normal()));
  if (!(total > 0.0)) return 0.0;
  return gatherFlow(e, 100 + static_cast<std::uint32_t>(m), [&](double u, double v, Vec3d w) {
    const auto found = std::upper_bound(areaToHere.begin(), areaToHere.end(), u * total);
    const auto k = std::min(static_cast<std::size_t>(found - areaToHere.begin()), bare.size() - 1);
    const double before = k == 0 ? 0.0 : areaToHere[k - 1];
    const double rest = std::clamp((u * total - before) / (areaToHere[k] - before), 0.0, 1.0);
    const PlacedTriangle& triangle = model.triangles[bare[k].triangle];
    const double root = std::sqrt(rest);
    const auto corner = [&](std::size_t c) { return triangle.corners[c].to<double>(); };
    const Vec3d p = corner(0) * (1.0 - root) + corner(1) * (root * (1.0 - v)) + corner(2) * (root * v);
    // Of the two sides only the one that faces the snow can be reached by it, and never the inner one.
    const Vec3d n = normalized(triangle.normal());
    const double factor = levelFluxFactor(n, w);
    if (factor * bare[k].outward < 0.0) return Exit{};
    return Exit{p + model.placement.translation, factor >= 0.0 ? n : -n, std::abs(factor) * total};
  });
}

// --- forward packets
// -----------------------------------------------------------------------------------------

/// Where a packet that hits nothing crosses the domain's boundary, and whether it may leave there: not
/// through the ground.
Sink leavingSink(const Estimate& e, Vec3d from, Vec3d w) {
  const Box3d& box = e.scene.domain;
  double t = (e.scene.level - from.z) / w.z;
  int axisOut = 2;
  for (int axis = 0; axis < 2; ++axis) {
    if (w[axis] == 0.0) continue;
    const double reach = ((w[axis] > 0.0 ? box.max : box.min)[axis] - from[axis]) / w[axis];
    if (reach < t) t = reach, axisOut = axis;
  }
  const Vec3d p = from + w * t;
  if (!e.scene.hasTerrain) return Sink::Left;
  const double tolerance = e.scene.tolerance;
  if (axisOut == 2) {
    const auto z = TerrainSurface(e.snapshot.terrain->heights).heightAt(p.x, p.y);
    return z && *z > p.z + tolerance ? Sink::Lost : Sink::Left;
  }
  const std::size_t side = static_cast<std::size_t>(2 * axisOut + (w[axisOut] > 0.0 ? 1 : 0));
  return p.z < e.sides[side].lowerEdge(p[1 - axisOut]) - tolerance ? Sink::Lost : Sink::Left;
}

Sink sinkOf(const Estimate& e, Vec3d from, Vec3d w) {
  const SnowScene& scene = e.scene;
  const auto hit = scene.rays->closest(
      {(from - scene.centre).to<float>(), w.to<float>(), 0.0f, std::numeric_limits<float>::infinity()});
  if (!hit) return leavingSink(e, from, w);
  if (!scene.hasTerrain) return Sink::Models;
  if (hit->geometry == scene.skirtGeometry)
    return dot(scene.skirts[hit->triangle / 2].outward, w) > 0.0 ? Sink::Lost : Sink::Left;
  if (hit->geometry != scene.terrainGeometry) return Sink::Models;
  // A packet that met the surface from below was under it just before.
  const Raster<float>& heights = e.snapshot.terrain->heights;
  const double t = static_cast<double>(hit->t);
  const Vec3d before = from + w * (t - std::min(t, 0.25 * heights.cellSize));
  const auto z = TerrainSurface(heights).heightAt(before.x, before.y);
  return z && before.z < *z - scene.tolerance ? Sink::Lost : Sink::Ground;
}

struct FaceFlow {
  SinkRates sinks;
  double lost = 0.0;
  double emitted = 0.0;

  void add(const FaceFlow& o) {
    sinks.ground += o.sinks.ground, sinks.models += o.sinks.models, sinks.left += o.sinks.left;
    lost += o.lost, emitted += o.emitted;
  }
};

/// Packets from one face; at(u, v) is a point of it, inward its unit normal into the domain. What enters is
/// area x mean inflow of the directions; where each packet ends is found apart from that.
template <class At>
FaceFlow sendPackets(const Estimate& e, std::uint32_t stream, Vec3d inward, double area, const At& at) {
  const UInt4 shift = e.shiftOf(stream);
  std::vector<FaceFlow> partial((kSamples + kChunk - 1) / kChunk);
  double inflow = 0.0;
  for (std::size_t i = 0; i < kSamples; ++i)
    inflow += std::max(0.0, -levelFluxFactor(inward, e.directionOf(i, shift)));
  e.workshop.backend.forChunks(
      "mass budget", kSamples, kChunk, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        if (e.workshop.cancel.cancelled()) return;
        FaceFlow& flow = partial[chunk];
        for (std::size_t i = begin; i < end; ++i) {
          const Vec3d w = e.directionOf(i, shift);
          const double weight = -levelFluxFactor(inward, w) * area / static_cast<double>(kSamples);
          if (weight <= 0.0) continue;
          const Vec3d from = at(shifted(e.points[i][0], shift.x), shifted(e.points[i][1], shift.y));
          switch (sinkOf(e, from, w)) {
            case Sink::Ground:
              flow.sinks.ground += weight;
              break;
            case Sink::Models:
              flow.sinks.models += weight;
              break;
            case Sink::Left:
              flow.sinks.left += weight;
              break;
            case Sink::Lost:
              flow.lost += weight;
              break;
          }
        }
      });
  FaceFlow total;
  for (const FaceFlow& flow : partial) total.add(flow);
  total.emitted = area * inflow / static_cast<double>(kSamples);
  return total;
}

FaceFlow sendAllPackets(const Estimate& e) {
  const Box3d& box = e.scene.domain;
  const Vec3d size = box.size();
  FaceFlow total = sendPackets(e, 1, {0, 0, -1}, size.x * size.y, [&](double u, double v) {
    return Vec3d{box.min.x + u * size.x, box.min.y + v * size.y, box.max.z};
  });
  for (std::uint32_t s = 0; s < e.sides.size(); ++s) {
    const DomainSide& side = e.sides[s];
    total.add(sendPackets(e, 2 + s, -side.outward(), side.area(),
                          [&](double u, double v) { return side.at(u, v); }));
  }
  return total;
}

}  // namespace

Status estimateRates(const SceneSnapshot& snapshot, const SnowGround& ground, const SnowScene& scene,
                     const ExposureSettings& settings, const Workshop& workshop, SnowRates& rates) {
  if (scene.domain.empty()) return {};
  const Estimate e{snapshot, ground, scene, settings, workshop};
  const FaceFlow packets = sendAllPackets(e);
  rates.emitted = packets.emitted;
  rates.forward = packets.sinks;
  rates.lost = packets.lost;
  rates.left = gatherSides(e) + gatherFloor(e) + gatherSkirts(e);
  rates.gathered.left = rates.left;
  for (std::size_t m = 0; m < scene.models.size(); ++m) {
    const double bare = gatherBare(e, m);
    rates.shed += bare;
    rates.gathered.models += bare;
  }
  return workshop.cancel.cancelled() ? Status(cancelledError()) : Status();
}

}  // namespace spin
