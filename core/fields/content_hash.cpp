// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/content_hash.h"

namespace spin {
namespace {

template <class T>
void addVector(Hasher& hasher, const std::vector<T>& values) {
  hasher.add(static_cast<std::uint64_t>(values.size()));
  if (!values.empty()) hasher.addBytes(values.data(), values.size() * sizeof(T));
}

}  // namespace

Hash128 contentHash(const TerrainData& terrain) {
  Hasher hasher;
  const Raster<float>& r = terrain.heights;
  hasher.add(r.width).add(r.height).add(r.originX).add(r.originY).add(r.cellSize);
  hasher.add(terrain.geo.origin.z);  // heights count from it, air pressure and temperature from sea level
  addVector(hasher, r.values);
  return hasher.digest();
}

Hash128 contentHash(const ModelData& model) {
  Hasher hasher;
  for (const Mesh& mesh : model.meshes) {
    addVector(hasher, mesh.positions);
    addVector(hasher, mesh.indices);
  }
  for (const MeshInstance& instance : model.instances) {
    hasher.add(instance.mesh);
    for (const double value : instance.transform.linear) hasher.add(value);
    const Vec3d& t = instance.transform.translation;
    hasher.add(t.x).add(t.y).add(t.z);
  }
  return hasher.digest();
}

Hash128 contentHash(const WeatherSeries& weather) {
  Hasher hasher;
  hasher.add(weather.start).add(weather.step);
  for (const WeatherRecord& r : weather.records)
    for (const double value : {r.shortwave, r.longwave, r.snowfall, r.rainfall, r.airTemperature,
                               r.relativeHumidity, r.wind, r.pressure})
      hasher.add(value);
  return hasher.digest();
}

}  // namespace spin
