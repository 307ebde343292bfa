// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "editor/viewport/model_gizmo.h"
#include "editor/viewport/scatter_stroke.h"

namespace spin {

inline constexpr double kLeastDensity = 1e-6, kMostDensity = 1.0;  // copies per m2
inline constexpr double kMostCopyDistance = 100.0;                 // m

/// The brush that scatters copies of a model over the terrain: which model, how dense, and the stroke in
/// work. Its tip and place are those of the ground brush.
class ScatterBrush {
 public:
  /// The model that is copied; empty = none.
  const std::string& node() const { return m_node; }
  void setNode(std::string id);
  double density() const { return m_density; }
  void setDensity(double perSquareMetre);
  double distance() const { return m_distance; }
  void setDistance(double metres);
  bool erases() const { return m_erases; }
  void setErases(bool on) { m_erases = on; }

  /// Begins a stroke on copies of the model. False where there is no such model or no terrain.
  bool begin(const ViewportContext& context, Vec2d place, double radius, bool erase, PlanPoints copies);
  /// True if copies came or went.
  bool drag(Vec2d place) { return m_stroke->moveTo(place); }
  bool scattering() const { return m_stroke.has_value(); }
  /// Requires scattering().
  const ScatterStroke& stroke() const { return *m_stroke; }
  void end() { m_stroke.reset(); }

 private:
  std::string m_node;
  double m_density = 0.02;
  double m_distance = 2.0;
  bool m_erases = false;
  std::optional<ScatterStroke> m_stroke;
};

/// The model node of an id, else the first model; null if the scene has none.
const SceneNode* modelToCopy(const SceneSnapshot& scene, const std::string& id);

}  // namespace spin
