// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/fields/mesh.h"
#include "core/sim/frame.h"
#include "core/sim/snapshot.h"
#include "editor/render/renderer.h"

namespace spin::test {

/// Builds snapshots node by node.
struct SceneBuilder {
  SceneSnapshot snapshot;

  template <class T>
  SceneBuilder& add(const NodeType& type, const std::string& id, const std::function<void(T&)>& edit) {
    SceneNode node = makeNode(type, id, id);
    auto data = std::make_shared<T>(*node.as<T>());
    edit(*data);
    node.data = data;
    snapshot.nodes.push_back(std::move(node));
    return *this;
  }
  SnapshotPointer build() const { return std::make_shared<const SceneSnapshot>(snapshot); }
};

/// Terrain with 5 m cells and a node for it; the height in m of cell (i, j).
void addTerrain(SceneBuilder& scene, int width, int height, const std::function<double(int, int)>& heightOf);
/// A quiet grey day: no falling snow, soft light.
void addWeather(SceneBuilder& scene);
/// Ground of one type, so that bare ground has a known hue.
void addGround(SceneBuilder& scene, int type);

/// A square of 2 m in the x-z plane (facing -y) with a 2 x 2 texture: red, green / blue, yellow from the top
/// left.
std::shared_ptr<ModelData> texturedSquare();
/// A closed box without texture.
std::shared_ptr<ModelData> boxModel(Vec3d size);
void addModel(SceneBuilder& scene, const std::string& id, std::shared_ptr<const ModelData> data,
              Vec3d position);

/// A frame whose cover has one coarse grid over the scene's terrain; depth in m of cell (i, j).
std::shared_ptr<Frame> frameWithCover(const SceneSnapshot& scene,
                                      const std::function<double(int, int)>& depth);
/// Adds a grid to the frame's cover.
void addGrid(Frame& frame, CoverGrid grid, std::vector<float> depth);

/// 8-bit sRGB RGB picture as the viewport shows it, rows from the top.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
  int red(int x, int y) const { return rgb[offset(x, y)]; }
  int green(int x, int y) const { return rgb[offset(x, y) + 1]; }
  int blue(int x, int y) const { return rgb[offset(x, y) + 2]; }
  int bright(int x, int y) const { return (red(x, y) + green(x, y) + blue(x, y)) / 3; }
  std::size_t offset(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }
};
/// bands: drawn one after the other into the same target.
Picture drawPicture(Renderer& renderer, const RenderCamera& camera, RenderOptions options,
                    const std::vector<Vec2d>& bands = {{0.0, 1.0}});
/// Mean absolute difference of two pictures of one size, in 8-bit steps.
double difference(const Picture& a, const Picture& b);

/// Binary PPM.
bool writePpm(const Picture& picture, const std::string& path);
Picture readPpm(const std::string& path);

}  // namespace spin::test
