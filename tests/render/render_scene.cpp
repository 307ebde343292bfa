// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/render/render_scene.h"

#include <epoxy/gl.h>

#include <cstdlib>
#include <fstream>

#include "core/nodes/ground_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "editor/render/gl_objects.h"

namespace spin::test {

void addTerrain(SceneBuilder& scene, int width, int height, const std::function<double(int, int)>& heightOf) {
  auto terrain = std::make_shared<TerrainData>();
  terrain->heights = Raster<float>(width, height, 0.0, 0.0, 5.0);
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) terrain->heights.at(i, j) = static_cast<float>(heightOf(i, j));
  scene.snapshot.terrain = terrain;
  scene.add<TerrainNode>(kTerrainType, "terrain", [](TerrainNode&) {});
}

void addWeather(SceneBuilder& scene) {
  scene.add<WeatherNode>(kWeatherType, "weather", [](WeatherNode& w) {
    w.cloudCover = 0.5;
    w.sunElevationDegrees = 40.0;
  });
}

void addGround(SceneBuilder& scene, int type) {
  scene.add<GroundTypeLayerNode>(kGroundTypeLayerType, "ground",
                                 [type](GroundTypeLayerNode& g) { g.base = static_cast<GroundType>(type); });
}

std::shared_ptr<ModelData> texturedSquare() {
  auto model = std::make_shared<ModelData>();
  Image8 image;
  image.width = image.height = 2;
  image.rgba = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 0, 255};
  model->textures.push_back(image);
  Material material;
  material.baseColour = {1, 1, 1, 1};
  material.texture = 0;
  model->materials.push_back(material);
  Mesh mesh;
  mesh.positions = {{-1, 0, 0}, {1, 0, 0}, {1, 0, 2}, {-1, 0, 2}};
  mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  model->meshes.push_back(mesh);
  model->instances.push_back({0, {}});
  return model;
}

std::shared_ptr<ModelData> boxModel(Vec3d size) {
  auto model = std::make_shared<ModelData>();
  Material material;
  material.baseColour = {0.03f, 0.05f, 0.25f, 1.0f};
  model->materials.push_back(material);
  const auto x = static_cast<float>(size.x / 2), y = static_cast<float>(size.y / 2),
             z = static_cast<float>(size.z);
  Mesh mesh;
  const Vec3f corners[8] = {{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0},
                            {-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}};
  const int faces[6][4] = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6},
                           {3, 0, 4, 7}, {4, 5, 6, 7}, {3, 2, 1, 0}};
  for (const auto& face : faces) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const int k : face) mesh.positions.push_back(corners[k]);
    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + k);
  }
  model->meshes.push_back(mesh);
  model->instances.push_back({0, {}});
  return model;
}

void addModel(SceneBuilder& scene, const std::string& id, std::shared_ptr<const ModelData> data,
              Vec3d position) {
  scene.add<ModelNode>(kModelType, id, [position](ModelNode& m) {
    m.position = position;
    m.onGround = false;
  });
  scene.snapshot.models[id] = std::move(data);
}

std::shared_ptr<Frame> frameWithCover(const SceneSnapshot& scene,
                                      const std::function<double(int, int)>& depth) {
  const Raster<float>& h = scene.terrain->heights;
  auto cover = std::make_shared<CoverPart>();
  auto layout = std::make_shared<CoverLayout>();
  layout->grids.push_back({"terrain", "terrain", h, h.sameShape<float>(25.0f)});
  cover->layout = layout;
  cover->values.resize(1);
  for (int j = 0; j < h.height; ++j)
    for (int i = 0; i < h.width; ++i) cover->values[0].depth.push_back(static_cast<float>(depth(i, j)));
  auto frame = std::make_shared<Frame>();
  frame->parts["cover"] = cover;
  return frame;
}

void addGrid(Frame& frame, CoverGrid grid, std::vector<float> depth) {
  auto cover = std::make_shared<CoverPart>(*frame.part<CoverPart>("cover"));
  auto layout = std::make_shared<CoverLayout>(*cover->layout);
  layout->grids.push_back(std::move(grid));
  cover->layout = layout;
  cover->values.emplace_back();
  cover->values.back().depth = std::move(depth);
  frame.parts["cover"] = cover;
}

Picture drawPicture(Renderer& renderer, const RenderCamera& camera, RenderOptions options,
                    const std::vector<Vec2d>& bands) {
  const GlRenderbuffer colour = GlRenderbuffer::make();
  glNamedRenderbufferStorage(colour.id(), GL_RGBA8, options.width, options.height);
  const GlFramebuffer target = GlFramebuffer::make();
  glNamedFramebufferRenderbuffer(target.id(), GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour.id());
  for (const Vec2d& band : bands) {
    options.band = band;
    renderer.draw(target.id(), camera, 0.0, options);
  }
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(options.width) *
                                 static_cast<std::size_t>(options.height) * 4);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target.id());
  glReadPixels(0, 0, options.width, options.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  Picture picture{options.width, options.height, {}};
  for (int y = options.height - 1; y >= 0; --y)
    for (int x = 0; x < options.width; ++x)
      for (int c = 0; c < 3; ++c)
        picture.rgb.push_back(rgba[static_cast<std::size_t>((y * options.width + x) * 4 + c)]);
  return picture;
}

double difference(const Picture& a, const Picture& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.rgb.size(); ++k) sum += std::abs(int{a.rgb[k]} - int{b.rgb[k]});
  return a.rgb.empty() ? 0.0 : sum / static_cast<double>(a.rgb.size());
}

bool writePpm(const Picture& picture, const std::string& path) {
  std::ofstream out(path, std::ios::binary);
  out << "P6\n" << picture.width << ' ' << picture.height << "\n255\n";
  out.write(reinterpret_cast<const char*>(picture.rgb.data()),
            static_cast<std::streamsize>(picture.rgb.size()));
  return out.good();
}

Picture readPpm(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string magic;
  int most = 0;
  Picture picture;
  in >> magic >> picture.width >> picture.height >> most;
  in.get();
  if (!in || magic != "P6" || picture.width < 1 || picture.width > 4096 || picture.height < 1 ||
      picture.height > 4096)
    return {};
  picture.rgb.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * 3);
  in.read(reinterpret_cast<char*>(picture.rgb.data()), static_cast<std::streamsize>(picture.rgb.size()));
  return in ? picture : Picture{};
}

}  // namespace spin::test
