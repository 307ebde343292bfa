// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QObject>
#include <QThreadPool>

#include "core/base/cancel.h"
#include "core/base/result.h"
#include "core/nodes/flake_node.h"

namespace spin {

/// A flake on its way: what it looks like and what it measures.
struct FlakeStage {
  QImage picture;          ///< white by cover on black; the wanted size fills it
  double share = 0.0;      ///< of the growth, 0..1
  double radius = 0.0;     ///< m
  int particles = 0;       ///< or cells of ice
  double dimension = 0.0;  ///< fractal dimension by the radius of gyration; 0 = not known (yet)
};

/// Grows one flake on a thread and tells how it comes along, about 15 times a second. Only the latest growth
/// is told.
class FlakeWatch : public QObject {
  Q_OBJECT
 public:
  static constexpr int kPictureSize = 320;

  explicit FlakeWatch(QObject* parent = nullptr);
  ~FlakeWatch() override;

  /// Stops what grows and starts anew.
  void start(const FlakeNode& node);
  void stop();
  bool running() const { return m_running; }

 Q_SIGNALS:
  void grown(const spin::FlakeStage& stage);
  /// The growth ended by itself, or could not begin: the message says why.
  void finished(const QString& message);

 private:
  void tell(quint64 number, const FlakeStage& stage);
  void end(quint64 number, const Status& status);

  QThreadPool m_pool;
  CancelToken m_cancel;
  quint64 m_number = 0;
  bool m_running = false;
};

}  // namespace spin
