// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "core/nodes/node_registry.h"
#include "core/property/text_check.h"
#include "core/scene/migrations.h"
#include "core/scene/scene_file.h"
#include "core/scene/value_json.h"

namespace spin {
namespace {

using Kind = JsonValue::Kind;

constexpr std::size_t kMaxNodes = 10'000;
constexpr std::size_t kMaxNameBytes = 256;
/// So many problems of one file are told at once.
constexpr std::size_t kMaxProblems = 20;
constexpr std::array<std::string_view, 6> kRootKeys{"format",    "schema", "min_reader",
                                                    "generator", "nodes",  "asset_hashes"};
constexpr std::array<std::string_view, 5> kNodeKeys{"id", "type", "name", "enabled", "properties"};
const char* const kUnusable = "The scene cannot be read";

bool contains(std::span<const std::string_view> keys, std::string_view key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

Error unknownKey(const std::string& key, std::span<const std::string_view> known, const std::string& where) {
  const std::string_view near = nearestName(key, known);
  return badInput(kUnusable, where, fmt::format("the key \"{}\" is unknown", printable(key.substr(0, 80))),
                  near.empty() ? std::string() : fmt::format("Did you mean \"{}\"?", near));
}

Result<int> headNumber(const JsonValue& root, const char* key, const std::string& name) {
  const JsonValue* json = root.find(key);
  if (!json || !json->is(Kind::Number) || json->number != std::floor(json->number) || json->number < 1 ||
      json->number > 1e6)
    return badInput(kUnusable, json ? placeOf(name, *json) : name,
                    fmt::format("{} is missing or no whole number from 1 on", key));
  return static_cast<int>(json->number);
}

/// Reads one file. With keepUnknown (a newer minor version) what it does not know goes to the extras. A
/// problem within a node does not hide those of the others: all are told at once.
class SceneReader {
 public:
  SceneReader(std::string name, bool keepUnknown) : m_name(std::move(name)), m_keepUnknown(keepUnknown) {}

  Status read(const JsonValue& root) {
    for (const JsonValue::Member& member : root.members) {
      if (contains(kRootKeys, member.key)) continue;
      if (m_keepUnknown)
        m_keptRoot.set(member.key, member.value);
      else
        note(unknownKey(member.key, kRootKeys, placeOf(m_name, member.value)));
    }
    const JsonValue* nodes = root.find("nodes");
    if (!nodes || !nodes->is(Kind::Array)) {
      note(badInput(kUnusable, nodes ? placeOf(m_name, *nodes) : m_name, "nodes is missing or no array"));
      return result();
    }
    if (nodes->items.size() > kMaxNodes)
      return badInput(kUnusable, m_name, fmt::format("more than {} nodes", kMaxNodes));
    for (std::size_t i = 0; i < nodes->items.size(); ++i) note(readNode(nodes->items[i], i));
    note(readHashes(root.find("asset_hashes")));
    return result();
  }

  LoadedScene take() {
    JsonValue kept = JsonValue::object();
    if (!m_keptRoot.members.empty()) kept.set("root", std::move(m_keptRoot));
    if (!m_keptNodes.members.empty()) kept.set("nodes", std::move(m_keptNodes));
    if (!m_others.items.empty()) kept.set("others", std::move(m_others));
    if (!kept.members.empty()) m_loaded.extras.unknownJson = writeJson(kept);
    return std::move(m_loaded);
  }

 private:
  void note(const Status& status) {
    if (!status) m_problems.push_back(status.error());
  }

  /// One error for all: the first one, with the others as lines below it.
  Status result() const {
    if (m_problems.empty()) return {};
    Error error = m_problems.front();
    for (std::size_t i = 1; i < std::min(m_problems.size(), kMaxProblems); ++i) {
      const Error& other = m_problems[i];
      if (i > 1) error.more += "\n";
      error.more += fmt::format("{}: {}", other.where, other.why);
      if (!other.advice.empty()) error.more += ". " + other.advice;
    }
    if (m_problems.size() > kMaxProblems)
      error.more += fmt::format("\nand {} more problems", m_problems.size() - kMaxProblems);
    return error;
  }

  Status readNode(const JsonValue& json, std::size_t index) {
    const std::string place = placeOf(m_name, json);
    if (!json.is(Kind::Object))
      return badInput(kUnusable, place,
                      fmt::format("expected is a node as an object, found {}", kindText(json.kind)));
    const JsonValue *id = json.find("id"), *type = json.find("type");
    if (!id || !id->is(Kind::Text) || !isValidNodeId(id->text))
      return badInput(kUnusable, place,
                      "the id of a node is missing or not of lower-case letters, digits and '_'");
    const std::string where = fmt::format("{}: {}", m_name, id->text);
    if (!type || !type->is(Kind::Text))
      return badInput(kUnusable, placeOf(where, json), "the type of the node is missing or no text");
    const NodeType* nodeType = findNodeType(type->text);
    if (!nodeType && m_keepUnknown) return keepNode(json, index);
    if (!nodeType) return unknownNodeType(type->text, placeOf(where, *type));
    SceneNode node = makeNode(*nodeType, id->text, nodeType->label);
    readMembers(node, json, where);
    if (const JsonValue* properties = json.find("properties")) readProperties(node, *properties, where);
    Status added = m_loaded.scene.append(std::move(node));
    if (added) return added;
    Error error = added.error();
    error.where = placeOf(where, json);
    return error;
  }

  Status keepNode(const JsonValue& json, std::size_t index) {
    JsonValue other = JsonValue::object();
    other.set("index", JsonValue::of(static_cast<double>(index)));
    other.set("node", json);
    m_others.items.push_back(std::move(other));
    m_loaded.extras.messages.push_back(fmt::format(
        "{}: made by a newer version; this version does not show it but keeps it", json.find("id")->text));
    return {};
  }

  JsonValue& keptOf(const std::string& node, const char* part) {
    if (!m_keptNodes.find(node)) m_keptNodes.set(node, JsonValue::object());
    JsonValue& kept = *m_keptNodes.find(node);
    if (!kept.find(part)) kept.set(part, JsonValue::object());
    return *kept.find(part);
  }

  void readMembers(SceneNode& node, const JsonValue& json, const std::string& where) {
    for (const JsonValue::Member& member : json.members) {
      if (contains(kNodeKeys, member.key)) continue;
      if (m_keepUnknown)
        keptOf(node.id, "members").set(member.key, member.value);
      else
        note(unknownKey(member.key, kNodeKeys, placeOf(where, member.value)));
    }
    if (const JsonValue* name = json.find("name")) {
      if (!name->is(Kind::Text) || name->text.size() > kMaxNameBytes || !isCleanText(name->text))
        note(badInput(kUnusable, placeOf(where, *name),
                      fmt::format("the name is no text of {} bytes at most", kMaxNameBytes)));
      else
        node.name = name->text;
    }
    if (const JsonValue* enabled = json.find("enabled")) {
      if (enabled->is(Kind::Bool))
        node.enabled = enabled->boolean;
      else
        note(badInput(kUnusable, placeOf(where, *enabled), "enabled is not true or false"));
    }
  }

  void readProperties(SceneNode& node, const JsonValue& json, const std::string& where) {
    if (!json.is(Kind::Object))
      return note(badInput(kUnusable, placeOf(where, json), "properties is no object"));
    for (const JsonValue::Member& member : json.members) {
      if (const PropertyInfo* property = node.type->find(member.key))
        note(readProperty(node, *property, member.value, where));
      else if (m_keepUnknown)
        keptOf(node.id, "properties").set(member.key, member.value);
      else
        note(unknownProperty(*node.type, member.key, placeOf(where, member.value)));
    }
  }

  static Status readProperty(SceneNode& node, const PropertyInfo& property, const JsonValue& json,
                             const std::string& where) {
    const JsonValue* plain = &json;
    if (json.is(Kind::Object)) {
      for (const JsonValue::Member& member : json.members)
        if (member.key != "keys" && member.key != "value")
          return unknownKey(member.key, std::array<std::string_view, 2>{"keys", "value"},
                            placeOf(where, member.value));
      const JsonValue* keys = json.find("keys");
      if (!keys) return badInput(kUnusable, placeOf(where, json), fmt::format("{} has no keys", property.id));
      Result<AnimationCurve> curve = curveFromJson(property, *keys, where);
      if (!curve) return curve.error();
      node.curves[property.id] = std::move(*curve);
      plain = json.find("value");
    }
    if (!plain) return {};
    Result<Value> value = valueFromJson(property, *plain, where);
    if (!value) return value.error();
    setPlainValue(node, property, *value);
    return {};
  }

  Status readHashes(const JsonValue* json) {
    if (!json) return {};
    for (const JsonValue::Member& member : json->members) {
      const std::string& text = member.value.text;
      Hash128 hash;
      const auto digits = [&](std::size_t from, std::uint64_t& out) {
        const char* const end = text.data() + from + 16;
        const auto [stop, code] = std::from_chars(text.data() + from, end, out, 16);
        return code == std::errc() && stop == end;
      };
      if (!member.value.is(Kind::Text) || text.size() != 32 || !digits(0, hash.high) || !digits(16, hash.low))
        return badInput(kUnusable, placeOf(m_name, member.value),
                        "a hash in asset_hashes has not 32 hexadecimal digits");
      if (m_loaded.scene.find(member.key)) m_loaded.extras.assetHashes[member.key] = hash;
    }
    return {};
  }

  std::string m_name;
  bool m_keepUnknown;
  LoadedScene m_loaded;
  JsonValue m_keptRoot = JsonValue::object();
  JsonValue m_keptNodes = JsonValue::object();
  JsonValue m_others = JsonValue::array();
  std::vector<Error> m_problems;
};

}  // namespace

Result<LoadedScene> readSceneText(const std::string& text, const std::string& nameForMessages) {
  if (text.size() > kMaxSceneBytes)
    return badInput(kUnusable, nameForMessages,
                    fmt::format("the file is larger than {} MiB", kMaxSceneBytes >> 20));
  Result<JsonValue> root = parseJson(text, nameForMessages);
  if (!root) return root.error();
  const JsonValue* format = root->find("format");
  if (!format || !format->is(Kind::Text) || format->text != "spindrift-scene")
    return badInput(kUnusable, nameForMessages,
                    "it is no Spindrift scene: \"format\" is not \"spindrift-scene\"");
  Result<int> schema = headNumber(*root, "schema", nameForMessages);
  if (!schema) return schema.error();
  Result<int> minReader = headNumber(*root, "min_reader", nameForMessages);
  if (!minReader) return minReader.error();
  if (*minReader > kSceneSchema)
    return badInput(
        kUnusable, nameForMessages,
        fmt::format("it was written by a newer version and asks for schema {}; this version knows {}",
                    *minReader, kSceneSchema),
        "Update Spindrift to open it");
  std::vector<std::string> messages;
  migrate(*root, *schema, messages);
  SceneReader reader(nameForMessages, *schema > kSceneSchema);
  if (Status status = reader.read(*root); !status) return status.error();
  LoadedScene loaded = reader.take();
  loaded.extras.schema = *schema;
  loaded.extras.minReader = *minReader;
  loaded.extras.messages.insert(loaded.extras.messages.begin(), messages.begin(), messages.end());
  return loaded;
}

}  // namespace spin
