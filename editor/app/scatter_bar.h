// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <vector>

#include "editor/document/scene_document.h"
#include "editor/viewport/viewport.h"

class QAction;
class QActionGroup;
class QComboBox;
class QDoubleSpinBox;
class QToolBar;
class QWidget;

namespace spin {

/// The part of the tool bar for scattering copies: which model, add or take away, radius, how dense, how far
/// apart, and how much the copies are turned and differ in size. Shown while that is the tool.
class ScatterBar : public QObject {
  Q_OBJECT
 public:
  ScatterBar(QToolBar* bar, SceneDocument* document, Viewport* viewport, QObject* parent);

  void setVisible(bool on);

 Q_SIGNALS:
  /// Why something was not done.
  void message(const QString& text);

 private:
  QAction* addMode(const char* name, bool erases, const QString& text, const QKeySequence& key);
  QDoubleSpinBox* addField(const char* name, const QString& prefix, const QString& suffix, Vec2d range,
                           int decimals, const QString& tip);
  void add(QWidget* widget);
  void addFields();
  void showModels();
  void showScatter();
  void setOfNode(const char* property, double value);

  QToolBar* m_bar;
  SceneDocument* m_document;
  Viewport* m_viewport;
  std::vector<QAction*> m_shown;  ///< of all widgets and actions here
  std::vector<QAction*> m_modes;
  QActionGroup* m_group = nullptr;
  QComboBox* m_model = nullptr;
  QDoubleSpinBox* m_radius = nullptr;
  QDoubleSpinBox* m_density = nullptr;
  QDoubleSpinBox* m_distance = nullptr;
  QDoubleSpinBox* m_turn = nullptr;
  QDoubleSpinBox* m_size = nullptr;
  bool m_visible = false;
};

}  // namespace spin
