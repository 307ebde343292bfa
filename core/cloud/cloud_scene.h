// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cloud/cloud_solids.h"
#include "core/cloud/surrounding_air.h"
#include "core/nodes/air_nodes.h"

namespace spin {

/// Everything about the air in a scene.
struct CloudScene {
  AirConfig air;
  FlowConfig flow;  ///< as the flow has it, but for the solids
  CloudSolids solids;
  SurroundingAir surrounding;
  Box3d box;  ///< of the air, m

  /// Cells of the whole box.
  double cells() const;
};

/// Whether there is an enabled air node, and flow.
bool sceneHasCloud(const SceneSnapshot& scene);
/// The air round the cloud is that of film time 0. Fails where the flow cannot start, and where the air's box
/// has more bricks than can be numbered.
Result<CloudScene> makeCloudScene(const SceneSnapshot& scene, const CancelToken& cancel,
                                  bool withSolids = true);

}  // namespace spin
