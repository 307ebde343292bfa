// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/flake_shapes_maker.h"

#include <QMetaObject>
#include <utility>

#include "core/nodes/weather_nodes.h"
#include "core/sim/thread_priority.h"
#include "editor/app/simulation_controller.h"
#include "editor/document/scene_document.h"

namespace spin {

FlakeShapesMaker::FlakeShapesMaker(SceneDocument* document, QObject* parent)
    : QObject(parent), m_document(document) {
  m_pool.setMaxThreadCount(1);
  m_debounce.setSingleShot(true);
  m_debounce.setInterval(kDebounceMilliseconds);
  connect(&m_debounce, &QTimer::timeout, this, &FlakeShapesMaker::look);
  connect(document, &SceneDocument::changed, this, [this] { m_debounce.start(); });
  connect(document, &SceneDocument::pathChanged, this, &FlakeShapesMaker::keep);
}

FlakeShapesMaker::~FlakeShapesMaker() {
  m_cancel.cancel();
  m_pool.waitForDone();
}

void FlakeShapesMaker::cancel() {
  m_cancel.cancel();
  ++m_number;
  setGrowing(false);
}

void FlakeShapesMaker::look() {
  const Scene& scene = m_document->scene();
  if (!scene.firstOf(kSnowfallType)) return;
  const SceneNode* node = scene.firstOf(kFlakeType);
  const auto* data = node && node->enabled ? node->as<FlakeNode>() : nullptr;
  const FlakeAtlasSettings settings = atlasSettingsOf(data ? *data : FlakeNode());
  if (const Hash128 key = flakeAtlasKey(settings); std::exchange(m_key, key) != key) start(settings);
}

void FlakeShapesMaker::start(const FlakeAtlasSettings& settings) {
  m_cancel.cancel();
  m_cancel = CancelToken();
  setGrowing(true);
  Q_EMIT progressed(0.0);
  const std::string folder = SimulationController::cacheFolderOf(m_document->path()).toStdString();
  m_pool.start([this, settings, folder, number = ++m_number, cancel = m_cancel] {
    lowerThreadPriority(kSimulationNiceness);
    const auto tell = [&](double share) {
      QMetaObject::invokeMethod(this, [this, number, share] {
        if (number == m_number) Q_EMIT progressed(share);
      });
    };
    // One thread: others draw and simulate meanwhile.
    const Grown grown = obtainFlakeAtlas(settings, folder, cancel, tell, 1);
    QMetaObject::invokeMethod(this, [this, number, grown] { take(number, grown); });
  });
}

void FlakeShapesMaker::take(quint64 number, const Grown& grown) {
  if (number != m_number) return;
  setGrowing(false);
  if (grown) {
    m_atlas = *grown;
    m_atlasKey = m_key;
    Q_EMIT ready(m_atlas);
  } else if (grown.error().kind != ErrorKind::Cancelled) {
    Q_EMIT message(QString::fromStdString(grown.error().text()));
  }
}

/// A scene that is saved elsewhere takes its shapes along.
void FlakeShapesMaker::keep() {
  const std::string folder = SimulationController::cacheFolderOf(m_document->path()).toStdString();
  if (!m_atlas || folder.empty()) return;
  m_pool.start([this, folder, atlas = m_atlas, key = m_atlasKey] {
    if (readFlakeAtlas(folder, key)) return;
    const Status kept = writeFlakeAtlas(*atlas, key, folder);
    if (!kept)
      QMetaObject::invokeMethod(
          this, [this, text = QString::fromStdString(kept.error().text())] { Q_EMIT message(text); });
  });
}

void FlakeShapesMaker::setGrowing(bool on) {
  if (std::exchange(m_growing, on) != on) Q_EMIT growingChanged(on);
}

}  // namespace spin
