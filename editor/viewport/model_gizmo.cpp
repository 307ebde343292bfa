// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/model_gizmo.h"

#include <cmath>

#include "core/nodes/terrain_node.h"
#include "editor/viewport/scene_picker.h"

namespace spin {
namespace {

const SceneNode* findModel(const ViewportContext& context, const std::string& id) {
  if (!context.scene) return nullptr;
  for (const SceneNode& node : context.scene->nodes)
    if (node.id == id && node.enabled && node.as<ModelNode>()) return &node;
  return nullptr;
}

ModelNode placementOf(const SceneNode& node, double filmTime) {
  return static_cast<const ModelNode&>(*evaluate(node, filmTime));
}

}  // namespace

std::optional<GizmoPose> ModelGizmo::pose(const ViewportContext& context) const {
  const SceneNode* node = findModel(context, m_node);
  if (!node) return std::nullopt;
  const Vec3d pivot = context.scene->modelTransform(*node, context.filmTime).translation;
  if (context.view.depth(pivot) < 0.01) return std::nullopt;
  return GizmoPose::of(context.view, pivot, placementOf(*node, context.filmTime).rotationDegrees, m_mode,
                       m_axes);
}

GizmoHandle ModelGizmo::handleAt(const ViewportContext& context, Vec2d pixel) const {
  const auto p = pose(context);
  return p ? pickGizmo(context.view, *p, m_mode, pixel) : GizmoHandle::None;
}

bool ModelGizmo::begin(const ViewportContext& context, Vec2d pixel) {
  const auto p = pose(context);
  const GizmoHandle handle = handleAt(context, pixel);
  if (!p || handle == GizmoHandle::None) return false;
  const ModelNode model = placementOf(*findModel(context, m_node), context.filmTime);
  m_onGround = model.onGround && context.scene->terrain;
  m_groundGrab = m_onGround ? pickTerrain(*context.scene, context.view.ray(pixel)) : std::nullopt;
  m_drag.emplace(*p, m_mode, handle, GizmoPlacement{model.position, model.rotationDegrees, model.scale},
                 context.view, pixel);
  return true;
}

GizmoPlacement ModelGizmo::drag(const ViewportContext& context, Vec2d pixel, bool snap) {
  const GizmoPlacement free = m_drag->update(context.view, pixel, snap);
  return m_onGround && m_mode == GizmoMode::Move ? onGround(context, pixel, free, snap) : free;
}

GizmoPlacement ModelGizmo::onGround(const ViewportContext& context, Vec2d pixel, GizmoPlacement free,
                                    bool snap) const {
  const GizmoPlacement& start = m_drag->start();
  const GizmoHandle handle = m_drag->handle();
  if (handle == GizmoHandle::Centre) {
    // The model follows the ground under the pointer; where that leaves the terrain it stays.
    const auto hit = pickTerrain(*context.scene, context.view.ray(pixel));
    free.position = start.position;
    if (!hit || !m_groundGrab) return free;
    const Vec3d offset = *hit - *m_groundGrab;
    const auto step = [snap](double d) {
      return snap ? std::round(d / GizmoDrag::kSnapMetres) * GizmoDrag::kSnapMetres : d;
    };
    free.position.x += step(offset.x);
    free.position.y += step(offset.y);
    return free;
  }
  const bool level =
      handle == GizmoHandle::AxisX || handle == GizmoHandle::AxisY || handle == GizmoHandle::PlaneZ;
  if (level) free.position.z = start.position.z;
  return free;
}

}  // namespace spin
