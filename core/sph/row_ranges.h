// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sph/slice_view.h"

namespace spin {

/// A stretch of sorted particles to search; their positions are read plus the shift (whole periods).
struct RowRange {
  std::uint32_t begin, end;
  std::int32_t shiftX, shiftY;
};

/// The bins from first to last of one row, cut to the row.
template <class Visit>
SPIN_HD_INLINE void visitBins(const SliceView& view, std::int32_t row, std::int32_t first, std::int32_t last,
                              std::int32_t shiftX, std::int32_t shiftY, const Visit& visit) {
  const std::int32_t bins = view.grid.binsX();
  const std::int32_t low = first < 0 ? 0 : first;
  const std::int32_t high = last >= bins ? bins - 1 : last;
  if (low > high) return;
  const std::uint32_t* start = view.binStart + static_cast<std::size_t>(row) * static_cast<std::size_t>(bins);
  const RowRange range{start[low], start[high + 1], shiftX, shiftY};
  if (range.begin < range.end) visit(range);
}

/// Calls visit(RowRange) for everything within one support radius of the stretch [xLow, xHigh] in the row
/// (cellY, cellZ), in a fixed order. Periodic axes have at least 3 cells, so no image comes twice.
template <class Visit>
SPIN_HD_INLINE void forRowRanges(const SliceView& view, std::int32_t cellY, std::int32_t cellZ,
                                 std::int32_t xLow, std::int32_t xHigh, const Visit& visit) {
  const SliceGrid& grid = view.grid;
  const std::int32_t bins = grid.binsX();
  const std::int32_t periodX = grid.cellsX << kCellBits, periodY = grid.cellsY << kCellBits;
  std::int32_t first = (xLow - kCellUnits) >> kBinBits;
  std::int32_t last = (xHigh + kCellUnits) >> kBinBits;
  if (!grid.periodicX) {
    first = SliceGrid::clampTo(first, bins);
    last = SliceGrid::clampTo(last, bins);
  }
  for (std::int32_t cz = cellZ - 1; cz <= cellZ + 1; ++cz) {
    if (cz < 0 || cz >= grid.cellsZ) continue;
    for (std::int32_t cy = cellY - 1; cy <= cellY + 1; ++cy) {
      const std::int32_t wrap = cy < 0 ? -1 : cy >= grid.cellsY ? 1 : 0;
      if (wrap != 0 && !grid.periodicY) continue;
      const std::int32_t row = cz * grid.cellsY + cy - wrap * grid.cellsY;
      const std::int32_t shiftY = wrap * periodY;
      if (grid.periodicX && first < 0) visitBins(view, row, first + bins, bins - 1, -periodX, shiftY, visit);
      visitBins(view, row, first, last, 0, shiftY, visit);
      if (grid.periodicX && last >= bins) visitBins(view, row, 0, last - bins, periodX, shiftY, visit);
    }
  }
}

}  // namespace spin
