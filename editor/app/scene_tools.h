// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "editor/commands/edits.h"
#include "editor/viewport/viewport.h"

namespace spin {

class TimeContext;

/// Turns what the user does in the viewport into edits of the document: a drag or a stroke is one undo step.
class SceneTools : public QObject {
  Q_OBJECT
 public:
  SceneTools(SceneDocument* document, TimeContext* time, Viewport* viewport, QObject* parent = nullptr);

  /// Gives the scene's camera the view of the viewport, at the current time; adds a camera if there is none.
  void cameraFromView();
  /// Sets keys at the current time for all animated properties of the selected node; for a node without any,
  /// for its placement.
  void setKeys();
  /// Moves the keys of the selected node that stand at one frame to another.
  void moveKeys(double fromFrame, int toFrame);
  /// Frames at which the selected node has keys, ascending.
  std::vector<double> keyFrames() const;

 Q_SIGNALS:
  /// Why something was not done.
  void message(const QString& text);

 private:
  void begin();
  void place(const std::string& id, const GizmoPlacement& placement);
  void paint(const TiledRaster<std::uint8_t>& layer);
  void finish();
  void cancel();
  void report(const Status& status);

  SceneDocument* m_document;
  TimeContext* m_time;
  Viewport* m_viewport;
  edit::Session m_session = 0;
  int m_indexBefore = 0;
  bool m_macro = false;
};

}  // namespace spin
