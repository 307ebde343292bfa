// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/wind_table.h"

#include <algorithm>
#include <cmath>

#include "core/sim/shared_registry.h"

namespace spin {
namespace {

bool isWhole(const WindTable& t) {
  constexpr int kMost = 1 << 14;
  if (t.width < 1 || t.height < 1 || t.layers < 1 || t.width > kMost || t.height > kMost || t.layers > kMost)
    return false;
  if (t.depth.size() != t.columns() || t.levels.size() != static_cast<std::size_t>(t.layers) + 1)
    return false;
  if (t.ratios.size() != t.columns() * static_cast<std::size_t>(t.layers)) return false;
  const bool finite = std::isfinite(t.originX) && std::isfinite(t.originY) && std::isfinite(t.top) &&
                      std::isfinite(t.cell) && t.cell > 0.0 && t.roughness > 0.0;
  return finite &&
         std::all_of(t.depth.begin(), t.depth.end(), [](float d) { return std::isfinite(d) && d > 0.0f; }) &&
         std::is_sorted(t.levels.begin(), t.levels.end());
}

}  // namespace

WindTable::Place WindTable::placeOf(double x, double y) const {
  const double u = std::clamp((x - originX) / cell, 0.0, static_cast<double>(width - 1)),
               v = std::clamp((y - originY) / cell, 0.0, static_cast<double>(height - 1));
  const int i = std::min(static_cast<int>(u), std::max(width - 2, 0)),
            j = std::min(static_cast<int>(v), std::max(height - 2, 0));
  const double fu = u - i, fv = v - j;
  const auto column = [&](int a, int b) {
    return static_cast<std::size_t>(std::min(b, height - 1)) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(std::min(a, width - 1));
  };
  return {{column(i, j), column(i + 1, j), column(i, j + 1), column(i + 1, j + 1)},
          {(1 - fu) * (1 - fv), fu * (1 - fv), (1 - fu) * fv, fu * fv}};
}

bool WindTable::holds(double x, double y) const {
  const double u = (x - originX) / cell, v = (y - originY) / cell;
  return u >= 0.0 && v >= 0.0 && u <= width - 1 && v <= height - 1;
}

double WindTable::groundHeight(const Place& place) const {
  double air = 0.0;
  for (std::size_t k = 0; k < 4; ++k) air += place.weight[k] * static_cast<double>(depth[place.column[k]]);
  return top - air;
}

void putShared(const WindTable& table, ByteWriter& out) {
  for (const int n : {table.width, table.height, table.layers}) out.put(n);
  for (const double v : {table.originX, table.originY, table.cell, table.roughness, table.top}) out.put(v);
  out.putArray(table.depth);
  out.putArray(table.levels);
  out.putArray(table.ratios);
}

std::shared_ptr<const void> loadWindTable(ByteReader& in) {
  auto table = std::make_shared<WindTable>();
  for (int* n : {&table->width, &table->height, &table->layers}) *n = in.get<int>();
  for (double* v : {&table->originX, &table->originY, &table->cell, &table->roughness, &table->top})
    *v = in.get<double>();
  table->depth = in.getArray<float>();
  table->levels = in.getArray<double>();
  table->ratios = in.getArray<WindTable::Ratios>();
  if (!in.ok() || !in.atEnd() || !isWhole(*table)) return nullptr;
  return registryOf<WindTable>().intern(std::move(table));
}

}  // namespace spin
