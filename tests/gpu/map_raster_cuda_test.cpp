// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/bench/snow_bench_scene.h"
#include "core/snow/occlusion_map.h"
#include "gpu/cuda_device.h"
#include "gpu/map_raster_cuda.h"

namespace spin {
namespace {

/// Fused products round otherwise on the card: edges fall on another texel here and there.
TEST(CudaMapRaster, DrawsWhatTheProcessorDraws) {
  if (!cudaAvailable()) GTEST_SKIP() << cudaDevice().error().text();
  const SceneSnapshot scene = snowBenchSnapshot({});
  const SnowGroundPointer ground = makeSnowGround(scene);
  const auto standing = makeSnowScene(scene, *ground, 0.0, makeBvhRayScene);
  ASSERT_TRUE(standing.has_value());
  const Occluders occluders(scene, *standing);
  const Vec3d half = standing->domain.size() * 0.5;
  const MapView view = MapView::round({-half, half}, normalized(Vec3d{0.4, 0.1, -1.0}), 0.5, 1024);
  const auto raster = makeMapRasterCuda(occluders);
  ASSERT_NE(raster, nullptr);
  CpuBackend backend(2);
  const OcclusionMap card(*raster, view), cpu(occluders, view, backend);
  std::size_t seen = 0, other = 0;
  for (int row = 0; row < view.rows; ++row)
    for (int column = 0; column < view.columns; ++column) {
      const float a = card.depth(column, row), b = cpu.depth(column, row);
      seen += std::isfinite(b) ? 1 : 0;
      other += a != b && !(std::abs(a - b) < 1e-3f) ? 1 : 0;
    }
  EXPECT_GT(seen, 100000u);
  EXPECT_LT(static_cast<double>(other), 1e-3 * static_cast<double>(seen));
}

}  // namespace
}  // namespace spin
