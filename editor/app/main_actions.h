// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QKeySequence>
#include <QObject>
#include <functional>
#include <vector>

#include "core/property/property_table.h"

class QAction;
class QActionGroup;
class QMenu;

namespace spin {

class MainWindow;

/// Menus, shortcuts and the tool bar of the main window. Every action has an object name, by which tests find
/// it.
class MainActions : public QObject {
  Q_OBJECT
 public:
  explicit MainActions(MainWindow* window);

  /// Adds a node, placed where the view looks; asks for a file where the type needs one.
  void addNode(const NodeType& type);
  /// Whether all frames may be thrown away. A function, so that tests answer without a dialog.
  std::function<bool()> mayReset;
  /// For the list of shortcuts: all actions that have one, in menu order.
  std::vector<QAction*> withShortcuts() const;

 private:
  using Handler = std::function<void()>;
  QAction* add(QMenu* menu, const char* name, const QString& text, const QKeySequence& keys,
               const Handler& handler);
  QAction* addToggle(QMenu* menu, const char* name, const QString& text, bool on, const QKeySequence& keys,
                     const std::function<void(bool)>& handler);
  void addFileMenu();
  void addEditMenu();
  void addViewMenu();
  void addGroundMenu(QMenu* view);
  void addSnowMenu(QMenu* view);
  void showSnowSettings();
  void addAirMenu(QMenu* view);
  void showAirSettings();
  void showAir(const char* property, std::size_t choice);
  void addFlowMenu(QMenu* view);
  void showFlowSettings();
  void addSimulateMenu();
  void addHoldActions(QMenu* menu);
  void showHeld();
  void addHelpMenu();
  void addTools();
  void addBrushTools(class QToolBar* bar);
  void addTransport();
  void fillNodeMenu();
  void followSelection();
  void showShortcuts();
  void showAbout();

  MainWindow* m_window;
  QMenu* m_nodeMenu = nullptr;
  QAction* m_duplicate = nullptr;
  QAction* m_delete = nullptr;
  std::vector<QAction*> m_snowDisplays;  ///< by SnowDisplay
  QAction* m_publishedSnow = nullptr;
  std::vector<QAction*> m_flowDisplays;  ///< by FlowDisplay
  QAction* m_flowBoundary = nullptr;
  std::vector<QAction*> m_airDisplays;  ///< by AirDisplay
  std::vector<QAction*> m_airSlices;    ///< by AirSlice
  QAction* m_holdSnow = nullptr;
  QAction* m_holdFlow = nullptr;
  QAction* m_holdAir = nullptr;
  std::vector<QAction*> m_all;
};

}  // namespace spin
