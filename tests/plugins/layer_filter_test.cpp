// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/sdk/layer_filter.h"

#include <cmath>

#include "tests/plugins/support.h"

namespace spin {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

Raster<float> sheet(float value) {
  return Raster<float>(61, 41, 0.0, 0.0, 2.0, value);
}

class LayerFilters : public ::testing::Test {
 protected:
  Raster<float> apply(const std::string& id, Raster<float> values, double radius = 3.0, bool shares = false) {
    const LayerFilter* filter = m_host.layerFilter(id);
    EXPECT_NE(filter, nullptr) << id;
    if (!filter) return values;
    const Status status = filter->apply(id, {radius, 0.5, shares}, values);
    EXPECT_TRUE(status.ok()) << status.error().text();
    return values;
  }

  PluginHost m_host;
};

TEST_F(LayerFilters, AreListedAndKnownByName) {
  const std::vector<LayerFilterInfo> all = m_host.layerFilters();
  EXPECT_EQ(all.size(), 8u);
  for (const LayerFilterInfo& info : all) {
    EXPECT_NE(m_host.layerFilter(info.id), nullptr);
    EXPECT_FALSE(info.label.empty() || info.doc.empty()) << info.id;
  }
  Raster<float> values = sheet(0.5f);
  EXPECT_FALSE(m_host.layerFilter("blur")->apply("nonsense", {}, values).ok());
}

TEST_F(LayerFilters, BlurKeepsConstantsAndTheSumAndSpreads) {
  for (const float v : apply("blur", sheet(0.75f)).values) EXPECT_NEAR(v, 0.75, 1e-5);
  Raster<float> dot = sheet(0.0f);
  dot.at(30, 20) = 1.0f;
  const Raster<float> soft = apply("blur", dot, 4.0);
  double sum = 0.0;
  for (const float v : soft.values) sum += static_cast<double>(v);
  EXPECT_NEAR(sum, 1.0, 1e-4);
  // A Gaussian of half the radius.
  EXPECT_NEAR(soft.at(32, 20) / soft.at(30, 20), std::exp(-0.5), 0.01);
  EXPECT_FLOAT_EQ(soft.at(32, 20), soft.at(30, 22));
}

TEST_F(LayerFilters, BlurOfAPaintedPartNeitherGrowsNorFadesAtItsEdge) {
  Raster<float> part = sheet(kNone);
  for (int j = 10; j < 30; ++j)
    for (int i = 10; i < 40; ++i) part.at(i, j) = 268.0f;
  const Raster<float> after = apply("blur", part);
  for (int j = 0; j < part.height; ++j)
    for (int i = 0; i < part.width; ++i) {
      if (std::isnan(part.at(i, j)))
        EXPECT_TRUE(std::isnan(after.at(i, j)));
      else
        EXPECT_NEAR(after.at(i, j), 268.0f, 1e-3f);
    }
}

TEST_F(LayerFilters, MedianTakesSpecksAndKeepsEdges) {
  Raster<float> values = sheet(0.0f);
  for (int j = 0; j < values.height; ++j)
    for (int i = 30; i < values.width; ++i) values.at(i, j) = 1.0f;
  values.at(10, 10) = 1.0f;
  values.at(50, 30) = 0.0f;
  const Raster<float> after = apply("median", values, 2.0);
  EXPECT_EQ(after.at(10, 10), 0.0f);
  EXPECT_EQ(after.at(50, 30), 1.0f);
  EXPECT_EQ(after.at(29, 20), 0.0f);
  EXPECT_EQ(after.at(30, 20), 1.0f);
}

TEST_F(LayerFilters, GrowAndShrinkByTheRadius) {
  Raster<float> dot = sheet(0.0f);
  dot.at(30, 20) = 0.8f;
  for (const int radius : {1, 2, 5, 8}) {
    const Raster<float> grown = apply("dilate", dot, radius);
    EXPECT_EQ(grown.at(30 + radius, 20), 0.8f) << radius;
    EXPECT_EQ(grown.at(31 + radius, 20), 0.0f) << radius;
    const Raster<float> back = apply("erode", grown, radius);
    EXPECT_EQ(back.values, dot.values) << radius;
  }
  // Painted areas with edges to nothing.
  Raster<float> part = sheet(kNone);
  part.at(30, 20) = 0.5f;
  EXPECT_EQ(apply("dilate", part, 3).at(33, 20), 0.5f);
  EXPECT_TRUE(std::isnan(apply("dilate", part, 3).at(34, 20)));
  EXPECT_TRUE(std::isnan(apply("erode", part, 1).at(30, 20)));
}

TEST_F(LayerFilters, SpecksVanishAndGapsClose) {
  Raster<float> values = sheet(0.0f);
  values.at(5, 5) = 1.0f;
  for (int j = 10; j < 30; ++j)
    for (int i = 20; i < 50; ++i) values.at(i, j) = 1.0f;
  values.at(35, 20) = 0.0f;
  EXPECT_EQ(apply("open", values, 2).at(5, 5), 0.0f);
  EXPECT_EQ(apply("open", values, 2).at(25, 15), 1.0f);
  EXPECT_EQ(apply("close", values, 2).at(35, 20), 1.0f);
  EXPECT_EQ(apply("close", values, 2).at(10, 20), 0.0f);
}

TEST_F(LayerFilters, ThresholdAndInvert) {
  Raster<float> share = sheet(0.25f);
  share.at(3, 3) = 0.75f;
  const Raster<float> hard = apply("threshold", share, 1.0, true);
  EXPECT_EQ(hard.at(3, 3), 1.0f);
  EXPECT_EQ(hard.at(4, 3), 0.0f);
  EXPECT_EQ(apply("invert", share).at(4, 3), 0.75f);
  Raster<float> depth = sheet(kNone);
  depth.at(3, 3) = 2.0f;
  depth.at(4, 3) = 0.3f;
  const Raster<float> deep = apply("threshold", depth);
  EXPECT_EQ(deep.at(3, 3), 2.0f);
  EXPECT_TRUE(std::isnan(deep.at(4, 3)));
  EXPECT_TRUE(std::isnan(deep.at(5, 3)));
}

}  // namespace
}  // namespace spin
