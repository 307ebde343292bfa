// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "core/snow/map_raster.h"
#include "core/snow/occlusion_map.h"

namespace spin {

struct ClearDepthKernel {
  std::int32_t* depth;
  SPIN_HD void operator()(std::size_t i) const { depth[i] = orderedDepth(HUGE_VALF); }
};

/// The raster over a backend's concept (core/base/parallel.h): a triangle a thread, the nearest by a minimum
/// that does not depend on their order.
template <class Backend>
class MapRasterOn final : public MapRaster {
 public:
  MapRasterOn(const Occluders& occluders, Backend backend) : m_backend(std::move(backend)) {
    std::vector<Vec3f> corners;
    corners.reserve(3 * occluders.size());
    for (const Occluders::Triangle& triangle : occluders.triangles())
      corners.insert(corners.end(), triangle.begin(), triangle.end());
    m_triangles = occluders.size();
    m_backend.upload(corners, m_corners);
  }

  std::vector<float> draw(const MapView& view) override {
    const std::size_t texels = static_cast<std::size_t>(view.columns) * static_cast<std::size_t>(view.rows);
    m_depth.resize(texels);
    m_backend.forEach("occlusion map", texels, ClearDepthKernel{m_depth.data()});
    m_backend.forEach(
        "occlusion map", m_triangles,
        DrawKernel{m_corners.data(), view.projection(), view.drawn, view.columns, m_depth.data()});
    m_backend.download(m_depth, m_received);
    std::vector<float> depths(texels);
    for (std::size_t k = 0; k < texels; ++k) depths[k] = depthOf(m_received[k]);
    return depths;
  }

 private:
  template <class T>
  using Array = typename Backend::template Array<T>;

  Backend m_backend;
  std::size_t m_triangles = 0;
  Array<Vec3f> m_corners;
  Array<std::int32_t> m_depth;
  std::vector<std::int32_t> m_received;
};

}  // namespace spin
