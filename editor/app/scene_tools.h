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
  /// Adds a node; what flows is put where the middle of the view meets the terrain. One undo step.
  Result<std::string> addNode(const NodeType& type, const QString& label);
  /// Sets a value of the scene's picture settings, which are added if there are none. One undo step.
  void setPicture(const std::string& property, const Value& value);
  /// Holds a process still from the current time on, or lets it go on ("pause_snow", "pause_flow" of the
  /// simulation settings): frames before stay as they are. One undo step.
  void hold(const std::string& property, bool on);
  bool isHeld(const std::string& property) const;
  /// Makes a model solid for the flow, or selects the body that does so already.
  void makeRigidBody(const std::string& model);
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
  const SceneNode* paintedNode(const PaintedKind& kind, const std::string& id) const;
  std::optional<PaintedLayer> paintedLayer(const PaintedKind& kind, const std::string& id) const;
  void paint(const PaintedKind& kind, const std::string& wanted, const PaintedLayer& layer);
  void shape(const std::string& id, const ShapeGizmo::Values& values);
  void scatter(const std::string& id, const PlanPoints& copies);
  void beginOutline(Vec2d corner);
  void finish();
  void cancel();
  void addFlowSettings();
  void report(const Status& status);

  SceneDocument* m_document;
  TimeContext* m_time;
  Viewport* m_viewport;
  edit::Session m_session = 0;
  int m_indexBefore = 0;
  bool m_macro = false;
};

}  // namespace spin
