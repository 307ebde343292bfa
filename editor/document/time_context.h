// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

namespace spin {

class SceneDocument;

/// The current frame that panels and viewport show, with its film time by the scene's frame rate.
class TimeContext : public QObject {
  Q_OBJECT
 public:
  explicit TimeContext(SceneDocument* document, QObject* parent = nullptr);

  int frame() const { return m_frame; }
  /// s of film: frame / frame rate.
  double filmTime() const;
  double frameRate() const;

 public Q_SLOTS:
  void setFrame(int frame);

 Q_SIGNALS:
  void frameChanged(int frame);

 private:
  SceneDocument* m_document;
  int m_frame = 0;
};

}  // namespace spin
