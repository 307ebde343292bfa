// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/air_blocks.h"

#include <algorithm>
#include <limits>

namespace spin {
namespace {

constexpr int kSide = AirBlocks::kSide, kPadded = AirBlocks::kPadded;
constexpr std::size_t kBlockCells = std::size_t{kSide} * kSide * kSide;
constexpr int kSlotsAcross = 16;  // of the texture, along x and y
constexpr int kCoarsest = 16;
constexpr std::array<std::int64_t, 3> kBrick{kBrickX, kBrickY, kBrickZ};

std::int64_t floorDiv(std::int64_t a, std::int64_t b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

/// Where the blocks lie when so many cells along each axis become one.
struct Layout {
  int factor = 1;
  std::array<std::int64_t, 3> low{};
  std::array<int, 3> size{};
  std::vector<std::uint16_t> index;
  std::vector<std::array<int, 3>> blocks;  ///< by slot

  /// The block that holds a brick: blocks are whole bricks, or bricks lie whole in a cell.
  std::array<std::int64_t, 3> blockOf(const std::array<std::int32_t, 3>& brick) const {
    std::array<std::int64_t, 3> b{};
    for (std::size_t a = 0; a < 3; ++a)
      b[a] = floorDiv(std::int64_t{brick[a]} * kBrick[a], std::int64_t{kSide} * factor);
    return b;
  }
  std::size_t at(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return static_cast<std::size_t>((z * size[1] + y) * size[0] + x);
  }
  /// Slot of a block, -1 where there is none.
  int slotOf(int x, int y, int z) const {
    if (x < 0 || y < 0 || z < 0 || x >= size[0] || y >= size[1] || z >= size[2]) return -1;
    return index[at(x, y, z)] - 1;
  }
};

/// False where it does not keep within the limits.
bool layOut(const AirPart& air, const std::vector<bool>& used, const AirLimits& limits, Layout& l) {
  constexpr auto kMost = std::numeric_limits<std::int64_t>::max();
  std::array<std::int64_t, 3> low{kMost, kMost, kMost}, high{-kMost, -kMost, -kMost};
  for (std::size_t k = 0; k < used.size(); ++k) {
    if (!used[k]) continue;
    const auto b = l.blockOf(air.bricks[k]);
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], b[a]);
      high[a] = std::max(high[a], b[a]);
    }
  }
  double count = 1.0;
  for (std::size_t a = 0; a < 3; ++a) count *= static_cast<double>(high[a] - low[a] + 1);
  if (count > static_cast<double>(limits.blocks)) return false;
  l.low = low;
  for (std::size_t a = 0; a < 3; ++a) {
    if (high[a] - low[a] >= 2048) return false;  // what OpenGL promises of a 3D texture
    l.size[a] = static_cast<int>(high[a] - low[a] + 1);
  }
  l.index.assign(static_cast<std::size_t>(count), 0);
  l.blocks.clear();
  for (std::size_t k = 0; k < used.size(); ++k) {
    if (!used[k]) continue;
    const auto b = l.blockOf(air.bricks[k]);
    std::uint16_t& slot = l.index[l.at(b[0] - low[0], b[1] - low[1], b[2] - low[2])];
    if (slot != 0) continue;
    if (l.blocks.size() >= std::min<std::size_t>(limits.slots, 65534)) return false;
    l.blocks.push_back(
        {static_cast<int>(b[0] - low[0]), static_cast<int>(b[1] - low[1]), static_cast<int>(b[2] - low[2])});
    slot = static_cast<std::uint16_t>(l.blocks.size());
  }
  return true;
}

/// Sums of the cells, by slot.
std::vector<float> gather(const AirPart& air, const std::vector<bool>& used, const std::vector<float>& values,
                          const Layout& l) {
  std::vector<float> sums(l.blocks.size() * kBlockCells, 0.0f);
  const std::int64_t f = l.factor;
  for (std::size_t k = 0; k < used.size(); ++k) {
    if (!used[k]) continue;
    const auto block = l.blockOf(air.bricks[k]);
    std::array<std::int64_t, 3> first{};  // of the brick, in the part's cells from the block's corner
    for (std::size_t a = 0; a < 3; ++a)
      first[a] = std::int64_t{air.bricks[k][a]} * kBrick[a] - block[a] * kSide * f;
    const auto slot = static_cast<std::size_t>(l.slotOf(static_cast<int>(block[0] - l.low[0]),
                                                        static_cast<int>(block[1] - l.low[1]),
                                                        static_cast<int>(block[2] - l.low[2])));
    float* out = sums.data() + slot * kBlockCells;
    const float* in = values.data() + k * kBrickCells;
    for (std::int64_t z = 0; z < kBrickZ; ++z)
      for (std::int64_t y = 0; y < kBrickY; ++y) {
        float* row = out + ((first[2] + z) / f * kSide + (first[1] + y) / f) * kSide;
        for (std::int64_t x = 0; x < kBrickX; ++x) row[(first[0] + x) / f] += *in++;
      }
  }
  return sums;
}

/// Writes a slot and its rim into the texture.
void writeSlot(const Layout& l, std::size_t slot, const std::vector<float>& sums, int channel,
               AirBlocks& out) {
  const float share = 1.0f / static_cast<float>(l.factor * l.factor * l.factor);
  const std::array<int, 3> block = l.blocks[slot];
  std::array<int, 27> beside{};
  for (int k = 0; k < 27; ++k)
    beside[static_cast<std::size_t>(k)] =
        l.slotOf(block[0] + k % 3 - 1, block[1] + k / 3 % 3 - 1, block[2] + k / 9 - 1);
  const int s = static_cast<int>(slot);
  const std::array<int, 3> corner{s % out.slots[0] * kPadded, s / out.slots[0] % out.slots[1] * kPadded,
                                  s / (out.slots[0] * out.slots[1]) * kPadded};
  const int width = out.slots[0] * kPadded, height = out.slots[1] * kPadded;
  const auto side = [](int at) { return at < 0 ? 0 : at >= kSide ? 2 : 1; };
  for (int z = -1; z <= kSide; ++z)
    for (int y = -1; y <= kSide; ++y) {
      const int turn = 3 * (side(y) + 3 * side(z));
      const std::size_t row = static_cast<std::size_t>(corner[2] + z + 1) * static_cast<std::size_t>(height) +
                              static_cast<std::size_t>(corner[1] + y + 1);
      std::uint16_t* to = out.texels.data() +
                          (row * static_cast<std::size_t>(width) + static_cast<std::size_t>(corner[0])) *
                              static_cast<std::size_t>(out.channels) +
                          channel;
      for (int x = -1; x <= kSide; ++x, to += out.channels) {
        const int neighbour = beside[static_cast<std::size_t>(side(x) + turn)];
        const bool there = neighbour >= 0;
        const auto within = [there](int at) {
          return there ? (at + kSide) % kSide : std::clamp(at, 0, kSide - 1);
        };
        const std::size_t from = there ? static_cast<std::size_t>(neighbour) : slot;
        const int cell = (within(z) * kSide + within(y)) * kSide + within(x);
        *to = halfFromFloat(share * sums[from * kBlockCells + static_cast<std::size_t>(cell)]);
      }
    }
}

}  // namespace

AirBlocks packAir(const AirPart& air, const std::vector<const std::vector<float>*>& values, float least,
                  const AirLimits& limits, CpuBackend& backend) {
  AirBlocks out;
  std::vector<bool> used(air.bricks.size(), false);
  bool any = false;
  for (std::size_t k = 0; k < used.size(); ++k) {
    const float* cells = values.back()->data() + k * kBrickCells;
    used[k] = std::any_of(cells, cells + kBrickCells, [least](float v) { return v > least; });
    any = any || used[k];
  }
  if (!any) return out;
  Layout layout;
  while (!layOut(air, used, limits, layout)) {
    layout.factor *= 2;
    if (layout.factor > kCoarsest) return out;
  }
  out.cell = air.cell * layout.factor;
  const auto corner = [&](std::size_t a) { return static_cast<double>(layout.low[a]) * kSide * out.cell; };
  out.origin = air.origin + Vec3d{corner(0), corner(1), corner(2)};
  out.size = layout.size;
  out.channels = static_cast<int>(values.size());
  const int count = static_cast<int>(layout.blocks.size());
  const int across = std::min(count, kSlotsAcross), rows = (count + across - 1) / across;
  out.slots = {across, std::min(rows, kSlotsAcross), (rows + kSlotsAcross - 1) / kSlotsAcross};
  constexpr std::size_t kSlotTexels = std::size_t{kPadded} * kPadded * kPadded;
  out.texels.assign(static_cast<std::size_t>(out.slots[0]) * static_cast<std::size_t>(out.slots[1]) *
                        static_cast<std::size_t>(out.slots[2]) * kSlotTexels * values.size(),
                    0);
  for (std::size_t channel = 0; channel < values.size(); ++channel) {
    const std::vector<float> sums = gather(air, used, *values[channel], layout);
    backend.forChunks("pack air", layout.blocks.size(), 8,
                      [&](std::size_t begin, std::size_t end, std::size_t) {
                        for (std::size_t slot = begin; slot < end; ++slot)
                          writeSlot(layout, slot, sums, static_cast<int>(channel), out);
                      });
  }
  out.index = std::move(layout.index);
  return out;
}

}  // namespace spin
