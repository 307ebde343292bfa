// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <memory>

#include "core/base/cancel.h"
#include "core/scene/flake_shapes.h"

namespace spin {

class SceneDocument;

/// Grows the shapes of the scene's flakes on a thread whenever their settings change, or takes them from the
/// cache folder of the scene. Can be cancelled: the shapes before then stay until the settings change again.
class FlakeShapesMaker : public QObject {
  Q_OBJECT
 public:
  static constexpr int kDebounceMilliseconds = 300;

  explicit FlakeShapesMaker(SceneDocument* document, QObject* parent = nullptr);
  ~FlakeShapesMaker() override;

  bool growing() const { return m_growing; }

 public Q_SLOTS:
  void cancel();

 Q_SIGNALS:
  /// Share that is grown, 0..1.
  void progressed(double share);
  void growingChanged(bool on);
  void ready(const std::shared_ptr<const spin::FlakeAtlas>& atlas);
  void message(const QString& text);

 private:
  using Grown = Result<std::shared_ptr<const FlakeAtlas>>;
  void look();
  void start(const FlakeAtlasSettings& settings);
  void take(quint64 number, const Grown& grown);
  void setGrowing(bool on);
  void keep();

  SceneDocument* m_document;
  QThreadPool m_pool;
  QTimer m_debounce;
  CancelToken m_cancel;
  Hash128 m_key;  ///< of what was asked for last
  std::shared_ptr<const FlakeAtlas> m_atlas;
  Hash128 m_atlasKey;
  quint64 m_number = 0;
  bool m_growing = false;
};

}  // namespace spin
