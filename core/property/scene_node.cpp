// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/property/scene_node.h"

#include "core/base/check.h"

namespace spin {

SceneNode makeNode(const NodeType& type, std::string id, std::string name) {
  SceneNode node;
  node.id = std::move(id);
  node.name = std::move(name);
  node.type = &type;
  node.data = type.create();
  return node;
}

Value plainValue(const SceneNode& node, const PropertyInfo& property) {
  SPIN_DCHECK(node.type && node.type->find(property.id) == &property, "property of another type");
  return property.get(*node.data);
}

void setPlainValue(SceneNode& node, const PropertyInfo& property, const Value& value) {
  SPIN_DCHECK(node.type && node.type->find(property.id) == &property, "property of another type");
  SPIN_DCHECK(validate(property, value).ok(), "unchecked value");
  std::unique_ptr<NodeData> data = node.type->clone(*node.data);
  property.set(*data, value);
  node.data = std::move(data);
}

Value valueAt(const SceneNode& node, const PropertyInfo& property, double filmTime) {
  const auto found = node.curves.find(property.id);
  if (found == node.curves.end() || found->second.empty()) return plainValue(node, property);
  return found->second.at(filmTime);
}

std::unique_ptr<NodeData> evaluate(const SceneNode& node, double filmTime) {
  std::unique_ptr<NodeData> data = node.type->clone(*node.data);
  for (const auto& [id, curve] : node.curves) {
    const PropertyInfo* property = node.type->find(id);
    if (property && !curve.empty()) property->set(*data, curve.at(filmTime));
  }
  return data;
}

}  // namespace spin
