// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/gl.h>

#include <algorithm>
#include <array>

namespace spin {

/// Keeps drawing to a rectangle x0, y0, x1, y1 within the one set already.
class ScissorLimit {
 public:
  explicit ScissorLimit(const std::array<int, 4>& pixels) : m_wasOn(glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE) {
    glGetIntegerv(GL_SCISSOR_BOX, m_before);
    GLint x0 = pixels[0], y0 = pixels[1], x1 = pixels[2], y1 = pixels[3];
    if (m_wasOn) {
      x0 = std::max(x0, m_before[0]);
      y0 = std::max(y0, m_before[1]);
      x1 = std::min(x1, m_before[0] + m_before[2]);
      y1 = std::min(y1, m_before[1] + m_before[3]);
    }
    glEnable(GL_SCISSOR_TEST);
    glScissor(x0, y0, std::max(0, x1 - x0), std::max(0, y1 - y0));
  }
  ~ScissorLimit() {
    glScissor(m_before[0], m_before[1], m_before[2], m_before[3]);
    if (!m_wasOn) glDisable(GL_SCISSOR_TEST);
  }
  ScissorLimit(const ScissorLimit&) = delete;
  ScissorLimit& operator=(const ScissorLimit&) = delete;

 private:
  bool m_wasOn;
  GLint m_before[4] = {};
};

}  // namespace spin
