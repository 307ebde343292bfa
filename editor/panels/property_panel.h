// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

#include "editor/document/change_event.h"

class QLabel;
class QScrollArea;

namespace spin {

class PropertyRowEditor;
class SceneDocument;
class TimeContext;

/// All properties of the selected node, made from its property table: a fitting widget in display units, the
/// documentation as tooltip, a key button and a revert button. Shows values at the current frame.
class PropertyPanel : public QWidget {
  Q_OBJECT
 public:
  PropertyPanel(SceneDocument* document, TimeContext* time, QWidget* parent = nullptr);
  ~PropertyPanel() override;

  /// The row of a property of the shown node; nullptr if there is none.
  PropertyRowEditor* row(const std::string& property) const;

 Q_SIGNALS:
  /// An edit was refused; for the status bar.
  void editRefused(const QString& message);
  /// A model is to be solid for the flow; the body that does so already is to be shown.
  void bodyWanted(const std::string& model);
  /// Return in a field: the keys may go back to the view.
  void entered();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showNode(const std::string& id);
  void showTitle();
  void follow(const ChangeEvent& event);
  void refreshRows();
  void revealProperty(const std::string& node, const std::string& property);

  SceneDocument* m_document;
  TimeContext* m_time;
  std::string m_node;
  QLabel* m_title;
  QScrollArea* m_scroll;
  std::vector<PropertyRowEditor*> m_rows;
};

}  // namespace spin
