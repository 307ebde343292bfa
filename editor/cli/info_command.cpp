// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "core/fields/terrain_surface.h"
#include "core/nodes/terrain_node.h"
#include "editor/cli/commands.h"

namespace spin {
namespace {

JsonValue number(double value) {
  return JsonValue::of(value);
}

JsonValue vectorOf(Vec3d v) {
  return JsonValue::array({number(v.x), number(v.y), number(v.z)});
}

JsonValue nodesInfo(const OpenedScene& opened) {
  std::vector<JsonValue> nodes;
  for (const SceneNode& node : opened.scene.nodes()) {
    JsonValue value = JsonValue::object();
    value.set("id", JsonValue::of(node.id));
    value.set("type", JsonValue::of(node.type->id));
    value.set("name", JsonValue::of(node.name));
    if (!node.enabled) value.set("enabled", JsonValue::of(false));
    if (const std::string source = sourceOf(node); !source.empty()) value.set("file", JsonValue::of(source));
    for (const AssetLibrary::Issue& issue : opened.issues)
      if (issue.node == node.id) value.set("problem", JsonValue::of(issue.error.text()));
    nodes.push_back(std::move(value));
  }
  return JsonValue::array(std::move(nodes));
}

JsonValue terrainInfo(const TerrainData& terrain) {
  const Raster<float>& r = terrain.heights;
  const Vec2d range = valueRange(r);
  std::size_t holes = 0;
  for (const float height : r.values) holes += std::isnan(height) ? 1 : 0;
  JsonValue value = JsonValue::object();
  value.set("columns", number(r.width));
  value.set("rows", number(r.height));
  value.set("cell_size_m", number(r.cellSize));
  value.set("height_m", JsonValue::array({number(range.x + terrain.geo.origin.z),
                                          number(range.y + terrain.geo.origin.z)}));
  value.set("holes_share",
            number(r.size() ? static_cast<double>(holes) / static_cast<double>(r.size()) : 0.0));
  value.set("epsg", number(terrain.geo.epsg));
  value.set("origin_m", vectorOf(terrain.geo.origin));
  return value;
}

JsonValue modelsInfo(const SceneSnapshot& scene) {
  std::vector<JsonValue> models;
  for (const auto& [id, model] : scene.models) {
    JsonValue value = JsonValue::object();
    value.set("node", JsonValue::of(id));
    value.set("triangles", number(static_cast<double>(model->triangleCount())));
    value.set("size_m", vectorOf(model->bounds().size()));
    value.set("textures", number(static_cast<double>(model->textures.size())));
    models.push_back(std::move(value));
  }
  return JsonValue::array(std::move(models));
}

JsonValue cacheInfo(const FrameStore& store, const std::vector<FrameState>& states) {
  int counts[3] = {0, 0, 0};
  for (const FrameState state : states) ++counts[static_cast<int>(state)];
  const FrameStore::Usage usage = store.usage();
  JsonValue value = JsonValue::object();
  value.set("folder", JsonValue::of(store.options().directory));
  value.set("ready", number(counts[static_cast<int>(FrameState::Ready)]));
  value.set("stale", number(counts[static_cast<int>(FrameState::Stale)]));
  value.set("missing", number(counts[static_cast<int>(FrameState::Missing)]));
  value.set("disk_bytes", number(static_cast<double>(usage.diskBytes)));
  value.set("stale_bytes", number(static_cast<double>(usage.staleDiskBytes)));
  return value;
}

JsonValue frameInfo(const FrameInfo& info) {
  JsonValue value = JsonValue::object();
  value.set("frame", number(info.time.frame));
  value.set("film_s", number(info.time.film));
  value.set("weather_s", number(info.time.weather));
  value.set("backend", JsonValue::of(info.backend));
  JsonValue sources = JsonValue::object(), sinks = JsonValue::object();
  for (const BudgetTerm& term : info.budget.terms)
    (term.source ? sources : sinks).set(term.name, number(term.kilograms));
  value.set("sources_kg", std::move(sources));
  value.set("sinks_kg", std::move(sinks));
  value.set("relative_imbalance", number(info.budget.relativeImbalance()));
  JsonValue figures = JsonValue::object(), stages = JsonValue::object();
  for (const auto& [name, figure] : info.figures) figures.set(name, number(figure));
  for (const StageTime& stage : info.timings.table()) stages.set(stage.name, number(stage.seconds));
  value.set("figures", std::move(figures));
  value.set("stages_s", std::move(stages));
  return value;
}

std::string termsText(const JsonValue& terms) {
  std::string text;
  for (const JsonValue::Member& member : terms.members)
    text += fmt::format("{}{} {:.9g}", text.empty() ? "" : ", ", member.key, member.value.number);
  return text.empty() ? "nothing" : text;
}

double numberAt(const JsonValue& value, const char* key) {
  const JsonValue* found = value.find(key);
  return found ? found->number : 0.0;
}

std::string textAt(const JsonValue& value, const char* key) {
  const JsonValue* found = value.find(key);
  return found ? found->text : std::string();
}

std::string frameText(const JsonValue& frame) {
  std::string text =
      fmt::format("frame {} (film {:.4g} s, weather {:.6g} s, {})\n", numberAt(frame, "frame"),
                  numberAt(frame, "film_s"), numberAt(frame, "weather_s"), textAt(frame, "backend"));
  text += fmt::format("  mass, kg: {} = {}; imbalance {:.2e}\n", termsText(*frame.find("sources_kg")),
                      termsText(*frame.find("sinks_kg")), numberAt(frame, "relative_imbalance"));
  if (!frame.find("figures")->members.empty())
    text += fmt::format("  figures: {}\n", termsText(*frame.find("figures")));
  if (!frame.find("stages_s")->members.empty())
    text += fmt::format("  stages, s: {}\n", termsText(*frame.find("stages_s")));
  return text;
}

std::string assetsText(const JsonValue& info) {
  std::string text;
  if (const JsonValue* t = info.find("terrain")) {
    const auto& heights = t->find("height_m")->items;
    text += fmt::format(
        "terrain: {} x {} cells of {} m, heights {:.2f} to {:.2f} m, holes {:.2f} %, EPSG {}\n",
        numberAt(*t, "columns"), numberAt(*t, "rows"), numberAt(*t, "cell_size_m"), heights[0].number,
        heights[1].number, 100.0 * numberAt(*t, "holes_share"), numberAt(*t, "epsg"));
  }
  for (const JsonValue& model : info.find("models")->items) {
    const auto& size = model.find("size_m")->items;
    text += fmt::format("model {}: {} triangles, {:.2f} x {:.2f} x {:.2f} m, {} textures\n",
                        textAt(model, "node"), numberAt(model, "triangles"), size[0].number, size[1].number,
                        size[2].number, numberAt(model, "textures"));
  }
  return text;
}

}  // namespace

JsonValue sceneInfo(const OpenedScene& opened, FrameStore& store, FrameRange frames) {
  const std::vector<FrameState> states = store.states(frames.last + 1);
  JsonValue info = JsonValue::object();
  info.set("scene", JsonValue::of(opened.file));
  info.set("nodes", nodesInfo(opened));
  if (opened.snapshot->terrain) info.set("terrain", terrainInfo(*opened.snapshot->terrain));
  info.set("models", modelsInfo(*opened.snapshot));
  info.set("cache", cacheInfo(store, states));
  std::vector<JsonValue> cached;
  for (int frame = frames.first; frame <= frames.last; ++frame)
    if (const FramePointer found = store.get(frame)) cached.push_back(frameInfo(found->info));
  info.set("frames", JsonValue::array(std::move(cached)));
  return info;
}

std::string infoText(const JsonValue& info) {
  std::string text = fmt::format("scene {}\n", textAt(info, "scene"));
  for (const JsonValue& node : info.find("nodes")->items) {
    text += fmt::format("node {}: {}", textAt(node, "id"), textAt(node, "type"));
    if (node.find("file")) text += fmt::format(", {}", textAt(node, "file"));
    if (node.find("enabled")) text += ", disabled";
    if (node.find("problem")) text += fmt::format(" [{}]", textAt(node, "problem"));
    text += "\n";
  }
  text += assetsText(info);
  const JsonValue& cache = *info.find("cache");
  text += fmt::format(
      "cache {}: {} frames ready, {} stale, {} missing; {:.1f} MB on disk, {:.1f} MB of them stale\n",
      textAt(cache, "folder"), numberAt(cache, "ready"), numberAt(cache, "stale"), numberAt(cache, "missing"),
      numberAt(cache, "disk_bytes") / 1e6, numberAt(cache, "stale_bytes") / 1e6);
  for (const JsonValue& frame : info.find("frames")->items) text += frameText(frame);
  return text;
}

}  // namespace spin
