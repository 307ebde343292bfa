// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <vector>

#include "core/nodes/painted_kinds.h"
#include "core/scene/asset_library.h"
#include "plugins/sdk/layer_filter.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace spin {

class LayerValueEditor;

/// Which filter with which settings; it stays open beside the view, which shows what would come.
class FilterDialog : public QDialog {
  Q_OBJECT
 public:
  FilterDialog(const PaintedKind& kind, std::vector<LayerFilterInfo> filters, QWidget* parent = nullptr);

  std::string filter() const;
  double radius() const;     ///< m
  double threshold() const;  ///< SI
  void showProblem(const QString& text);

 Q_SIGNALS:
  void changed();

 private:
  void follow();

  std::vector<LayerFilterInfo> m_filters;
  QComboBox* m_filter;
  QDoubleSpinBox* m_radius;
  LayerValueEditor* m_threshold;
  QLabel* m_about;
};

/// What a file is made of that a painted layer goes to or comes from: its format, and what its black and
/// white stand for.
class LayerFileDialog : public QDialog {
  Q_OBJECT
 public:
  enum class Way { Import, Export };

  LayerFileDialog(const PaintedKind& kind, Way way, QWidget* parent = nullptr);

  /// "png" or "tif"; of an export.
  QString ending() const;
  LayerFormat format() const;
  /// Of an import: what the file holds and what was done to it.
  void showFindings(const RasterImport& raster, const std::vector<std::string>& remarks);
  void showProblem(const QString& text);

 Q_SIGNALS:
  void changed();

 private:
  void follow();

  const PaintedKind& m_kind;
  QComboBox* m_format;
  LayerValueEditor* m_black;
  LayerValueEditor* m_white;
  QLabel* m_about;
  bool m_ranged = false;
};

}  // namespace spin
