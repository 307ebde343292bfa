// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sph/flow_view.h"

namespace spin {

/// A stretch of sorted particles to search; their positions are read plus the shift (whole periods).
struct RowRange {
  std::uint32_t begin, end;
  std::int32_t shiftX, shiftY, shiftZ;
};

/// The bins from first to last of one row, cut to what the row has.
template <class Visit>
SPIN_HD_INLINE void visitBins(const FlowView& view, const FlowRow& row, std::int32_t first, std::int32_t last,
                              RowRange range, const Visit& visit) {
  const std::int32_t low = first < row.firstBin ? row.firstBin : first;
  const std::int32_t high = last > row.lastBin ? row.lastBin : last;
  if (low > high) return;
  const std::uint32_t* start = view.binStart + row.start;
  range.begin = start[low - row.firstBin];
  range.end = start[high - row.firstBin + 1];
  if (range.begin < range.end) visit(range);
}

/// Cell index wrapped into a period; `wraps` becomes -1, 0 or 1, the whole periods that positions there are
/// to be shifted by.
SPIN_HD_INLINE std::int32_t wrappedCell(std::int32_t cell, std::int32_t period, std::int32_t& wraps) {
  wraps = 0;
  if (period == 0) return cell;
  wraps = cell < 0 ? -1 : cell >= period ? 1 : 0;
  return cell - wraps * period;
}

/// Calls visit(RowRange) for everything within one support radius of the stretch [xLow, xHigh] in the row of
/// cells (cellY, cellZ), in a fixed order. Periodic axes have at least 3 cells, so no image comes twice.
template <class Visit>
SPIN_HD_INLINE void forRowRanges(const FlowView& view, std::int32_t cellY, std::int32_t cellZ,
                                 std::int32_t xLow, std::int32_t xHigh, const Visit& visit) {
  const FlowGrid& grid = view.grid;
  const std::int32_t first = (xLow - kCellUnits) >> kBinBits, last = (xHigh + kCellUnits) >> kBinBits;
  const std::int32_t periodBins = grid.periodX << (kCellBits - kBinBits);
  for (std::int32_t dz = -1; dz <= 1; ++dz) {
    std::int32_t wrapZ, wrapY;
    const std::int32_t cz = wrappedCell(cellZ + dz, grid.periodZ, wrapZ) - grid.lowZ;
    if (cz < 0 || cz >= grid.cellsZ) continue;
    for (std::int32_t dy = -1; dy <= 1; ++dy) {
      const std::int32_t cy = wrappedCell(cellY + dy, grid.periodY, wrapY) - grid.lowY;
      if (cy < 0 || cy >= grid.cellsY) continue;
      const FlowRow row = view.rows[cz * grid.cellsY + cy];
      RowRange range{0, 0, 0, (wrapY * grid.periodY) << kCellBits, (wrapZ * grid.periodZ) << kCellBits};
      visitBins(view, row, first, last, range, visit);
      if (periodBins == 0) continue;
      range.shiftX = -(grid.periodX << kCellBits);
      if (first < 0) visitBins(view, row, first + periodBins, periodBins - 1, range, visit);
      range.shiftX = grid.periodX << kCellBits;
      if (last >= periodBins) visitBins(view, row, 0, last - periodBins, range, visit);
    }
  }
}

}  // namespace spin
