// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QEvent>
#include <QWidget>

namespace spin {

/// Keeps the mouse wheel from a widget that does not have the focus: scrolling a panel must not change the
/// values under the pointer. The panel scrolls instead.
class WheelGuard final : public QObject {
 public:
  explicit WheelGuard(QWidget* guarded) : QObject(guarded) { guarded->installEventFilter(this); }

  bool eventFilter(QObject* watched, QEvent* event) override {
    const auto* widget = qobject_cast<QWidget*>(watched);
    if (event->type() != QEvent::Wheel || !widget || widget->hasFocus()) return false;
    event->ignore();
    return true;
  }
};

}  // namespace spin
