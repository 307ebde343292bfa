// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/check.h"
#include "core/property/scene_node.h"

namespace spin::test {

/// A node's data; a node that is not there or of another type ends the test program.
template <class T>
const T& dataOf(const SceneNode* node) {
  SPIN_CHECK(node, "the node is not there");
  const T* data = node->as<T>();
  SPIN_CHECK(data, "the node is of another type");
  return *data;
}

}  // namespace spin::test
