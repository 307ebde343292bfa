// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/scene_tools.h"

#include <QCoreApplication>
#include <algorithm>
#include <set>

#include "core/nodes/camera_node.h"
#include "core/nodes/flow_nodes.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "editor/app/flow_defaults.h"
#include "editor/document/time_context.h"

namespace spin {

SceneTools::SceneTools(SceneDocument* document, TimeContext* time, Viewport* viewport, QObject* parent)
    : QObject(parent), m_document(document), m_time(time), m_viewport(viewport) {
  connect(viewport, &Viewport::nodeClicked, document, &SceneDocument::select);
  connect(viewport, &Viewport::editStarted, this, &SceneTools::begin);
  connect(viewport, &Viewport::placementEdited, this, &SceneTools::place);
  connect(viewport, &Viewport::layerPainted, this, &SceneTools::paint);
  viewport->layerSource = [this](const PaintedKind& kind, const std::string& id) {
    return paintedLayer(kind, id);
  };
  connect(viewport, &Viewport::shapeEdited, this, &SceneTools::shape);
  connect(viewport, &Viewport::copiesScattered, this, &SceneTools::scatter);
  viewport->copiesSource = [this](const std::string& id) -> std::optional<PlanPoints> {
    const SceneNode* node = m_document->node(id);
    const auto* model = node ? node->as<ModelNode>() : nullptr;
    return model ? std::optional(model->copies) : std::nullopt;
  };
  connect(viewport, &Viewport::outlineWanted, this, &SceneTools::beginOutline);
  connect(viewport, &Viewport::editFinished, this, &SceneTools::finish);
  connect(viewport, &Viewport::editCancelled, this, &SceneTools::cancel);
}

void SceneTools::begin() {
  m_session = edit::newSession();
  m_indexBefore = m_document->undoStack()->index();
}

void SceneTools::place(const std::string& id, const GizmoPlacement& placement) {
  edit::PropertyValues values;
  switch (m_viewport->gizmo().mode()) {
    case GizmoMode::Move:
      values.emplace_back("position_m", placement.position);
      break;
    case GizmoMode::Rotate:
      values.emplace_back("rotation_deg", placement.rotationDegrees);
      break;
    case GizmoMode::Scale:
      values.emplace_back("scale", placement.scale);
      break;
  }
  report(edit::setValueAt(*m_document, id, values, m_time->filmTime(), m_session));
}

void SceneTools::shape(const std::string& id, const ShapeGizmo::Values& values) {
  report(edit::setValueAt(*m_document, id, values, m_time->filmTime(), m_session));
}

void SceneTools::scatter(const std::string& id, const PlanPoints& copies) {
  report(edit::setValue(*m_document, id, "copies_m", copies, m_session));
}

void SceneTools::beginOutline(Vec2d corner) {
  m_document->undoStack()->beginMacro(tr("Draw release outline"));
  addFlowSettings();
  const Result<std::string> added =
      edit::addNode(*m_document, kAvalancheReleaseType,
                    QCoreApplication::translate("Properties", kAvalancheReleaseType.label));
  if (added.ok())
    report(edit::setValue(*m_document, *added, "outline_m", PlanPoints{toCentimetres(corner)}));
  else
    Q_EMIT message(QString::fromStdString(added.error().text()));
  m_document->undoStack()->endMacro();
}

/// What the document has painted on a node of the kind: the named one, else the first.
const SceneNode* SceneTools::paintedNode(const PaintedKind& kind, const std::string& id) const {
  const SceneNode* node = m_document->node(id);
  return node && node->type == kind.type ? node : m_document->scene().firstOf(*kind.type);
}

std::optional<PaintedLayer> SceneTools::paintedLayer(const PaintedKind& kind, const std::string& id) const {
  const SceneNode* node = paintedNode(kind, id);
  if (!node || std::holds_alternative<std::monostate>(node->painted)) return std::nullopt;
  const SnapshotPointer scene = m_viewport->context().scene;
  if (!scene || !scene->terrain || !hasSize(node->painted, scene->terrain->heights)) return std::nullopt;
  return node->painted;
}

void SceneTools::paint(const PaintedKind& kind, const std::string& wanted, const PaintedLayer& layer) {
  if (m_document->isLoadingLayers()) {
    Q_EMIT message(tr("The painted layers are still being read."));
    return;
  }
  const SceneNode* node = paintedNode(kind, wanted);
  std::string id = node ? node->id : std::string();
  if (!node) {
    // The new layer and its first stroke are one undo step.
    m_document->undoStack()->beginMacro(tr("Paint ground"));
    m_macro = true;
    const std::string selected = m_document->selected();
    const Result<std::string> added =
        edit::addNode(*m_document, *kind.type, QCoreApplication::translate("Properties", kind.type->label));
    m_document->select(selected);
    if (!added.ok()) {
      Q_EMIT message(QString::fromStdString(added.error().text()));
      return;
    }
    id = *added;
  }
  report(edit::paint(*m_document, id, layer, m_session));
}

void SceneTools::finish() {
  if (m_macro) m_document->undoStack()->endMacro();
  m_macro = false;
  m_session = 0;
}

void SceneTools::cancel() {
  finish();
  if (m_document->undoStack()->index() > m_indexBefore) m_document->undoStack()->undo();
}

void SceneTools::report(const Status& status) {
  if (!status.ok()) Q_EMIT message(QString::fromStdString(status.error().text()));
}

Result<std::string> SceneTools::addNode(const NodeType& type, const QString& label) {
  const SceneNode* selected = m_document->node(m_document->selected());
  const bool model = selected && selected->as<ModelNode>();
  const edit::PropertyValues values =
      placedDefaults(type, sightOf(*m_viewport), model ? selected->id : std::string());
  m_document->undoStack()->beginMacro(tr("Add %1").arg(label));
  if (&type == &kAvalancheReleaseType || &type == &kWaterSourceType) addFlowSettings();
  Result<std::string> added = edit::addNode(*m_document, type, label);
  if (added.ok() && !values.empty()) report(edit::setValues(*m_document, *added, values));
  m_document->undoStack()->endMacro();
  return added;
}

/// What flows comes with its settings: nobody looks for the spacing of particles where there is no node that
/// has one.
void SceneTools::addFlowSettings() {
  if (m_document->scene().firstOf(kFlowSettingsType)) return;
  const Result<std::string> added = edit::addNode(
      *m_document, kFlowSettingsType, QCoreApplication::translate("Properties", kFlowSettingsType.label));
  if (!added.ok()) Q_EMIT message(QString::fromStdString(added.error().text()));
}

void SceneTools::setPicture(const std::string& property, const Value& value) {
  const SceneNode* node = m_document->scene().firstOf(kRenderType);
  if (node) return report(edit::setValue(*m_document, node->id, property, value));
  const std::string selected = m_document->selected();
  m_document->undoStack()->beginMacro(tr("Change pictures"));
  const Result<std::string> added =
      edit::addNode(*m_document, kRenderType, QCoreApplication::translate("Properties", kRenderType.label));
  if (added.ok())
    report(edit::setValue(*m_document, *added, property, value));
  else
    Q_EMIT message(QString::fromStdString(added.error().text()));
  m_document->undoStack()->endMacro();
  m_document->select(selected);
}

void SceneTools::hold(const std::string& property, bool on) {
  const SceneNode* node = m_document->scene().firstOf(kSimulationType);
  if (!node || isHeld(property) == on) return;
  const std::string id = node->id;
  // The step that ends at the shown frame is done; the next one is held.
  const double from = (m_time->frame() + 1) / m_time->frameRate();
  m_document->undoStack()->beginMacro(on ? tr("Pause process") : tr("Let process go on"));
  if (node->curves.find(property) == node->curves.end())
    report(edit::setKey(*m_document, id, property, 0.0, !on, Interpolation::Step));
  report(edit::setKey(*m_document, id, property, from, on, Interpolation::Step));
  m_document->undoStack()->endMacro();
}

bool SceneTools::isHeld(const std::string& property) const {
  const SceneNode* node = m_document->scene().firstOf(kSimulationType);
  const PropertyInfo* info = node ? node->type->find(property) : nullptr;
  if (!info) return false;
  return std::get<bool>(valueAt(*node, *info, (m_time->frame() + 1) / m_time->frameRate()));
}

void SceneTools::makeRigidBody(const std::string& model) {
  for (const SceneNode& node : m_document->scene().nodes()) {
    const auto* body = node.as<RigidBodyNode>();
    if (body && body->model == model) return m_document->select(node.id);
  }
  const QString label = QCoreApplication::translate("Properties", kRigidBodyType.label);
  m_document->undoStack()->beginMacro(tr("Make rigid body"));
  const Result<std::string> added = edit::addNode(*m_document, kRigidBodyType, label);
  if (added.ok())
    report(edit::setValue(*m_document, *added, "model", model));
  else
    Q_EMIT message(QString::fromStdString(added.error().text()));
  m_document->undoStack()->endMacro();
}

void SceneTools::cameraFromView() {
  const RenderCamera view = m_viewport->camera();
  const SceneNode* node = m_document->scene().firstOf(kCameraType);
  std::string id = node ? node->id : std::string();
  m_document->undoStack()->beginMacro(tr("Set camera from view"));
  if (!node) {
    const Result<std::string> added = edit::addNode(*m_document, kCameraType, tr("Camera"));
    if (added.ok()) id = *added;
  }
  report(edit::setValueAt(
      *m_document, id,
      {{"position_m", view.position}, {"target_m", view.target}, {"fov_deg", view.fovDegrees}},
      m_time->filmTime()));
  m_document->undoStack()->endMacro();
}

void SceneTools::setKeys() {
  const SceneNode* node = m_document->node(m_document->selected());
  if (!node) {
    Q_EMIT message(tr("Select a node first: keys are set on its animated properties."));
    return;
  }
  std::vector<std::string> properties;
  for (const auto& [property, curve] : node->curves) properties.push_back(property);
  if (properties.empty() && node->as<ModelNode>()) properties = {"position_m", "rotation_deg", "scale"};
  if (properties.empty() && node->as<CameraNode>()) properties = {"position_m", "target_m"};
  if (properties.empty()) {
    Q_EMIT message(tr("Nothing of this node is animated yet: use the key buttons beside its properties."));
    return;
  }
  const double time = m_time->filmTime();
  const std::string id = node->id;
  m_document->undoStack()->beginMacro(tr("Set keys"));
  for (const std::string& property : properties) {
    const SceneNode* current = m_document->node(id);
    const PropertyInfo* info = current->type->find(property);
    if (info) report(edit::setKey(*m_document, id, property, time, valueAt(*current, *info, time)));
  }
  m_document->undoStack()->endMacro();
}

void SceneTools::moveKeys(double fromFrame, int toFrame) {
  const double rate = m_time->frameRate();
  report(edit::moveKeys(*m_document, m_document->selected(), fromFrame / rate, toFrame / rate));
}

std::vector<double> SceneTools::keyFrames() const {
  std::set<double> frames;
  if (const SceneNode* node = m_document->node(m_document->selected()))
    for (const auto& [property, curve] : node->curves)
      for (const Key& key : curve.keys()) frames.insert(key.time * m_time->frameRate());
  return {frames.begin(), frames.end()};
}

}  // namespace spin
