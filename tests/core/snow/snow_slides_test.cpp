// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/snow_slides.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "core/base/random.h"
#include "core/base/units.h"
#include "core/physics/snow_repose.h"
#include "tests/core/snow/cover_land.h"

namespace spin {
namespace {

constexpr double kPhi = 38.0;

struct Heap {
  std::shared_ptr<const CoverGraph> graph;
  std::vector<double> depth, swe;
  std::vector<float> tangents;
  SlideTotals totals;

  explicit Heap(std::shared_ptr<const CoverGraph> g)
      : graph(std::move(g)),
        depth(graph->size(), 0.0),
        swe(graph->size(), 0.0),
        tangents(graph->size(), static_cast<float>(std::tan(degreesToRadians(kPhi)))) {}

  void settle(int threads = 2, SlideSettings settings = {}) {
    CpuBackend backend(threads);
    SnowSlides slides(graph);
    totals = slides.settle({depth.data(), swe.data()}, tangents.data(), settings, backend);
  }
  double volume() const { return test::sumOver(*graph, depth); }
  double mass() const { return test::sumOver(*graph, swe); }
  double steepestDegrees() const {
    const SnowSlides slides(graph);
    double steepest = 0.0;
    for (std::uint32_t c = 0; c < depth.size(); ++c)
      if (depth[c] > 1e-5) steepest = std::max(steepest, slides.steepness(depth.data(), c));
    return radiansToDegrees(std::atan(steepest));
  }
};

double flat(double, double) {
  return 0.0;
}

TEST(SnowSlides, APouredHeapBecomesTheConeOfItsAngle) {
  Heap heap(test::landGraph(121, 121, 0.5, flat));
  const double tangent = std::tan(degreesToRadians(kPhi));
  const std::uint32_t centre = 60 * 121 + 60;
  for (int pour = 0; pour < 200; ++pour) {
    heap.depth[centre] += 20.0, heap.swe[centre] += 2000.0;
    heap.settle();
    ASSERT_EQ(heap.totals.unsettled, 0u);
  }
  EXPECT_NEAR(heap.volume(), 1000.0, 1e-9);
  EXPECT_NEAR(heap.mass(), 1e5, 1e-7);
  EXPECT_LT(heap.steepestDegrees(), kPhi + 0.5);
  // V = pi R^3 tan(phi)/3, by the height of the cone and by its edge along directions of the compass.
  const double radius = std::cbrt(3.0 * 1000.0 / (kPi * tangent));
  EXPECT_NEAR(heap.depth[centre], radius * tangent, 0.04 * radius * tangent);
}

TEST(SnowSlides, NothingMovesBelowTheAngle) {
  Heap heap(test::landGraph(60, 40, 1.0, [](double x, double y) { return 0.5 * x + 0.55 * y; }));
  for (std::size_t c = 0; c < heap.depth.size(); ++c) heap.depth[c] = 0.7, heap.swe[c] = 70.0;
  const std::vector<double> before = heap.depth;
  heap.settle();
  EXPECT_EQ(heap.depth, before);
  EXPECT_EQ(heap.totals.visits, 0u);
}

TEST(SnowSlides, ASteepSlopeEmptiesOntoItsFoot) {
  // 45 degrees above, level below.
  Heap heap(test::landGraph(30, 200, 1.0, [](double, double y) { return std::max(0.0, y - 60.0); }));
  for (std::size_t c = 0; c < heap.depth.size(); ++c) heap.depth[c] = 0.3, heap.swe[c] = 30.0;
  const double volume = heap.volume(), mass = heap.mass();
  heap.settle();
  EXPECT_EQ(heap.totals.unsettled, 0u);
  EXPECT_NEAR(heap.volume(), volume, 1e-9 * volume);
  EXPECT_NEAR(heap.mass(), mass, 1e-9 * mass);
  EXPECT_GT(heap.totals.slid[1], 0.5 * mass);
  EXPECT_LT(heap.depth[190 * 30 + 15], 1e-5);
  EXPECT_GT(heap.depth[60 * 30 + 15], 1.0);
  EXPECT_LT(heap.steepestDegrees(), kPhi + 0.5);
}

TEST(SnowSlides, SnowLeavesOverABorderThatFallsSteeply) {
  Heap heap(test::landGraph(20, 50, 1.0, [](double, double y) { return y; }));
  for (std::size_t c = 0; c < heap.depth.size(); ++c) heap.depth[c] = 0.5, heap.swe[c] = 50.0;
  const double mass = heap.mass();
  heap.settle();
  EXPECT_NEAR(heap.totals.left[1] + heap.mass(), mass, 1e-9 * mass);
  EXPECT_GT(heap.totals.left[1], 0.99 * mass);
  // A level border is no edge.
  Heap level(test::landGraph(5, 5, 1.0, flat));
  for (double& d : level.depth) d = 3.0;
  level.settle();
  EXPECT_EQ(level.totals.left[0], 0.0);
}

TEST(SnowSlides, TenMetresInAnHourSettleInBoundedWork) {
  const auto peaks = [](double x, double y) {
    return 150.0 * std::sin(x / 90.0) * std::sin(y / 70.0) + 12.0 * std::sin(x / 11.0 + y / 17.0);
  };
  Heap heap(test::landGraph(200, 200, 5.0, peaks));
  for (std::size_t c = 0; c < heap.depth.size(); ++c) heap.depth[c] = 10.0, heap.swe[c] = 1000.0;
  const double mass = heap.mass();
  double left = 0.0;
  SlideSettings settings;
  settings.mostVisits = 200000;
  int steps = 0;
  do {
    heap.settle(2, settings);
    left += heap.totals.left[1];
    EXPECT_LE(heap.totals.visits, settings.mostVisits + heap.depth.size());
    ASSERT_LT(++steps, 60);
  } while (heap.totals.unsettled > 0);
  EXPECT_GT(steps, 1);  // the rest was carried over
  EXPECT_NEAR(heap.mass() + left, mass, 1e-9 * mass);
  EXPECT_LT(heap.steepestDegrees(), kPhi + 0.5);
  for (const double d : heap.depth) ASSERT_TRUE(std::isfinite(d) && d >= 0.0);
}

TEST(SnowSlides, ThreadsChangeNoBit) {
  const auto bumps = [](double x, double y) { return 8.0 * std::sin(x / 3.0) * std::cos(y / 4.0); };
  std::vector<std::vector<double>> results;
  for (const int threads : {1, 2, 7}) {
    Heap heap(test::landGraph(150, 130, 1.0, bumps));
    const CounterRandom random{11, 3};
    for (std::size_t c = 0; c < heap.depth.size(); ++c) heap.swe[c] = heap.depth[c] = random.uniformDouble(c);
    heap.settle(threads);
    EXPECT_GT(heap.totals.slid[0], 0.0);
    results.push_back(heap.depth);
  }
  for (const auto& result : results)
    EXPECT_EQ(0, std::memcmp(result.data(), results[0].data(), result.size() * sizeof(double)));
}

TEST(SnowSlides, WallsAndHolesAndSingleCellsHold) {
  // A ditch of vertical walls between two holes.
  Heap heap(test::landGraph(9, 9, 1.0, [](double x, double y) {
    if (x < 1.5 || x > 6.5) return std::nan("");
    return y > 2.5 && y < 5.5 ? -100.0 : 0.0;
  }));
  for (std::uint32_t c = 0; c < heap.depth.size(); ++c)
    if (heap.graph->area(c) > 0.0f) heap.depth[c] = heap.swe[c] = 2.0;
  const double volume = heap.volume();
  heap.settle();
  EXPECT_NEAR(heap.volume(), volume, 1e-12 * volume);
  EXPECT_EQ(heap.totals.unsettled, 0u);
  for (std::uint32_t c = 0; c < heap.depth.size(); ++c)
    EXPECT_TRUE(heap.graph->area(c) > 0.0f || heap.depth[c] == 0.0);
  Heap single(test::landGraph(1, 1, 1.0, flat));
  single.depth[0] = 5.0;
  single.settle();
  EXPECT_EQ(single.depth[0], 5.0);
}

TEST(SnowRepose, FallsFromDryToSlush) {
  const SnowRepose repose;
  EXPECT_DOUBLE_EQ(repose.tangent(0.0, 1.0), std::tan(repose.dry));
  EXPECT_DOUBLE_EQ(repose.tangent(30.0, 1.0), std::tan(repose.dry));
  EXPECT_DOUBLE_EQ(repose.tangent(150.0, 1.0), std::tan(repose.wet));
  EXPECT_DOUBLE_EQ(repose.tangent(5.0, 0.0), std::tan(repose.dry));
  EXPECT_LT(repose.tangent(90.0, 1.0), std::tan(repose.dry));
}

}  // namespace
}  // namespace spin
