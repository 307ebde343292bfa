// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QtPlugin>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/fields/raster.h"

namespace spin {

/// What a filter is called and what it wants to know.
struct LayerFilterInfo {
  std::string id;     ///< "blur"
  std::string label;  ///< SPIN_TR
  std::string doc;    ///< SPIN_TR, a sentence
  bool wantsRadius = false;
  bool wantsThreshold = false;
  bool masksOnly = false;  ///< for layers that hold shares from 0 to 1
};

struct LayerFilterSettings {
  double radius = 1.0;     ///< cells, 0.5 to 200
  double threshold = 0.5;  ///< in the values' unit
  bool shares = false;     ///< the values are shares from 0 (not painted) to 1
};

/// Picture filters on painted layers.
class LayerFilter {
 public:
  virtual ~LayerFilter() = default;
  virtual std::vector<LayerFilterInfo> filters() const = 0;
  /// Works in place; NaN is what nobody painted. May be called from any thread, by one at a time.
  virtual Status apply(const std::string& id, const LayerFilterSettings& settings,
                       Raster<float>& values) const = 0;
};

}  // namespace spin

#define SPIN_LAYER_FILTER_IID "org.spindrift.LayerFilter/1"
Q_DECLARE_INTERFACE(spin::LayerFilter, SPIN_LAYER_FILTER_IID)
