// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <variant>

#include "core/fields/tiled_raster.h"
#include "core/property/animation_curve.h"

namespace spin {

/// A painted raster of the terrain's size: ground types (see GroundType) or temperatures in K; monostate =
/// nothing painted.
using PaintedLayer = std::variant<std::monostate, TiledRaster<std::uint8_t>, TiledRaster<float>>;

/// One node of a scene. A value type: copying is cheap (data and tiles are shared, copy-on-write), so the
/// document, undo steps and snapshots all hold SceneNodes.
struct SceneNode {
  std::string id;    ///< unique in the scene: [a-z][a-z0-9_]*
  std::string name;  ///< shown to the user
  bool enabled = true;
  const NodeType* type = nullptr;
  std::shared_ptr<const NodeData> data;
  std::map<std::string, AnimationCurve>
      curves;  ///< by property id; an animated property ignores its plain value
  PaintedLayer painted;

  template <class T>
  const T* as() const {
    return dynamic_cast<const T*>(data.get());
  }
};

/// A node with defaults.
SceneNode makeNode(const NodeType& type, std::string id, std::string name);
/// Plain value (not the curve's).
Value plainValue(const SceneNode& node, const PropertyInfo& property);
/// Sets the plain value on a fresh copy of the data. The value must have passed validate().
void setPlainValue(SceneNode& node, const PropertyInfo& property, const Value& value);
/// Value at a film time: the curve's where there is one, else the plain one.
Value valueAt(const SceneNode& node, const PropertyInfo& property, double filmTime);
/// All properties at a film time.
std::unique_ptr<NodeData> evaluate(const SceneNode& node, double filmTime);

}  // namespace spin
