// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/scene/scene_file.h"
#include "editor/document/document_issue.h"

namespace spin {

/// What can be seen to be wrong without simulating: missing nodes, empty ranges, limits in the wrong order.
std::vector<DocumentIssue> checkScene(const Scene& scene);
/// Warnings for files that are used where they are, outside the scene's folder; none while the scene has no
/// folder.
std::vector<DocumentIssue> filesOutside(const Scene& scene, const std::string& sceneFile,
                                        const PathPolicy& policy);

}  // namespace spin
