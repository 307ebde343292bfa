// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QThreadPool>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/property/scene_node.h"

namespace spin {

/// What work on a painted layer gave.
struct LayerAnswer {
  PaintedLayer layer;
  std::vector<std::string> remarks;  ///< whole sentences for the user
  double share = 0.0, area = 0.0;    ///< of the terrain that was filled; area in plan, m2
};

/// Work on a painted layer, on a thread, so that the window never waits. While one piece of work runs, only
/// the newest of those asked for waits behind it.
class LayerJob : public QObject {
  Q_OBJECT
 public:
  using Work = std::function<Result<LayerAnswer>()>;

  explicit LayerJob(QObject* parent = nullptr);
  ~LayerJob() override;

  void start(Work work);
  /// Answers that are still to come are dropped.
  void forget();
  bool busy() const { return m_running; }

 Q_SIGNALS:
  void done(const spin::LayerAnswer& answer);
  void failed(const QString& message);

 private:
  void run(Work work);
  void take(quint64 number, const Result<LayerAnswer>& result);

  QThreadPool m_pool;
  Work m_next;
  quint64 m_number = 0;
  bool m_running = false;
};

}  // namespace spin
