// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/bench/worst.h"
#include "core/nodes/terrain_node.h"
#include "core/snow/snow_slides.h"

namespace spin {
namespace {

constexpr double kAngle = 38.0;   ///< degrees, of repose
constexpr double kExtent = 60.0;  ///< m, side of the land
constexpr int kPours = 100;

/// A square of land with heights z(x, y) by the place relative to its middle.
template <class Z>
SnowGround landOf(int cells, const Z& z) {
  auto layout = std::make_shared<CoverLayout>();
  const double cell = kExtent / cells, first = 0.5 * (cell - kExtent);
  CoverGrid grid{"terrain", "terrain", Raster<float>(cells, cells, first, first, cell), {}};
  grid.area = grid.base.sameShape<float>(static_cast<float>(cell * cell));
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i)
      grid.base.at(i, j) = static_cast<float>(z(grid.base.x(i), grid.base.y(j)));
  layout->grids.push_back(std::move(grid));
  SnowGround ground;
  ground.layout = std::move(layout);
  ground.terrain.push_back({0, 0, 0, 0});
  return ground;
}

/// Snow poured in small lots onto the middle, (0, 0), of a ground of one grid.
class Heap {
 public:
  Heap(const SnowGround& ground, int threads)
      : depth(ground.layout->grids[0].base.sameShape<double>(0.0)),
        m_backend(threads),
        m_area(ground.layout->grids[0].area),
        m_slides(std::make_shared<const CoverGraph>(makeCoverGraph(ground, nullptr))),
        m_tangents(depth.size(), static_cast<float>(std::tan(degreesToRadians(kAngle)))) {}

  /// Over the cells within `radius` of the middle.
  void pour(double volume, double radius) {
    std::vector<std::size_t> place;
    double area = 0.0;
    for (std::size_t c = 0; c < depth.size(); ++c) {
      if (fromMiddle(c) > radius) continue;
      place.push_back(c);
      area += static_cast<double>(m_area.values[c]);
    }
    for (int lot = 0; lot < kPours; ++lot) {
      for (const std::size_t c : place) depth.values[c] += volume / kPours / area;
      SlideTotals totals;
      do {
        totals = m_slides.settle({depth.values.data()}, m_tangents.data(), {}, m_backend);
        fell += totals.left[0];
      } while (totals.unsettled > 0);
    }
  }

  double fromMiddle(std::size_t cell) const {
    const int i = static_cast<int>(cell) % depth.width, j = static_cast<int>(cell) / depth.width;
    return std::hypot(depth.x(i), depth.y(j));
  }
  double volume() const {
    double sum = 0.0;
    for (std::size_t c = 0; c < depth.size(); ++c)
      sum += depth.values[c] * static_cast<double>(m_area.values[c]);
    return sum;
  }
  /// Area with snow deeper than that, m2.
  double footprint(double deeper) const {
    const auto cells =
        std::count_if(depth.values.begin(), depth.values.end(), [&](double d) { return d > deeper; });
    return static_cast<double>(cells) * depth.cellSize * depth.cellSize;
  }
  double deepest() const { return *std::max_element(depth.values.begin(), depth.values.end()); }
  double steepestDegrees() const {
    double steepest = 0.0;
    for (std::uint32_t c = 0; c < depth.size(); ++c)
      if (depth.values[c] > 1e-3) steepest = worse(steepest, m_slides.steepness(depth.values.data(), c));
    return radiansToDegrees(std::atan(steepest));
  }
  /// How far from the middle the snow is `level` deep, in a direction, m.
  double reach(double direction, double level) const {
    const auto at = [&](double r) {
      const double u = (r * std::cos(direction) - depth.originX) / depth.cellSize,
                   v = (r * std::sin(direction) - depth.originY) / depth.cellSize;
      const int i = std::clamp(static_cast<int>(u), 0, depth.width - 2),
                j = std::clamp(static_cast<int>(v), 0, depth.height - 2);
      const double fu = u - i, fv = v - j;
      return (1 - fv) * ((1 - fu) * depth.at(i, j) + fu * depth.at(i + 1, j)) +
             fv * ((1 - fu) * depth.at(i, j + 1) + fu * depth.at(i + 1, j + 1));
    };
    double r = 0.0;
    while (r < 0.5 * kExtent && at(r) > level) r += 0.01 * depth.cellSize;
    return r;
  }

  Raster<double> depth;  ///< m
  double fell = 0.0;     ///< m3 that left the ground

 private:
  CpuBackend m_backend;
  Raster<float> m_area;
  SnowSlides m_slides;
  std::vector<float> m_tangents;
};

/// A heap on level ground: V = pi R^3 tan(phi)/3, the same in all directions.
BenchRow cone(const BenchOptions& options, int cells) {
  BenchRow row;
  row.caseId = "repose";
  row.settings = {{"shape", "cone"}, {"cells_along", std::to_string(cells)}};
  const BenchMeter meter;
  Heap heap(landOf(cells, [](double, double) { return 0.0; }), options.threads);
  constexpr double kVolume = 4000.0;
  heap.pour(kVolume, 1.0);
  const double tangent = std::tan(degreesToRadians(kAngle));
  const double radius = std::cbrt(3.0 * kVolume / (kPi * tangent)), height = radius * tangent;
  const double level = 0.1 * height;
  double least = kExtent, most = 0.0, mean = 0.0;
  constexpr int kDirections = 72;
  for (int d = 0; d < kDirections; ++d) {
    const double r = heap.reach(2.0 * kPi * d / kDirections, level);
    least = std::min(least, r), most = std::max(most, r), mean += r / kDirections;
  }
  // The top is a cell's mean.
  row.addError("height_error_in_cells", std::abs(heap.deepest() - height) / (tangent * heap.depth.cellSize),
               "1", 1.0);
  row.addError("radius_error", std::abs(mean / (radius * 0.9) - 1.0), "1", 0.03);
  row.addError("rotation_effect", most / least - 1.0, "1", 0.03);
  row.addError("over_angle", heap.steepestDegrees() - kAngle, "deg", 0.5);
  row.addError("volume_error", std::abs(heap.volume() / kVolume - 1.0), "1", 1e-9);
  meter.finish(row);
  return row;
}

/// A table of `corners` corners, `radius` wide, its top at 0; closed.
std::shared_ptr<const ModelData> table(double radius) {
  constexpr std::uint32_t kCorners = 192;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, -1}};
  for (std::uint32_t k = 0; k < kCorners; ++k) {
    const double turn = 2.0 * kPi * k / kCorners;
    for (const float z : {0.0f, -1.0f})
      mesh.positions.push_back(
          {static_cast<float>(radius * std::cos(turn)), static_cast<float>(radius * std::sin(turn)), z});
  }
  for (std::uint32_t k = 0; k < kCorners; ++k) {
    const std::uint32_t a = 2 + 2 * k, b = 2 + 2 * ((k + 1) % kCorners);
    mesh.indices.insert(mesh.indices.end(), {0, a, b, 1, b + 1, a + 1, a, a + 1, b + 1, a, b + 1, b});
  }
  auto model = std::make_shared<ModelData>();
  model->meshes = {std::move(mesh)};
  model->materials.resize(1);
  model->instances = {{0, Transform{}}};
  return model;
}

/// A table keeps a cone as wide as itself; the rest falls off its rim.
BenchRow disc(const BenchOptions& options, int cells) {
  BenchRow row;
  row.caseId = "repose";
  row.settings = {{"shape", "disc"}, {"cells_along", std::to_string(cells)}};
  const BenchMeter meter;
  constexpr double kDisc = 10.0;  // m, radius
  ModelNode node;
  node.coverCell = 2.0 * kDisc / cells;
  SceneSnapshot scene;
  scene.nodes.push_back(makeNode(kModelType, "disc", "disc"));
  scene.nodes.back().data = std::make_shared<ModelNode>(node);
  scene.models["disc"] = table(kDisc);
  const SnowGroundPointer ground = makeSnowGround(scene);
  const double tangent = std::tan(degreesToRadians(kAngle));
  const double kept = kPi * std::pow(kDisc, 3) * tangent / 3.0;
  Heap heap(*ground, options.threads);
  heap.pour(1.5 * kept, 0.4 * kDisc);
  // Its edge is known to a cell.
  row.addError("height_error", std::abs(heap.deepest() / (kDisc * tangent) - 1.0), "1",
               std::max(0.03, 2.0 / cells));
  row.addFigure("kept_volume_error", heap.volume() / kept - 1.0, "1");
  row.addError("over_angle", heap.steepestDegrees() - kAngle, "deg", 0.5);
  row.addError("volume_error", std::abs((heap.volume() + heap.fell) / (1.5 * kept) - 1.0), "1", 1e-9);
  meter.finish(row);
  return row;
}

/// Heaps on planes of 20 degrees that fall in different directions: how far they reach down and what they
/// cover should not know the grid.
BenchRow turned(const BenchOptions& options, int cells) {
  BenchRow row;
  row.caseId = "repose";
  row.settings = {{"shape", "heap on a slope, turned"}, {"cells_along", std::to_string(cells)}};
  const BenchMeter meter;
  const double rise = std::tan(degreesToRadians(20.0));
  double shortest = kExtent, longest = 0.0, least = kExtent * kExtent, most = 0.0, over = 0.0;
  for (const double degrees : {0.0, 13.0, 22.5, 31.0, 45.0}) {
    const double turn = degreesToRadians(degrees);
    const auto slope = [&](double x, double y) { return rise * (std::cos(turn) * x + std::sin(turn) * y); };
    Heap heap(landOf(cells, slope), options.threads);
    heap.pour(800.0, 1.0);
    const double down = heap.reach(turn + kPi, 0.3);
    shortest = std::min(shortest, down), longest = std::max(longest, down);
    least = std::min(least, heap.footprint(0.3)), most = std::max(most, heap.footprint(0.3));
    over = worse(over, heap.steepestDegrees() - kAngle);
  }
  row.addError("rotation_effect_reach", longest / shortest - 1.0, "1", 0.03);
  row.addError("rotation_effect_area", most / least - 1.0, "1", 0.03);
  row.addError("over_angle", over, "deg", 0.5);
  meter.finish(row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  for (const int cells : options.quick ? std::vector<int>{60} : std::vector<int>{60, 120}) {
    rows.push_back(cone(options, cells));
    rows.push_back(disc(options, options.quick ? 40 : cells));
    rows.push_back(turned(options, cells));
  }
  return rows;
}

}  // namespace

BenchCase reposeCase() {
  return {"repose", "heaps that slide to their angle of repose",
          "cones: V = pi R^3 tan(phi)/3; a disc keeps a tan(phi)", run};
}

}  // namespace spin
