// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/shared_maps.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace spin {
namespace {

std::vector<Vec3d> cornersOf(const Box3d& box) {
  std::vector<Vec3d> corners;
  for (int k = 0; k < 8; ++k)
    corners.push_back(
        {k & 1 ? box.max.x : box.min.x, k & 2 ? box.max.y : box.min.y, k & 4 ? box.max.z : box.min.z});
  return corners;
}

}  // namespace

Box3d GridPlace::moved(Vec3d offset) const {
  Box3d at;
  if (!box.empty()) at.extend(box.min + move + offset), at.extend(box.max + move + offset);
  return at;
}

SharedMaps::SharedMaps(const std::vector<GridPlace>& places, const ExposureSettings& settings)
    : m_places(places), m_settings(settings), m_end(places.size(), 0), m_diagonal(places.size(), 0.0) {
  for (std::size_t first = 0; first < places.size(); first = m_end[first]) {
    Box3d box = places[first].box;
    const double most = largest(places[first].cellSize, settings);
    std::size_t end = first + 1;
    for (; end < places.size() && places[end].model == places[first].model; ++end) {
      Box3d joined = box;
      joined.extend(places[end].box);
      if (places[end].cellSize != places[first].cellSize || length(joined.size()) > most) break;
      box = joined;
    }
    m_end[first] = end;
    m_diagonal[first] = length(box.size());
  }
}

double SharedMaps::largestTexel(std::size_t first) const {
  return std::max(0.5 * m_places[first].cellSize, m_diagonal[first] / std::max(m_settings.mapSize - 4, 1));
}

std::vector<OcclusionMap> SharedMaps::draw(std::size_t first, const Box3d& wanted, const Occluders& occluders,
                                           MapRaster* raster, const Workshop& workshop) const {
  std::vector<OcclusionMap> maps;
  Box3d box;
  for (std::size_t k = first; k < m_end[first]; ++k) box.extend(m_places[k].moved());
  if (box.empty()) return maps;
  const std::vector<Vec3d> corners = cornersOf(box), needed = cornersOf(wanted);
  for (const auto& words : sobolPoints(static_cast<std::size_t>(m_settings.mapDirections))) {
    if (workshop.cancel.cancelled()) return maps;
    const Vec3d fall = m_settings.cone.direction(shifted(words[2], 0), shifted(words[3], 0));
    MapView view = MapView::round(corners, fall, 0.5 * m_places[first].cellSize, m_settings.mapSize);
    view.keep(needed);
    if (raster)
      maps.emplace_back(*raster, view);
    else
      maps.emplace_back(occluders, view, workshop.backend, workshop.cancel);
  }
  return maps;
}

void sortForMaps(std::vector<GridPlace>& places, const ExposureSettings& settings) {
  const auto tileOf = [&](const GridPlace& p) {
    const double tile = 0.25 * p.cellSize * settings.mapSize;
    const Vec3d centre = p.box.empty() ? Vec3d{} : p.box.centre();
    return std::tuple(p.model, p.cellSize, std::floor(centre.x / tile), std::floor(centre.y / tile));
  };
  std::stable_sort(places.begin(), places.end(),
                   [&](const GridPlace& a, const GridPlace& b) { return tileOf(a) < tileOf(b); });
}

}  // namespace spin
