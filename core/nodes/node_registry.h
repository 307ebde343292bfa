// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "core/property/property_table.h"

namespace spin {

/// All kinds of nodes, in the order menus show them. A new kind adds its header, its table and one line here.
std::span<const NodeType* const> nodeTypes();
/// nullptr if there is none.
const NodeType* findNodeType(std::string_view id);

/// Whether its nodes carry a painted layer of the terrain's size (SceneNode::painted).
bool isPaintedType(const NodeType& type);

}  // namespace spin
