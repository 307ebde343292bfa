// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/air/air_recut.h"

#include <algorithm>

namespace spin {
namespace {

constexpr std::array<int, 3> kAlong{kBrickX, kBrickY, kBrickZ};

class RecutPlanner {
 public:
  RecutPlanner(const AirWindow& window, const std::vector<BrickSolids>& solids, const BricksBefore& before)
      : m_window(window), m_solids(solids), m_before(before) {}

  RecutPlan plan() {
    for (const auto& [place, old] : m_before) {
      const BrickKey& key = m_window.nearKeys()[place];
      if (m_window.activePlace(key) < 0) continue;
      for (int c = 0; c < static_cast<int>(kBrickCells); ++c)
        if (old.volume[static_cast<std::size_t>(c)] != m_solids[place].volume[static_cast<std::size_t>(c)])
          slotOf({key[0] * kBrickX + c % kBrickX, key[1] * kBrickY + c / kBrickX % kBrickY,
                  key[2] * kBrickZ + c / (kBrickX * kBrickY)});
    }
    std::vector<std::uint32_t> closing;
    for (std::uint32_t k = 0; k < m_cells.size(); ++k)
      if (m_plan.volume[k] > 0.0 && m_plan.volumeAfter[k] == 0.0) closing.push_back(k);
    giveOn(closing);
    return std::move(m_plan);
  }

 private:
  /// A cell's place in the lists; it comes into them where it is not.
  std::uint32_t slotOf(const CellKey& cell) {
    const std::uint32_t index = activeIndex(m_window, cell);
    const auto [found, fresh] = m_slots.try_emplace(index, static_cast<std::uint32_t>(m_cells.size()));
    if (fresh) {
      const BrickKey key = brickOf(cell);
      const std::size_t in = cellInBrick(cell, key);
      m_cells.push_back(cell);
      m_plan.index.push_back(index);
      m_plan.volume.push_back(static_cast<double>(oldBrick(key).volume[in]));
      m_plan.volumeAfter.push_back(static_cast<double>(newBrick(key).volume[in]));
    }
    return found->second;
  }
  const BrickSolids& newBrick(const BrickKey& key) const {
    return m_solids[static_cast<std::size_t>(m_window.nearPlace(key))];
  }
  const BrickSolids& oldBrick(const BrickKey& key) const {
    const auto place = static_cast<std::size_t>(m_window.nearPlace(key));
    const auto found = m_before.find(place);
    return found == m_before.end() ? m_solids[place] : found->second;
  }

  /// Cells beyond a cell's faces that were open, where bricks are computed.
  std::vector<CellKey> neighbours(const CellKey& cell) const {
    std::vector<CellKey> found;
    for (std::size_t a = 0; a < 3; ++a)
      for (const int side : {-1, 1}) {
        CellKey there = cell;
        there[a] += side;
        const CellKey& face = side < 0 ? cell : there;
        const BrickKey key = brickOf(face);
        if (oldBrick(key).area[a][cellInBrick(face, key)] > 0.0f && m_window.activePlace(brickOf(there)) >= 0)
          found.push_back(there);
      }
    return found;
  }

  /// Layer by layer from those that open cells lie beside; the farthest layer gives first.
  void giveOn(const std::vector<std::uint32_t>& closing) {
    std::vector<std::uint32_t> layerOf(m_cells.size(), 0);
    std::vector<std::vector<std::uint32_t>> layers(1);
    std::vector<std::vector<std::uint32_t>> beside(m_cells.size());
    for (const std::uint32_t k : closing) {
      layerOf[k] = kFar;
      for (const CellKey& cell : neighbours(m_cells[k])) {
        const std::size_t in = cellInBrick(cell, brickOf(cell));
        if (oldBrick(brickOf(cell)).volume[in] > 0.0f || newBrick(brickOf(cell)).volume[in] > 0.0f)
          beside[k].push_back(slotOf(cell));
      }
    }
    layerOf.resize(m_cells.size(), 0);
    std::vector<std::uint32_t> rest = closing;
    for (std::uint32_t layer = 1; !rest.empty(); ++layer) {
      std::vector<std::uint32_t> reached, left;
      for (const std::uint32_t k : rest) {
        const bool next = std::any_of(beside[k].begin(), beside[k].end(),
                                      [&](std::uint32_t n) { return layerOf[n] == layer - 1; });
        (next ? reached : left).push_back(k);
      }
      if (reached.empty()) break;
      for (const std::uint32_t k : reached) layerOf[k] = layer;
      layers.push_back(std::move(reached));
      rest = std::move(left);
    }
    for (const std::uint32_t k : rest) m_plan.gifts.push_back({k, RecutPlan::kLost, 1.0});
    for (std::size_t layer = layers.size(); layer-- > 1;)
      for (const std::uint32_t k : layers[layer]) give(k, beside[k], layerOf);
  }

  /// To those of the layer before, by their volume.
  void give(std::uint32_t from, const std::vector<std::uint32_t>& beside,
            const std::vector<std::uint32_t>& layerOf) {
    double sum = 0.0;
    const auto weight = [&](std::uint32_t to) {
      return layerOf[to] == 0 ? m_plan.volumeAfter[to] : m_plan.volume[to];
    };
    for (const std::uint32_t to : beside)
      if (layerOf[to] + 1 == layerOf[from]) sum += weight(to);
    for (const std::uint32_t to : beside)
      if (layerOf[to] + 1 == layerOf[from]) m_plan.gifts.push_back({from, to, weight(to) / sum});
  }

  static constexpr std::uint32_t kFar = UINT32_MAX - 1;

  const AirWindow& m_window;
  const std::vector<BrickSolids>& m_solids;
  const BricksBefore& m_before;
  RecutPlan m_plan;
  std::vector<CellKey> m_cells;
  std::map<std::uint32_t, std::uint32_t> m_slots;  ///< by index
};

}  // namespace

RecutPlan planRecut(const AirWindow& window, const std::vector<BrickSolids>& solids,
                    const BricksBefore& before) {
  return RecutPlanner(window, solids, before).plan();
}

double applyRecut(const RecutPlan& plan, bool mixes, std::vector<float>& values) {
  std::vector<double> content(values.size()), room(values.size(), 0.0);
  for (std::size_t k = 0; k < values.size(); ++k) {
    content[k] = static_cast<double>(values[k]) * plan.volume[k];
    room[k] = plan.volumeAfter[k] > 0.0 ? plan.volumeAfter[k] : plan.volume[k];
  }
  double lost = 0.0;
  for (const RecutPlan::Gift& gift : plan.gifts) {
    if (gift.to == RecutPlan::kLost) {
      lost += content[gift.from];
      continue;
    }
    content[gift.to] += gift.share * content[gift.from];
    room[gift.to] += gift.share * room[gift.from];
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double after = plan.volumeAfter[k];
    const double value = after > 0.0 ? content[k] / (mixes ? room[k] : after) : 0.0;
    values[k] = static_cast<float>(value);
    if (after > 0.0) lost += content[k] - value * after;
  }
  return lost;
}

}  // namespace spin
