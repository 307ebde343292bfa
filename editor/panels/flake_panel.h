// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <map>
#include <string>

#include "editor/panels/flake_watch.h"

class QFormLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace spin {

struct ChangeEvent;
class SceneDocument;
class ValueEditor;

/// Shows one flake while it grows, tells its radius and fractal dimension, and gives what grew it to the
/// scene's flake shapes: one undo step. The scene changes only then.
class FlakePanel : public QWidget {
  Q_OBJECT
 public:
  explicit FlakePanel(SceneDocument* document, QWidget* parent = nullptr);

  const FlakeNode& settings() const { return m_node; }
  FlakeWatch& watch() { return m_watch; }
  QSize sizeHint() const override { return {300, 420}; }

 Q_SIGNALS:
  void editRefused(const QString& message);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void addRows();
  void showRows();
  void followScene(const ChangeEvent& event);
  void readScene();
  void take(const PropertyInfo& property, const Value& value);
  void toggle();
  void growAnother();
  void showStage(const FlakeStage& stage);
  void showPicture();
  void apply();
  void showTexts();

  SceneDocument* m_document;
  FlakeNode m_node;
  FlakeWatch m_watch;
  QImage m_image;
  QLabel* m_picture;
  QLabel* m_measures;
  QProgressBar* m_progress;
  QPushButton* m_grow;
  QPushButton* m_another;
  QPushButton* m_apply;
  QFormLayout* m_form;
  struct Row {
    QLabel* label;
    ValueEditor* editor;
  };
  std::map<std::string, Row> m_rows;  ///< by property
};

}  // namespace spin
