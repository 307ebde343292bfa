// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/layer_job.h"

#include <QMetaObject>
#include <utility>

namespace spin {

LayerJob::LayerJob(QObject* parent) : QObject(parent) {
  m_pool.setMaxThreadCount(1);
}

LayerJob::~LayerJob() {
  forget();
  m_pool.waitForDone();
}

void LayerJob::start(Work work) {
  if (m_running)
    m_next = std::move(work);
  else
    run(std::move(work));
}

void LayerJob::forget() {
  m_next = nullptr;
  ++m_number;
}

void LayerJob::run(Work work) {
  m_running = true;
  m_pool.start([this, number = m_number, work = std::move(work)] {
    const Result<LayerAnswer> result = work();
    QMetaObject::invokeMethod(this, [this, number, result] { take(number, result); });
  });
}

void LayerJob::take(quint64 number, const Result<LayerAnswer>& result) {
  m_running = false;
  if (m_next) run(std::exchange(m_next, nullptr));
  if (number != m_number) return;
  if (result.ok())
    Q_EMIT done(*result);
  else
    Q_EMIT failed(QString::fromStdString(result.error().text()));
}

}  // namespace spin
