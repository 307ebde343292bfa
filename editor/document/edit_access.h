// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "editor/document/scene_document.h"

namespace spin {

/// The door through which undo commands write the scene. Nobody else may: an edit without a command cannot
/// be undone.
struct EditAccess {
  static Scene& scene(SceneDocument& document) { return document.m_scene; }
  static void notify(SceneDocument& document, const ChangeEvent& event) { document.notify(event); }
};

}  // namespace spin
