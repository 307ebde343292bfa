// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/nodes/camera_node.h"
#include "core/nodes/node_registry.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/weather_nodes.h"
#include "core/property/text_check.h"

namespace spin {
namespace {

constexpr std::size_t kMaxIdLength = 64;

std::string didYouMean(std::string_view word, std::span<const std::string_view> candidates) {
  const std::string_view near = nearestName(word, candidates);
  return near.empty() ? std::string() : fmt::format("Did you mean \"{}\"?", near);
}

}  // namespace

bool isValidNodeId(std::string_view id) {
  if (id.empty() || id.size() > kMaxIdLength || id[0] < 'a' || id[0] > 'z') return false;
  return std::all_of(id.begin(), id.end(),
                     [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
}

const SceneNode* Scene::find(const std::string& id) const {
  for (const SceneNode& node : m_nodes)
    if (node.id == id) return &node;
  return nullptr;
}

SceneNode* Scene::find(const std::string& id) {
  return const_cast<SceneNode*>(std::as_const(*this).find(id));
}

const SceneNode* Scene::firstOf(const NodeType& type) const {
  for (const SceneNode& node : m_nodes)
    if (node.type == &type) return &node;
  return nullptr;
}

Status Scene::insert(SceneNode node, std::size_t position) {
  SPIN_CHECK(node.type && node.data, "node without type or data");
  const std::string what = "The node cannot be added";
  if (!isValidNodeId(node.id))
    return badInput(what, printable(node.id), "its id is not of lower-case letters, digits and '_'");
  if (find(node.id)) return badInput(what, node.id, "the id is taken", "Choose another id");
  if (node.type->single && firstOf(*node.type))
    return badInput(what, node.id, fmt::format("a scene has one node of type {} at most", node.type->id),
                    "Change the one that is there");
  m_nodes.insert(m_nodes.begin() + static_cast<std::ptrdiff_t>(std::min(position, m_nodes.size())),
                 std::move(node));
  return {};
}

bool Scene::remove(const std::string& id) {
  return std::erase_if(m_nodes, [&](const SceneNode& node) { return node.id == id; }) > 0;
}

void Scene::move(std::size_t from, std::size_t to) {
  SPIN_CHECK_LT(from, m_nodes.size());
  SPIN_CHECK_LT(to, m_nodes.size());
  const auto at = [&](std::size_t i) { return m_nodes.begin() + static_cast<std::ptrdiff_t>(i); };
  if (from < to)
    std::rotate(at(from), at(from + 1), at(to + 1));
  else
    std::rotate(at(to), at(from), at(from + 1));
}

std::string Scene::freeId(const std::string& wish) const {
  std::string base;
  for (const char c : wish.substr(0, kMaxIdLength - 8)) {
    const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const bool plain = (lower >= 'a' && lower <= 'z') || (lower >= '0' && lower <= '9');
    if (plain)
      base += lower;
    else if (!base.empty() && base.back() != '_')
      base += '_';
  }
  while (!base.empty() && base.back() == '_') base.pop_back();
  if (base.empty() || base[0] < 'a' || base[0] > 'z') base = base.empty() ? "node" : "node_" + base;
  std::string id = base;
  for (int number = 2; find(id); ++number) id = fmt::format("{}_{}", base, number);
  return id;
}

Status Scene::setFromText(const std::string& path, const std::string& valueText) {
  const std::size_t dot = path.find('.');
  if (dot == std::string::npos)
    return Error{
        ErrorKind::Usage, "The setting is unclear", printable(path), "expected is node.property=value", {}};
  const std::string nodeId = path.substr(0, dot), propertyId = path.substr(dot + 1);
  SceneNode* node = find(nodeId);
  if (!node) {
    std::vector<std::string_view> ids;
    for (const SceneNode& other : m_nodes) ids.push_back(other.id);
    return badInput("The scene has no such node", printable(nodeId), "no node has this id",
                    didYouMean(nodeId, ids));
  }
  const PropertyInfo* property = node->type->find(propertyId);
  if (!property) return unknownProperty(*node->type, propertyId, nodeId);
  Result<Value> value = parseValue(*property, valueText);
  if (!value) return value.error();
  setPlainValue(*node, *property, *value);
  node->curves.erase(propertyId);
  return {};
}

Error unknownProperty(const NodeType& type, std::string_view propertyId, const std::string& where) {
  std::vector<std::string_view> ids;
  for (const PropertyRow& row : type.properties) ids.push_back(row.id);
  return badInput(fmt::format("\"{}\" is no property of {}", printable(propertyId.substr(0, 80)), type.id),
                  where, "the name is unknown", didYouMean(propertyId, ids));
}

Error unknownNodeType(std::string_view typeId, const std::string& where) {
  std::vector<std::string_view> ids;
  for (const NodeType* type : nodeTypes()) ids.push_back(type->id);
  return badInput(fmt::format("\"{}\" is no type of node", printable(typeId.substr(0, 80))), where,
                  "the name is unknown", didYouMean(typeId, ids));
}

Scene makeDefaultScene() {
  Scene scene;
  for (const NodeType* type : {&kWeatherType, &kCameraType, &kRenderType, &kSimulationType}) {
    const Status status = scene.append(makeNode(*type, type->id, type->label));
    SPIN_CHECK(status.ok(), status.error().text());
  }
  return scene;
}

}  // namespace spin
