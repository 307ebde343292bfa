// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/scene/scene_file.h"
#include "core/scene/value_json.h"

namespace spin {
namespace {

using Kind = JsonValue::Kind;

JsonValue propertiesJson(const SceneNode& node) {
  JsonValue properties = JsonValue::object();
  for (const PropertyRow& row : node.type->properties) {
    const Value plain = plainValue(node, row);
    const bool isDefault = plain == defaultValue(*node.type, row);
    const auto curve = node.curves.find(row.id);
    if (curve != node.curves.end() && !curve->second.empty()) {
      JsonValue animated = JsonValue::object();
      animated.set("keys", toJson(row, curve->second));
      if (!isDefault) animated.set("value", toJson(row, plain));
      properties.set(row.id, std::move(animated));
    } else if (!isDefault) {
      properties.set(row.id, toJson(row, plain));
    }
  }
  return properties;
}

void addMembers(JsonValue& to, const JsonValue* from) {
  if (!from) return;
  for (const JsonValue::Member& member : from->members)
    if (!to.find(member.key)) to.set(member.key, member.value);
}

JsonValue nodeJson(const SceneNode& node, const JsonValue* kept) {
  JsonValue json = JsonValue::object();
  json.set("id", JsonValue::of(node.id));
  json.set("type", JsonValue::of(node.type->id));
  if (node.name != node.type->label) json.set("name", JsonValue::of(node.name));
  if (!node.enabled) json.set("enabled", JsonValue::of(false));
  JsonValue properties = propertiesJson(node);
  if (kept) {
    addMembers(properties, kept->find("properties"));
    addMembers(json, kept->find("members"));
  }
  if (!properties.members.empty()) json.set("properties", std::move(properties));
  return json;
}

/// Puts nodes of unknown types back where they stood.
void insertOthers(std::vector<JsonValue>& nodes, const JsonValue* others) {
  if (!others) return;
  for (const JsonValue& other : others->items) {
    const auto index = static_cast<std::size_t>(other.find("index")->number);
    nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(std::min(index, nodes.size())),
                 *other.find("node"));
  }
}

JsonValue keptJson(const SceneFileExtras& extras) {
  if (extras.unknownJson.empty()) return JsonValue::object();
  Result<JsonValue> kept = parseJson(extras.unknownJson, "kept keys");
  SPIN_CHECK(kept.ok(), kept.error().text());
  return std::move(*kept);
}

}  // namespace

std::string writeSceneText(const Scene& scene, const SceneFileExtras& extras) {
  const JsonValue kept = keptJson(extras);
  const bool newer = extras.schema > kSceneSchema;
  JsonValue root = JsonValue::object();
  root.set("format", JsonValue::of("spindrift-scene"));
  root.set("schema", JsonValue::of(static_cast<double>(newer ? extras.schema : kSceneSchema)));
  root.set("min_reader", JsonValue::of(static_cast<double>(newer ? std::max(extras.minReader, kSceneMinReader)
                                                                 : kSceneMinReader)));
  root.set("generator", JsonValue::of("spindrift " SPIN_VERSION));
  JsonValue nodes = JsonValue::array();
  const JsonValue* keptNodes = kept.find("nodes");
  for (const SceneNode& node : scene.nodes())
    nodes.items.push_back(nodeJson(node, keptNodes ? keptNodes->find(node.id) : nullptr));
  insertOthers(nodes.items, kept.find("others"));
  root.set("nodes", std::move(nodes));
  JsonValue hashes = JsonValue::object();
  for (const auto& [id, hash] : extras.assetHashes)
    if (scene.find(id) && !hash.isNull()) hashes.set(id, JsonValue::of(hash.hex()));
  if (!hashes.members.empty()) root.set("asset_hashes", std::move(hashes));
  addMembers(root, kept.find("root"));
  static constexpr std::array<const char*, 4> kHead{"format", "schema", "min_reader", "generator"};
  return writeJson(root, kHead);
}

}  // namespace spin
