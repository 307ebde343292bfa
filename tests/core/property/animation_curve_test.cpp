// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/property/animation_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/nodes/weather_nodes.h"
#include "core/property/scene_node.h"

namespace spin {
namespace {

double real(const Value& value) {
  return std::get<double>(value);
}

AnimationCurve curve(Interpolation interpolation, std::initializer_list<std::pair<double, double>> points) {
  AnimationCurve result;
  for (const auto& [time, value] : points) result.setKey({time, value, interpolation});
  return result;
}

TEST(AnimationCurve, HoldsOutsideItsKeys) {
  for (Interpolation i : {Interpolation::Step, Interpolation::Linear, Interpolation::Smooth}) {
    const AnimationCurve c = curve(i, {{1, 10}, {3, 20}});
    EXPECT_EQ(real(c.at(-5)), 10);
    EXPECT_EQ(real(c.at(1)), 10);
    EXPECT_EQ(real(c.at(3)), 20);
    EXPECT_EQ(real(c.at(1e12)), 20);
  }
}

TEST(AnimationCurve, StepKeepsTheEarlierValue) {
  const AnimationCurve c = curve(Interpolation::Step, {{0, 1}, {1, 2}, {2, 3}});
  EXPECT_EQ(real(c.at(0.999)), 1);
  EXPECT_EQ(real(c.at(1.0)), 2);
  EXPECT_EQ(real(c.at(1.5)), 2);
}

TEST(AnimationCurve, LinearIsLinear) {
  const AnimationCurve c = curve(Interpolation::Linear, {{0, 1}, {2, 5}, {3, 5}});
  EXPECT_DOUBLE_EQ(real(c.at(0.5)), 2);
  EXPECT_DOUBLE_EQ(real(c.at(1.5)), 4);
  EXPECT_DOUBLE_EQ(real(c.at(2.5)), 5);
}

TEST(AnimationCurve, EachSpanFollowsItsFirstKey) {
  AnimationCurve c;
  c.setKey({0, 0.0, Interpolation::Step});
  c.setKey({1, 1.0, Interpolation::Linear});
  c.setKey({2, 3.0, Interpolation::Smooth});
  EXPECT_EQ(real(c.at(0.5)), 0);
  EXPECT_DOUBLE_EQ(real(c.at(1.5)), 2);
}

TEST(AnimationCurve, SmoothPassesKeysAndIsMonotoneBetweenThem) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    AnimationCurve c;
    double t = 0.0;
    for (std::uint64_t i = 0; i < 8; ++i) {
      t += 0.01 + std::abs(std::sin(static_cast<double>(seed * 31 + i * 7)));
      c.setKey({t, 100.0 * std::sin(static_cast<double>(seed * 17 + i * i)), Interpolation::Smooth});
    }
    for (std::size_t i = 0; i + 1 < c.keys().size(); ++i) {
      const Key &a = c.keys()[i], &b = c.keys()[i + 1];
      EXPECT_EQ(c.at(a.time), a.value);
      const double sign = real(b.value) >= real(a.value) ? 1.0 : -1.0;
      double last = real(a.value);
      for (int s = 1; s <= 40; ++s) {
        const double now = real(c.at(a.time + (b.time - a.time) * s / 40.0));
        EXPECT_GE(sign * (now - last), -1e-9) << "turns between keys " << i << " and " << i + 1;
        last = now;
      }
    }
  }
}

TEST(AnimationCurve, SmoothHasNoCorners) {
  const AnimationCurve c = curve(Interpolation::Smooth, {{0, 0}, {1, 1}, {3, 2}, {4, 8}});
  for (double t : {0.0, 1.0, 3.0, 4.0}) {
    const double e = 1e-5;
    const double before = (real(c.at(t)) - real(c.at(t - e))) / e,
                 after = (real(c.at(t + e)) - real(c.at(t))) / e;
    EXPECT_NEAR(before, after, 1e-3) << "at " << t;
  }
  EXPECT_NE(real(c.at(0.5)), 0.5) << "smooth is not linear";
}

TEST(AnimationCurve, VectorsInterpolateByComponent) {
  AnimationCurve c;
  c.setKey({0, Vec3d{0, 10, 5}, Interpolation::Linear});
  c.setKey({1, Vec3d{1, 20, 5}, Interpolation::Linear});
  EXPECT_EQ(c.at(0.5), Value(Vec3d(0.5, 15, 5)));
}

TEST(AnimationCurve, OtherKindsStep) {
  AnimationCurve c;
  c.setKey({0, true, Interpolation::Linear});
  c.setKey({1, false, Interpolation::Smooth});
  EXPECT_EQ(c.at(0.9), Value(true));
  AnimationCurve whole;
  whole.setKey({0, std::int64_t{1}, Interpolation::Linear});
  whole.setKey({1, std::int64_t{9}, Interpolation::Linear});
  EXPECT_EQ(whole.at(0.5), Value(std::int64_t{1}));
}

TEST(AnimationCurve, KeysAreSortedReplacedAndRemovedByTime) {
  AnimationCurve c = curve(Interpolation::Linear, {{2, 2}, {0, 0}, {1, 1}});
  ASSERT_EQ(c.keys().size(), 3u);
  EXPECT_TRUE(std::is_sorted(c.keys().begin(), c.keys().end(),
                             [](const Key& a, const Key& b) { return a.time < b.time; }));
  c.setKey({1.0 + 5e-7, 7.0, Interpolation::Step});
  ASSERT_EQ(c.keys().size(), 3u) << "within a microsecond it is the same key";
  EXPECT_EQ(real(c.at(1.5)), 7);
  EXPECT_NE(c.keyAt(1.0), nullptr);
  EXPECT_EQ(c.keyAt(1.1), nullptr);
  EXPECT_FALSE(c.removeKey(1.1));
  EXPECT_TRUE(c.removeKey(1.0));
  EXPECT_DOUBLE_EQ(real(c.at(1.0)), 1.0);
}

TEST(SceneNode, AnimatedPropertiesIgnoreTheirPlainValue) {
  SceneNode node = makeNode(kWeatherType, "weather", "Weather");
  const PropertyInfo& wind = *kWeatherType.find("wind_speed_m_s");
  setPlainValue(node, wind, 4.0);
  EXPECT_EQ(valueAt(node, wind, 1.0), Value(4.0));
  node.curves["wind_speed_m_s"] = curve(Interpolation::Linear, {{0, 0}, {2, 20}});
  EXPECT_EQ(valueAt(node, wind, 1.0), Value(10.0));
  EXPECT_EQ(plainValue(node, wind), Value(4.0));
  const auto data = evaluate(node, 1.5);
  EXPECT_DOUBLE_EQ(static_cast<const WeatherNode&>(*data).windSpeed, 15.0);
  EXPECT_DOUBLE_EQ(static_cast<const WeatherNode&>(*data).airTemperature, 268.15);
}

TEST(SceneNode, CopiesDoNotShareLaterChanges) {
  SceneNode node = makeNode(kWeatherType, "weather", "Weather");
  const SceneNode copy = node;
  setPlainValue(node, *kWeatherType.find("wind_speed_m_s"), 9.0);
  EXPECT_DOUBLE_EQ(copy.as<WeatherNode>()->windSpeed, 2.0);
  EXPECT_DOUBLE_EQ(node.as<WeatherNode>()->windSpeed, 9.0);
}

}  // namespace
}  // namespace spin
