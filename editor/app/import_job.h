// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QStringList>
#include <QThreadPool>
#include <memory>

#include "core/scene/asset_library.h"
#include "core/scene/first_view.h"

namespace spin {

enum class ImportKind { Unknown, Terrain, Model };

/// Which reader a file is for, by its ending.
ImportKind importKindOf(const QString& file);
/// Filter of a file dialog: all readable files, terrains, models.
QString importFilter();

/// What an import needs to know of a file besides its content.
struct ImportFindings {
  ImportSummary summary;
  std::string credit;             ///< of a terrain
  std::optional<FirstView> view;  ///< of a terrain with ground
};

/// Reads a foreign file on a thread to show what is in it before it becomes part of the scene. One at a time;
/// a new read cancels the one before.
class ImportJob : public QObject {
  Q_OBJECT
 public:
  explicit ImportJob(std::shared_ptr<AssetReader> reader, QObject* parent = nullptr);
  ~ImportJob() override;

  void read(const QString& file, ImportKind kind, const ImportOptions& options);
  void cancel();
  bool running() const { return m_running; }

 Q_SIGNALS:
  void done(const spin::ImportFindings& findings);
  void failed(const QString& message);

 private:
  void answer(quint64 number, const Result<ImportFindings>& result);

  std::shared_ptr<AssetReader> m_reader;
  QThreadPool m_pool;
  CancelToken m_cancel;
  quint64 m_number = 0;
  bool m_running = false;
};

}  // namespace spin
