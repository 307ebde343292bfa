// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "core/fields/terrain_fill.h"
#include "core/nodes/painted_kinds.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QGroupBox;
class QLabel;
class QVBoxLayout;

namespace spin {

class LayerValueEditor;

/// Where and with what a painted layer is filled: ranges of altitude, slope and aspect with soft edges, the
/// value and how it joins what is there. It stays open beside the view, which shows what would come.
class FillDialog : public QDialog {
  Q_OBJECT
 public:
  struct Choice {
    FillRule rule;
    double value = 0.0;  ///< SI
    FillCombine combine = FillCombine::Replace;
  };

  /// `lowest` and `highest`: altitudes of the terrain, m above sea.
  FillDialog(const PaintedKind& kind, double value, double lowest, double highest, QWidget* parent = nullptr);

  Choice choice() const;
  /// Tells how much of the terrain is filled: its share and area in plan, m2.
  void showExtent(double share, double area);
  void showProblem(const QString& text);

 Q_SIGNALS:
  void changed();

 private:
  struct RangeFields {
    QGroupBox* box = nullptr;
    QDoubleSpinBox *low = nullptr, *high = nullptr, *soft = nullptr;

    SoftRange range() const;
  };
  RangeFields addRange(QVBoxLayout* column, const char* name, const QString& title, const QString& tip,
                       const QString& suffix, double least, double most);
  void addFacings(QFormLayout* form);

  LayerValueEditor* m_value;
  QComboBox* m_combine;
  RangeFields m_altitude, m_slope, m_aspect;
  QLabel* m_extent;
};

}  // namespace spin
