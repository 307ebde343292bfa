// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/property/scene_node.h"

namespace spin {

/// The scene as a value: an ordered list of nodes. The editor's document wraps it with undo; the command line
/// uses it as it is. Node ids are unique.
class Scene {
 public:
  const std::vector<SceneNode>& nodes() const { return m_nodes; }
  const SceneNode* find(const std::string& id) const;
  SceneNode* find(const std::string& id);
  /// First node of a type; nullptr if there is none.
  const SceneNode* firstOf(const NodeType& type) const;

  /// Inserts at a position (clamped). The id must be free and valid; a `single` type must not be there
  /// already.
  Status insert(SceneNode node, std::size_t position);
  Status append(SceneNode node) { return insert(std::move(node), m_nodes.size()); }
  bool remove(const std::string& id);
  void move(std::size_t from, std::size_t to);

  /// "tree", "tree_2", ...: a free id from a wish.
  std::string freeId(const std::string& wish) const;
  /// Sets `node.property` from the command line's text and ends its animation; errors name the nearest known
  /// node or property.
  Status setFromText(const std::string& path, const std::string& valueText);

 private:
  std::vector<SceneNode> m_nodes;
};

/// True for [a-z][a-z0-9_]*, 64 characters at most.
bool isValidNodeId(std::string_view id);
/// Errors that name the nearest known property or type.
Error unknownProperty(const NodeType& type, std::string_view propertyId, const std::string& where);
Error unknownNodeType(std::string_view typeId, const std::string& where);

/// A new scene with weather, camera, picture and simulation settings.
Scene makeDefaultScene();

}  // namespace spin
