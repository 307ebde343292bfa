// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"

namespace spin {

/// An OpenGL 4.5 core context without a window (EGL), current on the thread that made it and ended there: on
/// the first graphics card, else in software. LIBGL_ALWAYS_SOFTWARE=1 asks for software.
class EglContext {
 public:
  static Result<std::unique_ptr<EglContext>> create();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  /// GL_RENDERER, for reports and manifests.
  std::string rendererName() const;

 private:
  EglContext() = default;
  struct State;
  std::unique_ptr<State> m_state;
};

}  // namespace spin
