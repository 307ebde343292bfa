// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/triangle_bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/check.h"

namespace spin {
namespace {

constexpr std::size_t kLeafSize = 4;
constexpr int kBins = 16;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Box {
  Vec3f low{kInfinity, kInfinity, kInfinity};
  Vec3f high{-kInfinity, -kInfinity, -kInfinity};

  void extend(Vec3f p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  void extend(const Box& b) { extend(b.low), extend(b.high); }
  float area() const {
    const Vec3f d = high - low;
    return d.x < 0.0f ? 0.0f : d.x * d.y + d.y * d.z + d.z * d.x;
  }
};

}  // namespace

struct TriangleBvh::Item {
  Box box;
  Vec3f centre{};
  std::uint32_t index = 0;
};

namespace {

struct Cut {
  int axis = -1;
  int bin = 0;
  float cost = kInfinity;
};

int binOf(float value, float low, float scale) {
  return std::clamp(static_cast<int>((value - low) * scale), 0, kBins - 1);
}

/// Best plane of one axis by the sum over both sides of area x count.
template <class Item>
void tryAxis(const std::vector<Item>& items, std::size_t begin, std::size_t end, const Box& centres, int axis,
             Cut& best) {
  const float low = centres.low[axis], extent = centres.high[axis] - low;
  if (!(extent > 0.0f)) return;
  const float scale = static_cast<float>(kBins) / extent;
  std::array<Box, kBins> boxes;
  std::array<std::size_t, kBins> counts{};
  for (std::size_t i = begin; i < end; ++i) {
    const auto b = static_cast<std::size_t>(binOf(items[i].centre[axis], low, scale));
    boxes[b].extend(items[i].box);
    ++counts[b];
  }
  std::array<float, kBins> right{};
  Box box;
  std::size_t count = 0;
  for (std::size_t b = kBins - 1; b > 0; --b) {
    box.extend(boxes[b]);
    right[b] = box.area() * static_cast<float>(count += counts[b]);
  }
  box = Box();
  count = 0;
  for (std::size_t b = 1; b < kBins; ++b) {
    box.extend(boxes[b - 1]);
    const float cost = box.area() * static_cast<float>(count += counts[b - 1]) + right[b];
    if (count > 0 && count < end - begin && cost < best.cost) best = {axis, static_cast<int>(b), cost};
  }
}

}  // namespace

bool TriangleBvh::build(std::vector<BvhTriangle> triangles, const CancelToken& cancel) {
  SPIN_CHECK(triangles.size() < (std::size_t{1} << 31), "too many triangles for one scene");
  m_nodes.clear();
  m_triangles.clear();
  if (triangles.empty()) return true;
  std::vector<Item> items(triangles.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (const Vec3f& corner : triangles[i].corners) items[i].box.extend(corner);
    items[i].centre = (items[i].box.low + items[i].box.high) * 0.5f;
    items[i].index = static_cast<std::uint32_t>(i);
  }
  m_nodes.reserve(triangles.size());
  m_nodes.emplace_back();
  if (!split(0, items, 0, items.size(), cancel)) {
    m_nodes.clear();
    return false;
  }
  m_triangles.reserve(triangles.size());
  for (const Item& item : items) m_triangles.push_back(triangles[item.index]);
  return true;
}

bool TriangleBvh::split(std::uint32_t node, std::vector<Item>& items, std::size_t begin, std::size_t end,
                        const CancelToken& cancel) {
  if (cancel.cancelled()) return false;
  Box box, centres;
  for (std::size_t i = begin; i < end; ++i) box.extend(items[i].box), centres.extend(items[i].centre);
  m_nodes[node].low = box.low;
  m_nodes[node].high = box.high;
  const std::size_t count = end - begin;
  if (count <= kLeafSize) {
    m_nodes[node].first = static_cast<std::uint32_t>(begin);
    m_nodes[node].count = static_cast<std::uint32_t>(count);
    return true;
  }
  Cut cut;
  for (int axis = 0; axis < 3; ++axis) tryAxis(items, begin, end, centres, axis, cut);
  std::size_t middle = begin + count / 2;
  const auto at = [&](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
  if (cut.axis >= 0) {
    const float low = centres.low[cut.axis];
    const float scale = static_cast<float>(kBins) / (centres.high[cut.axis] - low);
    const auto isLeft = [&](const Item& item) { return binOf(item.centre[cut.axis], low, scale) < cut.bin; };
    middle = static_cast<std::size_t>(std::partition(at(begin), at(end), isLeft) - items.begin());
  }
  // Triangles with one common centre cannot be told apart: they are halved as they lie.
  if (middle == begin || middle == end) middle = begin + count / 2;
  const auto children = static_cast<std::uint32_t>(m_nodes.size());
  m_nodes.resize(m_nodes.size() + 2);
  m_nodes[node].first = children;
  return split(children, items, begin, middle, cancel) && split(children + 1, items, middle, end, cancel);
}

}  // namespace spin
