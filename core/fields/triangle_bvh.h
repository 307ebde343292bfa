// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/cancel.h"
#include "core/math/vec.h"

namespace spin {

/// Three corners and where the triangle came from.
struct BvhTriangle {
  std::array<Vec3f, 3> corners{};
  std::uint32_t geometry = 0;
  std::uint32_t triangle = 0;
};

/// A node of the flat tree. Inner: children at `first` and `first` + 1. Leaf (count > 0): triangles
/// first .. first + count - 1.
struct BvhNode {
  Vec3f low{}, high{};
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// Bounding-volume hierarchy over triangles, split by the binned surface-area heuristic (Wald 2007).
class TriangleBvh {
 public:
  /// Reorders the triangles to lie leaf by leaf. False, and an empty tree, when cancelled.
  bool build(std::vector<BvhTriangle> triangles, const CancelToken& cancel = {});
  const std::vector<BvhNode>& nodes() const { return m_nodes; }
  const std::vector<BvhTriangle>& triangles() const { return m_triangles; }

 private:
  struct Item;
  bool split(std::uint32_t node, std::vector<Item>& items, std::size_t begin, std::size_t end,
             const CancelToken& cancel);

  std::vector<BvhNode> m_nodes;
  std::vector<BvhTriangle> m_triangles;
};

}  // namespace spin
