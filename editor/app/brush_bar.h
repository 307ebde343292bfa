// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <vector>

#include "editor/viewport/viewport.h"

class QAction;
class QActionGroup;
class QComboBox;
class QDoubleSpinBox;
class QMenu;
class QSpinBox;
class QToolBar;
class QToolButton;

namespace spin {

class LayerTools;
class LayerValueEditor;

/// The brush's part of the tool bar: layer, value, mode, radius, hardness, strength, pressure, and what is
/// done to the whole layer. Shown while the brush is the tool.
class BrushBar : public QObject {
  Q_OBJECT
 public:
  BrushBar(QToolBar* bar, Viewport* viewport, LayerTools* layers, QObject* parent);

  void setVisible(bool on);
  /// Fills a menu with what is done to the whole layer.
  static void fillLayerMenu(QMenu* menu, LayerTools* layers);
  /// Actions that choose a mode, for the list of shortcuts.
  std::vector<QAction*> modes() const;

 private:
  void addLayer();
  void addModes();
  void addTip();
  void addPressure();
  void addLayerMenu(LayerTools* layers);
  QSpinBox* addPercent(const char* name, const QString& prefix, const QString& tip);
  void add(QWidget* widget);
  void showBrush();
  void takeTip();

  QToolBar* m_bar;
  Viewport* m_viewport;
  std::vector<QAction*> m_shown;  ///< of all widgets and actions here
  QComboBox* m_layer = nullptr;
  LayerValueEditor* m_value = nullptr;
  QAction* m_valueShown = nullptr;
  QActionGroup* m_modes = nullptr;
  QDoubleSpinBox* m_radius = nullptr;
  QSpinBox* m_hardness = nullptr;
  QSpinBox* m_strength = nullptr;
  QAction* m_hardnessShown = nullptr;
  QAction* m_strengthShown = nullptr;
  QToolButton* m_pressure = nullptr;
  QAction* m_pressStrength = nullptr;
  QAction* m_pressRadius = nullptr;
  bool m_visible = false;
};

}  // namespace spin
