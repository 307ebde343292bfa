// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <functional>

#include "editor/render/ground_scale.h"
#include "editor/render/value_scale.h"
#include "editor/viewport/brush_adjust.h"
#include "editor/viewport/ground_brush.h"
#include "editor/viewport/scatter_brush.h"
#include "editor/viewport/shape_gizmo.h"
#include "editor/viewport/view_navigator.h"

namespace spin {

class PictureView;

/// The view into the scene: camera, selection by click, gizmo and brush. It shows a snapshot and tells what
/// the user wants to change; it changes nothing itself. Where nothing can be drawn a notice takes the
/// picture's place and everything else still works.
class Viewport : public QWidget {
  Q_OBJECT
 public:
  enum class Tool { Select, Move, Rotate, Scale, Brush, Outline, Scatter };

  explicit Viewport(QWidget* parent = nullptr);
  ~Viewport() override;

  void setScene(SnapshotPointer scene);
  void setFrame(FramePointer frame);
  /// Shapes of the falling flakes; null = soft discs.
  void setFlakeAtlas(std::shared_ptr<const FlakeAtlas> atlas);
  void setFilmTime(double seconds);
  void setSelected(const std::string& node);
  Tool tool() const { return m_tool; }
  void setTool(Tool tool);
  void setGizmoAxes(GizmoAxes axes);
  void setGroundDisplay(GroundDisplay display);
  /// Whether the ground shows the painted layer while the brush is the tool; else always as
  /// setGroundDisplay() says.
  void setShowPainted(bool on);
  bool showPainted() const { return m_showPainted; }
  GroundDisplay shownGround() const { return m_options.ground; }
  void setShowSnow(bool on);
  void setShowFlakes(bool on);
  /// Whether a line says what lies under the pointer: snow, temperature, type of the ground.
  void setShowReading(bool on);
  /// That line; empty beside everything.
  const QString& reading() const { return m_reading; }
  /// Shows what the scene's camera sees; moving the view ends it.
  void setLookThrough(bool on);
  bool lookThrough() const { return m_lookThrough; }
  const GroundBrush& brush() const { return m_brush; }
  void setBrushTip(const BrushTip& tip);
  void setBrushRadius(double metres);
  void setBrushMode(BrushMode mode);
  void setBrushValue(double si);
  void setBrushPressure(bool onStrength, bool onRadius);
  /// What the brush paints; an empty node is the first of the kind. A selected node that is painted takes its
  /// place.
  void setBrushLayer(const PaintedKind& kind, const std::string& node = {});
  /// Where strokes take the layer from that they begin with: the document, of which the snapshot may be a
  /// moment behind. Without it, or where it gives nothing, the snapshot's.
  std::function<std::optional<PaintedLayer>(const PaintedKind& kind, const std::string& node)> layerSource;
  /// The layer as strokes begin with it. Requires terrain.
  PaintedLayer layerToPaint() const;
  const ScatterBrush& scatter() const { return m_scatter; }
  void setScatterDensity(double perSquareMetre);
  void setScatterDistance(double metres);
  void setScatterErases(bool on);
  /// As layerSource: the copies of a model that a stroke begins with.
  std::function<std::optional<PlanPoints>(const std::string& node)> copiesSource;
  /// A layer that is shown in the place of the scene's, to see what would come.
  struct LayerPreview {
    const PaintedKind* kind = nullptr;
    std::string node;  ///< empty = the scene has none
    PaintedLayer layer;
  };
  void setPreview(std::optional<LayerPreview> preview);
  /// Message shown while the scene is empty.
  void setEmptyHint(const QString& title, const QString& text);

  /// What the tool in the hand does, in a line at the lower edge; until setShowHints(false).
  QString toolHint() const;
  void setShowHints(bool on);
  /// Where the picture that is made by the scene's camera lies in the view, while looking through it.
  QRectF pictureFrame() const;

  /// The camera of the view, by which the scene is drawn now.
  RenderCamera camera() const;
  void setCamera(const RenderCamera& camera);
  /// Share of the weather's haze that is shown: 1 through the scene's camera, less from far away.
  double hazeScale() const;
  /// Flies to the selected node, or to the whole scene if nothing is selected that has a place.
  void frameSelection();
  void frameAll();

  ViewportContext context() const;
  const ModelGizmo& gizmo() const { return m_gizmo; }
  const ShapeGizmo& shape() const { return m_shape; }
  /// What the colours of the shown frame mean; nothing where they stand for no values.
  const std::optional<ValueLegend>& legend() const { return m_legend; }
  /// The same of the snow cover.
  const std::optional<ValueLegend>& coverLegend() const { return m_coverLegend; }
  /// Of the air.
  const std::optional<ValueLegend>& airLegend() const { return m_airLegend; }
  /// The widget that shows the picture and takes the pointer.
  PictureView* surface() const { return m_surface; }

 Q_SIGNALS:
  /// A click; the id is empty beside everything.
  void nodeClicked(const std::string& id);
  /// The gizmo is dragged: placement of a model node, again and again until editFinished().
  void placementEdited(const std::string& id, const spin::GizmoPlacement& placement);
  /// The brush paints: the whole layer, again and again until editFinished(). An empty node is the first of
  /// the kind, which may have to be made.
  void layerPainted(const spin::PaintedKind& kind, const std::string& node, const spin::PaintedLayer& layer);
  /// Copies of a model are scattered or taken away: all of them, again and again until editFinished().
  void copiesScattered(const std::string& node, const spin::PlanPoints& copies);
  /// A handle of a node that is not a model is dragged: properties of the node, again and again until
  /// editFinished().
  void shapeEdited(const std::string& id, const spin::ShapeGizmo::Values& values);
  /// The outline tool is used where no release is selected: a new one is to begin here, in plan.
  void outlineWanted(spin::Vec2d corner);
  void editStarted();
  void editFinished();
  /// Escape: take back what editStarted() began.
  void editCancelled();
  void brushRadiusChanged(double metres);
  /// Anything of the brush: tip, mode, layer, value.
  void brushChanged();
  /// Anything of the brush for copies: model, density, distance, mode.
  void scatterChanged();
  void lookThroughChanged(bool on);
  void drawn(double seconds);
  void failed(const QString& message);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool tablet(const QTabletEvent& event);
  bool wheel(const QWheelEvent& event);
  bool cancelEdit();
  bool keyPress(const QKeyEvent& event);
  void followKeys(const QKeyEvent& event, bool down);
  bool removeCorner();
  bool beginEdit(const QMouseEvent& event);
  bool beginBrush(Vec2d pixel, Qt::KeyboardModifiers keys);
  bool pick();
  bool brushKey(const QKeyEvent& event);
  bool adjust(const QMouseEvent& event);
  void endAdjust(bool keep);
  BrushMode modeFor(Qt::KeyboardModifiers keys) const;
  bool beginShape(Vec2d pixel);
  bool editing() const {
    return m_gizmo.dragging() || m_brush.painting() || m_shape.dragging() || m_scatter.scattering();
  }
  void letGo();
  /// Whether the tool has a round tip.
  bool hasTip() const { return m_tool == Tool::Brush || m_tool == Tool::Scatter; }
  void followModel();
  PlanPoints copiesToPaint() const;
  bool scatterErases(Qt::KeyboardModifiers keys) const;
  bool beginScatter(Vec2d pixel, Qt::KeyboardModifiers keys);
  void dragScatter(Vec2d pixel);
  void paintScatter(QPainter& painter, const ViewportContext& seen) const;
  void paintCopies(QPainter& painter, const ViewportContext& seen, const PlanPoints& copies,
                   const QColor& colour) const;
  void dragShape(const QMouseEvent& event);
  void followSelection();
  void updateLegend();
  void scheduleReading();
  void updateReading();
  void updateGround();
  void showScene();
  void paintBrush(QPainter& painter, const ViewportContext& seen) const;
  void paintShapes(QPainter& painter, const ViewportContext& seen) const;
  void endEdit();
  void hover(Vec2d pixel);
  void leaveLookThrough();
  void cameraMoved();
  void refresh();
  void updateOverlay();
  void paintOverlay(QPainter& painter) const;
  void paintWords(QPainter& painter) const;
  double pictureAspect() const;
  const SceneNode* selectedNode() const;
  void flyStep();
  void flyTo(const Box3d& box);
  double now() const;

  SnapshotPointer m_plainScene;  ///< as it was given
  SnapshotPointer m_scene;       ///< with the preview
  std::optional<LayerPreview> m_preview;
  FramePointer m_frame;
  std::optional<ValueLegend> m_legend, m_coverLegend, m_airLegend;
  double m_filmTime = 0.0;
  std::string m_selected;
  Tool m_tool = Tool::Select;
  ViewNavigator m_navigator;
  ModelGizmo m_gizmo;
  ShapeGizmo m_shape;
  GroundBrush m_brush;
  ScatterBrush m_scatter;
  std::optional<BrushAdjust> m_adjust;
  const PaintedKind* m_chosenKind;  ///< what the brush paints while no painted node is selected
  double m_pressure = 1.0;          ///< of the pen
  Qt::KeyboardModifiers m_keys;     ///< as the last event of the pointer had them
  Vec2d m_pointer{};
  bool m_pointerInside = false;
  bool m_showReading = true;
  QString m_reading;
  QTimer m_readTimer;
  GizmoHandle m_hovered = GizmoHandle::None;
  RenderOptions m_options;
  GroundDisplay m_groundDisplay = GroundDisplay::Natural;
  bool m_showPainted = true;
  bool m_lookThrough = false;
  QPointF m_pressed;
  bool m_clicking = false;
  QString m_hintTitle, m_hintText;
  bool m_showHints = true;
  PictureView* m_surface = nullptr;
  QTimer m_flight;
  QElapsedTimer m_clock;
};

}  // namespace spin
