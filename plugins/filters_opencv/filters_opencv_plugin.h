// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "plugins/sdk/layer_filter.h"

namespace spin {

/// Filters on painted layers by OpenCV: blur, median, growing and shrinking, threshold, inversion.
class FiltersOpencvPlugin final : public QObject, public LayerFilter {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID SPIN_LAYER_FILTER_IID FILE "filters_opencv.json")
  Q_INTERFACES(spin::LayerFilter)

 public:
  std::vector<LayerFilterInfo> filters() const override;
  Status apply(const std::string& id, const LayerFilterSettings& settings,
               Raster<float>& values) const override;
};

}  // namespace spin
