// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/snow_scene.h"

#include <algorithm>

#include "core/base/check.h"
#include "core/fields/layered_ray_scene.h"
#include "core/nodes/terrain_node.h"

namespace spin {
namespace {

struct TriangleSoup {
  std::vector<Vec3f> positions;
  std::vector<std::uint32_t> indices;
};

/// Points of the raster that some quad uses, numbered, and two triangles a quad. Unfinished when cancelled.
TriangleSoup terrainTriangles(const TerrainSurface& surface, Vec3d centre, const CancelToken& cancel) {
  const Raster<float>& h = surface.heights();
  TriangleSoup soup;
  Raster<std::uint32_t> number = h.sameShape<std::uint32_t>(UINT32_MAX);
  const auto corner = [&](int i, int j) {
    std::uint32_t& n = number.at(i, j);
    if (n == UINT32_MAX) {
      n = static_cast<std::uint32_t>(soup.positions.size());
      soup.positions.push_back((Vec3d{h.x(i), h.y(j), h.at(i, j)} - centre).to<float>());
    }
    return n;
  };
  soup.positions.reserve(h.size());
  soup.indices.reserve(6 * h.size());
  for (int j = 0; j + 1 < h.height && !cancel.cancelled(); ++j)
    for (int i = 0; i + 1 < h.width; ++i) {
      if (!surface.quadExists(i, j)) continue;
      const std::uint32_t a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                          d = corner(i, j + 1);
      soup.indices.insert(soup.indices.end(), {a, b, c, a, c, d});
    }
  return soup;
}

/// Edges of quads whose neighbour across the edge does not exist.
std::vector<SkirtEdge> skirtEdges(const TerrainSurface& surface) {
  const Raster<float>& h = surface.heights();
  std::vector<SkirtEdge> edges;
  const auto point = [&](int i, int j) { return Vec3d{h.x(i), h.y(j), h.at(i, j)}; };
  for (int j = 0; j + 1 < h.height; ++j)
    for (int i = 0; i + 1 < h.width; ++i) {
      if (!surface.quadExists(i, j)) continue;
      const Vec3d a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1), d = point(i, j + 1);
      if (!surface.quadExists(i, j - 1)) edges.push_back({a, b, {0, -1, 0}, false});
      if (!surface.quadExists(i + 1, j)) edges.push_back({b, c, {1, 0, 0}, false});
      if (!surface.quadExists(i, j + 1)) edges.push_back({c, d, {0, 1, 0}, false});
      if (!surface.quadExists(i - 1, j)) edges.push_back({d, a, {-1, 0, 0}, false});
    }
  return edges;
}

Box3d terrainBox(const TerrainSurface& surface) {
  const Raster<float>& h = surface.heights();
  Box3d box;
  for (int j = 0; j + 1 < h.height; ++j)
    for (int i = 0; i + 1 < h.width; ++i) {
      if (!surface.quadExists(i, j)) continue;
      for (int corner = 0; corner < 4; ++corner) {
        const int ci = i + (corner & 1), cj = j + (corner >> 1);
        box.extend(Vec3d{h.x(ci), h.y(cj), h.at(ci, cj)});
      }
    }
  return box;
}

TriangleSoup skirtTriangles(const std::vector<SkirtEdge>& edges, double floor, Vec3d centre) {
  TriangleSoup soup;
  for (const SkirtEdge& edge : edges) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (const Vec3d p :
         {edge.from, edge.to, Vec3d{edge.to.x, edge.to.y, floor}, Vec3d{edge.from.x, edge.from.y, floor}})
      soup.positions.push_back((p - centre).to<float>());
    soup.indices.insert(soup.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
  }
  return soup;
}

bool liesOnBorder(const SkirtEdge& edge, const Box3d& domain) {
  const double tolerance = 1e-6 * length(domain.size());
  const auto near = [tolerance](double a, double b) { return std::abs(a - b) <= tolerance; };
  if (edge.outward.x != 0.0) return near(edge.from.x, edge.outward.x > 0.0 ? domain.max.x : domain.min.x);
  return near(edge.from.y, edge.outward.y > 0.0 ? domain.max.y : domain.min.y);
}

/// Ground's volume above the floor; under a cut quad the mean of its two triangles' mean heights.
double groundVolume(const TerrainSurface& surface, double floor) {
  const Raster<float>& h = surface.heights();
  double sum = 0.0;
  for (int j = 0; j + 1 < h.height; ++j)
    for (int i = 0; i + 1 < h.width; ++i) {
      if (!surface.quadExists(i, j)) continue;
      const double diagonal = static_cast<double>(h.at(i, j)) + static_cast<double>(h.at(i + 1, j + 1));
      const double others = static_cast<double>(h.at(i + 1, j)) + static_cast<double>(h.at(i, j + 1));
      sum += (2.0 * diagonal + others) / 6.0 - floor;
    }
  return sum * h.cellSize * h.cellSize;
}

std::vector<StandingModel> standingModels(const SceneSnapshot& scene, const SnowGround& ground,
                                          double filmTime) {
  std::vector<StandingModel> models;
  for (const ModelGround& model : ground.models) {
    StandingModel standing;
    standing.placement = scene.modelTransform(nodeOf(scene, model), filmTime);
    standing.triangles =
        model.turns ? placedTriangles(*scene.models.at(model.node), standing.placement) : model.triangles;
    models.push_back(std::move(standing));
  }
  return models;
}

std::uint32_t addModel(RayScene& rays, const StandingModel& model, Vec3d centre) {
  TriangleSoup soup;
  const Vec3d move = model.placement.translation - centre;
  for (const PlacedTriangle& triangle : model.triangles)
    for (const Vec3f& p : triangle.corners) {
      soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
      soup.positions.push_back((p.to<double>() + move).to<float>());
    }
  return rays.addTriangles(soup.positions, soup.indices);
}

/// Sets domain, floor, centre and tolerance from what stands in the scene.
void setDomain(SnowScene& scene, const Box3d& ground) {
  Box3d models;
  for (const StandingModel& model : scene.models)
    for (const PlacedTriangle& triangle : model.triangles)
      for (const Vec3f& p : triangle.corners) models.extend(p.to<double>() + model.placement.translation);
  scene.domain = ground;
  scene.domain.extend(models);
  if (scene.domain.empty()) return;
  if (ground.empty()) {
    // Without terrain the air reaches half a model's size past it, so that snow also falls beside it.
    const Vec3d margin{0.5 * models.size().x + 1.0, 0.5 * models.size().y + 1.0, 0.0};
    scene.domain.extend(models.min - margin);
    scene.domain.extend(models.max + margin);
  }
  scene.domain.min.z -= 1.0;
  scene.domain.max.z += 1.0;
  scene.level = scene.domain.min.z;
  scene.centre = scene.domain.centre();
  const Vec3d half = scene.domain.size() * 0.5;
  scene.tolerance = 8e-5 * std::max({half.x, half.y, half.z}) + 2e-5;
}

}  // namespace

std::vector<StandingModel> modelsAtStart(const SceneSnapshot& snapshot, const SnowGround& ground) {
  std::vector<StandingModel> models;
  for (const ModelGround& model : ground.models)
    models.push_back({snapshot.modelTransform(nodeOf(snapshot, model), 0.0), model.triangles, 0});
  return models;
}

bool SnowSceneMaker::fits(const SnowScene& scene) const {
  if (!m_still || !(m_still->domain == scene.domain)) return false;
  for (std::size_t m = 0; m < scene.models.size(); ++m)
    if (m_still->placement[m] && !(*m_still->placement[m] == scene.models[m].placement)) return false;
  return true;
}

bool SnowSceneMaker::buildStill(const SceneSnapshot& snapshot, const SnowGround& ground,
                                const SnowScene& scene, const CancelToken& cancel) {
  Still still;
  still.domain = scene.domain;
  still.rays = m_makeRayScene();
  if (!ground.terrain.empty()) {
    const TerrainSurface surface(snapshot.terrain->heights);
    still.hasTerrain = true;
    still.skirts = skirtEdges(surface);
    for (SkirtEdge& edge : still.skirts) edge.onBorder = liesOnBorder(edge, scene.domain);
    const TriangleSoup land = terrainTriangles(surface, scene.centre, cancel);
    if (cancel.cancelled()) return false;
    still.terrainGeometry = still.rays->addTriangles(land.positions, land.indices);
    const TriangleSoup skirts = skirtTriangles(still.skirts, scene.level, scene.centre);
    still.skirtGeometry = still.rays->addTriangles(skirts.positions, skirts.indices);
    still.geometries = 2;
    still.groundVolume = groundVolume(surface, scene.level);
  }
  for (std::size_t m = 0; m < scene.models.size(); ++m) {
    const bool moves = !nodeOf(snapshot, ground.models[m]).curves.empty();
    still.placement.push_back(moves ? std::nullopt : std::optional(scene.models[m].placement));
    still.geometry.push_back(moves ? 0 : addModel(*still.rays, scene.models[m], scene.centre));
    still.geometries += moves ? 0 : 1;
  }
  if (cancel.cancelled() || !still.rays->commit(cancel)) return false;
  m_still = std::move(still);
  return true;
}

std::optional<SnowScene> SnowSceneMaker::at(const SceneSnapshot& snapshot, const SnowGround& ground,
                                            double filmTime, const CancelToken& cancel) {
  SnowScene scene;
  scene.models = standingModels(snapshot, ground, filmTime);
  Box3d box;
  if (!ground.terrain.empty()) box = terrainBox(TerrainSurface(snapshot.terrain->heights));
  setDomain(scene, box);
  if (scene.domain.empty()) {
    scene.rays = m_makeRayScene();
    return scene;
  }
  if (!fits(scene)) {
    m_still.reset();
    if (cancel.cancelled() || !buildStill(snapshot, ground, scene, cancel)) return std::nullopt;
  }
  const Vec3d size = scene.domain.size();
  scene.airVolume = size.x * size.y * size.z - m_still->groundVolume;
  scene.hasTerrain = m_still->hasTerrain;
  scene.skirts = m_still->skirts;
  scene.terrainGeometry = m_still->terrainGeometry;
  scene.skirtGeometry = m_still->skirtGeometry;
  scene.rays = m_still->rays;
  if (m_still->geometries < scene.models.size() + (scene.hasTerrain ? 2u : 0u))
    scene.rays = makeLayeredRayScene(m_still->rays, m_still->geometries, m_makeRayScene());
  for (std::size_t m = 0; m < scene.models.size(); ++m)
    scene.models[m].geometry =
        m_still->placement[m] ? m_still->geometry[m] : addModel(*scene.rays, scene.models[m], scene.centre);
  if (scene.rays != m_still->rays && (cancel.cancelled() || !scene.rays->commit(cancel))) return std::nullopt;
  return scene;
}

std::optional<SnowScene> makeSnowScene(const SceneSnapshot& snapshot, const SnowGround& ground,
                                       double filmTime, const RaySceneFactory& makeRayScene,
                                       const CancelToken& cancel) {
  return SnowSceneMaker(makeRayScene).at(snapshot, ground, filmTime, cancel);
}

}  // namespace spin
