// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/scene/scene.h"
#include "editor/document/document_issue.h"

namespace spin {

/// What can be seen to be wrong without simulating: missing nodes, empty ranges, limits in the wrong order.
std::vector<DocumentIssue> checkScene(const Scene& scene);

}  // namespace spin
