// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/viewport.h"

#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/fields/terrain_surface.h"
#include "core/nodes/flow_nodes.h"
#include "editor/render/air_values.h"
#include "editor/render/cover_values.h"
#include "editor/render/flow_scale.h"
#include "editor/render/view_uniforms.h"
#include "editor/viewport/overlay_painter.h"
#include "editor/viewport/picture_view.h"
#include "editor/viewport/scene_picker.h"
#include "editor/viewport/shape_painter.h"

namespace spin {

namespace {

SnapshotPointer withPreview(const SceneSnapshot& plain, const Viewport::LayerPreview& preview) {
  auto scene = std::make_shared<SceneSnapshot>(plain);
  for (SceneNode& node : scene->nodes)
    if (node.type == preview.kind->type && node.id == preview.node) {
      node.painted = preview.layer;
      return scene;
    }
  SceneNode node = makeNode(*preview.kind->type, "preview", "preview");
  node.painted = preview.layer;
  scene->nodes.push_back(std::move(node));
  return scene;
}

/// The model that a rigid body makes solid; other nodes themselves.
std::string modelOf(const SceneSnapshot& scene, const std::string& id) {
  for (const SceneNode& node : scene.nodes)
    if (node.id == id)
      if (const auto* body = node.as<RigidBodyNode>()) return body->model;
  return id;
}

/// What of a shape has a size of its own, with some ground round it; arrows are as long as the view is wide.
Box3d placeOf(const NodeShape& shape) {
  constexpr double kRound = 1.0;  // m
  Box3d box;
  for (const ShapePoint& point : shape.points) {
    const bool arrow = point.handle == ShapeHandle::Arrow || point.handle == ShapeHandle::Wind ||
                       point.handle == ShapeHandle::Sun;
    if (arrow) continue;
    box.extend(point.place - Vec3d{kRound, kRound, kRound});
    box.extend(point.place + Vec3d{kRound, kRound, kRound});
  }
  for (const NodeShape::Line& line : shape.lines)
    for (const Vec3d& p : line.points)
      if (line.closed && !shape.north) box.extend(p);
  return box;
}

}  // namespace

Viewport::Viewport(QWidget* parent) : QWidget(parent), m_chosenKind(&m_brush.kind()) {
  setObjectName("viewport");
  setAcceptDrops(false);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  m_surface = new PictureView(this);
  m_surface->setOverlay([this](QPainter& painter) { paintOverlay(painter); });
  connect(m_surface, &PictureView::drawn, this, &Viewport::drawn);
  connect(m_surface, &PictureView::failed, this, &Viewport::failed);
  m_surface->setMouseTracking(true);
  m_surface->setFocusPolicy(Qt::StrongFocus);
  m_surface->installEventFilter(this);
  column->addWidget(m_surface);
  m_flight.setInterval(16);
  connect(&m_flight, &QTimer::timeout, this, &Viewport::flyStep);
  m_readTimer.setSingleShot(true);
  m_readTimer.setInterval(80);
  connect(&m_readTimer, &QTimer::timeout, this, &Viewport::updateReading);
  m_clock.start();
  refresh();
}

Viewport::~Viewport() = default;

void Viewport::setScene(SnapshotPointer scene) {
  m_plainScene = std::move(scene);
  showScene();
}

void Viewport::setPreview(std::optional<LayerPreview> preview) {
  if (!preview && !m_preview) return;
  m_preview = std::move(preview);
  showScene();
  updateGround();
}

void Viewport::showScene() {
  m_scene = m_preview && m_plainScene ? withPreview(*m_plainScene, *m_preview) : m_plainScene;
  m_surface->setScene(m_scene);
  m_navigator.setFloor(m_scene ? eyeFloor(*m_scene) : EyeFloor());
  followSelection();
  updateLegend();
  refresh();
}

void Viewport::setFrame(FramePointer frame) {
  m_frame = frame;
  m_surface->setFrame(std::move(frame));
  updateLegend();
}

void Viewport::setFlakeAtlas(std::shared_ptr<const FlakeAtlas> atlas) {
  m_surface->setFlakeAtlas(std::move(atlas));
}

void Viewport::updateLegend() {
  m_legend = m_scene ? flowLegend(*m_scene, m_frame.get(), m_filmTime) : std::nullopt;
  m_coverLegend = m_scene ? spin::coverLegend(*m_scene, m_frame.get(), m_filmTime) : std::nullopt;
  m_airLegend = m_scene ? spin::airLegend(*m_scene, m_frame.get(), m_filmTime) : std::nullopt;
  scheduleReading();
  updateOverlay();
}

void Viewport::setFilmTime(double seconds) {
  m_filmTime = seconds;
  refresh();
}

void Viewport::setSelected(const std::string& node) {
  if (node == m_selected) return;
  m_selected = node;
  m_options.selectedNode = node;
  m_shape.setNode(node);
  followSelection();
  refresh();
}

/// The gizmo stands on the selected model or the selected body's; the brush paints the selected node where
/// that is painted on.
void Viewport::followSelection() {
  if (!m_gizmo.dragging()) m_gizmo.setNode(m_scene ? modelOf(*m_scene, m_selected) : m_selected);
  followModel();
  if (m_brush.painting()) return;
  const PaintedKind* kind = nullptr;
  if (m_scene)
    for (const SceneNode& node : m_scene->nodes)
      if (node.id == m_selected) kind = paintedKind(*node.type);
  const std::string id = kind ? m_selected : std::string();
  if (!kind) kind = m_chosenKind;
  if (kind == &m_brush.kind() && id == m_brush.node()) return;
  m_brush.setLayer(*kind, id);
  updateGround();
  Q_EMIT brushChanged();
}

void Viewport::setTool(Tool tool) {
  if (editing()) endEdit();
  endAdjust(false);
  m_tool = tool;
  if (tool == Tool::Rotate)
    m_gizmo.setMode(GizmoMode::Rotate);
  else if (tool == Tool::Scale)
    m_gizmo.setMode(GizmoMode::Scale);
  else
    m_gizmo.setMode(GizmoMode::Move);
  m_brush.leave();
  const bool draws = hasTip() || tool == Tool::Outline;
  m_surface->setCursor(draws ? Qt::CrossCursor : Qt::ArrowCursor);
  updateGround();
}

void Viewport::setGizmoAxes(GizmoAxes axes) {
  m_gizmo.setAxes(axes);
  updateOverlay();
}

void Viewport::setGroundDisplay(GroundDisplay display) {
  m_groundDisplay = display;
  updateGround();
}

void Viewport::setShowPainted(bool on) {
  m_showPainted = on;
  updateGround();
}

/// What is painted shows while it is painted, unless the ground's own look is wanted.
void Viewport::updateGround() {
  m_options.ground = m_groundDisplay;
  if (m_preview)
    m_options.ground = displayOf(*m_preview->kind);
  else if (m_tool == Tool::Brush && m_showPainted)
    m_options.ground = displayOf(m_brush.kind());
  refresh();
  updateOverlay();
}

void Viewport::setShowSnow(bool on) {
  m_options.showSnow = on;
  refresh();
}

void Viewport::setShowFlakes(bool on) {
  m_options.showFlakes = on;
  refresh();
}

void Viewport::setLookThrough(bool on) {
  if (on == m_lookThrough) return;
  m_lookThrough = on;
  refresh();
  Q_EMIT lookThroughChanged(on);
}

void Viewport::setEmptyHint(const QString& title, const QString& text) {
  m_hintTitle = title;
  m_hintText = text;
  updateOverlay();
}

RenderCamera Viewport::camera() const {
  if (m_lookThrough && m_scene) {
    RenderCamera camera = cameraOf(*m_scene, m_filmTime);
    // A view that is narrower than the picture shows its whole width, and more above and below.
    const double wider = pictureAspect() * m_surface->height() / std::max(1, m_surface->width());
    if (wider > 1.0)
      camera.fovDegrees =
          radiansToDegrees(2.0 * std::atan(wider * std::tan(0.5 * degreesToRadians(camera.fovDegrees))));
    return camera;
  }
  return m_navigator.camera().camera();
}

void Viewport::setCamera(const RenderCamera& camera) {
  m_navigator.setCamera(OrbitCamera::from(camera));
  refresh();
}

double Viewport::hazeScale() const {
  if (!m_scene || m_lookThrough) return 1.0;
  // What one looks at and the middle of the terrain stay in sight.
  const Vec3d eye = camera().position;
  double distance = m_navigator.camera().distance();
  if (m_scene->terrain && !m_scene->terrain->heights.empty()) {
    const Raster<float>& h = m_scene->terrain->heights;
    const double x = 0.5 * (h.x(0) + h.x(h.width - 1)), y = 0.5 * (h.y(0) + h.y(h.height - 1));
    const double z = TerrainSurface(h).heightAt(x, y).value_or(m_navigator.camera().pivot().z);
    distance = std::max(distance, length(Vec3d{x, y, z} - eye));
  }
  return readableHaze(lightModel(*m_scene, m_filmTime, 0.0).hazeExtinction, distance);
}

void Viewport::frameSelection() {
  if (!m_scene) return;
  Box3d box = nodeBounds(*m_scene, m_selected, m_filmTime);
  if (box.empty()) box = placeOf(nodeShape(context(), m_selected));
  flyTo(box.empty() ? sceneBounds(*m_scene, m_filmTime) : box);
}

void Viewport::frameAll() {
  if (m_scene) flyTo(sceneBounds(*m_scene, m_filmTime));
}

void Viewport::flyTo(const Box3d& box) {
  if (box.empty()) return;
  leaveLookThrough();
  OrbitCamera goal = m_navigator.camera();
  goal.frame(box);
  m_navigator.flyTo(goal, now());
  m_flight.start();
}

void Viewport::flyStep() {
  if (!m_navigator.fly(now())) m_flight.stop();
  cameraMoved();
}

double Viewport::now() const {
  return static_cast<double>(m_clock.nsecsElapsed()) * 1e-9;
}

ViewportContext Viewport::context() const {
  return {m_scene, m_filmTime,
          ViewFrame(camera(), std::max(1, m_surface->width()), std::max(1, m_surface->height()))};
}

void Viewport::leaveLookThrough() {
  if (!m_lookThrough) return;
  if (m_scene) m_navigator.setCamera(OrbitCamera::from(cameraOf(*m_scene, m_filmTime)));
  setLookThrough(false);
}

void Viewport::cameraMoved() {
  m_surface->setMoving(true);
  refresh();
}

void Viewport::refresh() {
  m_options.hazeScale = hazeScale();
  m_surface->setView(camera(), m_filmTime, m_options);
}

void Viewport::updateOverlay() {
  m_surface->updateOverlay();
}

void Viewport::paintOverlay(QPainter& painter) const {
  const ViewportContext seen = context();
  paintWords(painter);
  QRectF room(m_surface->rect());
  if (m_legend) room.setRight(paintLegend(painter, room, *m_legend).left());
  const bool values = m_coverLegend && m_options.showSnow && m_options.ground == GroundDisplay::Natural;
  if (values) room.setRight(paintLegend(painter, room, *m_coverLegend).left());
  if (m_airLegend) paintLegend(painter, room, *m_airLegend);
  // Above the line that tells what the tool does: both may be long.
  const QRectF aboveHint = QRectF(m_surface->rect()).adjusted(0, 0, 0, m_showHints ? -34 : 0);
  if (!m_reading.isEmpty()) paintReading(painter, aboveHint, m_reading);
  paintShapes(painter, seen);
  if (const GroundScale* scale = groundScale(m_options.ground))
    paintGroundLegend(painter, QRectF(m_surface->rect()), *scale);
  if (m_tool == Tool::Brush) {
    paintBrush(painter, seen);
  } else if (m_tool == Tool::Scatter) {
    paintScatter(painter, seen);
  } else if (m_tool != Tool::Select) {
    const auto pose = m_gizmo.pose(seen);
    const GizmoHandle active = m_gizmo.dragging() ? m_gizmo.activeHandle() : m_hovered;
    if (pose) paintGizmo(painter, seen.view, *pose, m_gizmo.mode(), active);
  }
}

/// Lines of all nodes that are no models; handles of the selected one where a tool moves them.
void Viewport::paintShapes(QPainter& painter, const ViewportContext& seen) const {
  if (!m_scene || m_lookThrough) return;
  for (const SceneNode& node : m_scene->nodes) {
    if (node.id == m_selected) continue;
    const NodeShape shape = nodeShape(seen, node.id);
    if (!shape.quiet) paintShapeLines(painter, seen, shape, false);
  }
  const NodeShape shape = nodeShape(seen, m_selected);
  paintShapeLines(painter, seen, shape, true);
  if (hasTip()) return;
  std::optional<ShapePoint> active;
  if (m_shape.dragging())
    active = m_shape.grabbed();
  else
    active = m_shape.pointAt(seen, m_pointer);
  paintShapePoints(painter, seen.view, shape, active);
  const QString text = active ? shapeText(seen, m_selected, *active) : QString();
  if (!text.isEmpty()) paintTag(painter, {m_pointer.x, m_pointer.y}, text);
}

}  // namespace spin
