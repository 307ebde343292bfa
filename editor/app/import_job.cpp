// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/import_job.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QMetaObject>

namespace spin {
namespace {

const QStringList kTerrainEndings{QStringLiteral("asc"), QStringLiteral("tif"), QStringLiteral("tiff"),
                                  QStringLiteral("png"), QStringLiteral("xyz"), QStringLiteral("hgt")};
const QStringList kModelEndings{QStringLiteral("gltf"), QStringLiteral("glb"), QStringLiteral("obj"),
                                QStringLiteral("ply")};

QString patterns(const QStringList& endings) {
  QStringList list;
  for (const QString& ending : endings) list << QStringLiteral("*.") + ending;
  return list.join(u' ');
}

Result<ImportFindings> look(AssetReader& reader, const std::string& path, ImportKind kind,
                            const ImportOptions& options, const CancelToken& cancel) {
  if (kind == ImportKind::Terrain) {
    Result<TerrainImport> read = reader.readTerrain(path, options, cancel);
    if (!read.ok()) return read.error();
    return ImportFindings{read->summary, read->terrain->credit, firstViewOf(read->terrain->heights)};
  }
  Result<ModelImport> read = reader.readModel(path, options, cancel);
  if (!read.ok()) return read.error();
  return ImportFindings{read->summary, {}, {}};
}

}  // namespace

ImportKind importKindOf(const QString& file) {
  const QString ending = QFileInfo(file).suffix().toLower();
  if (kTerrainEndings.contains(ending)) return ImportKind::Terrain;
  if (kModelEndings.contains(ending)) return ImportKind::Model;
  return ImportKind::Unknown;
}

QString importFilter() {
  const auto text = [](const char* source) { return QCoreApplication::translate("spin::ImportJob", source); };
  return text(QT_TRANSLATE_NOOP("spin::ImportJob", "Terrain and models")) + QStringLiteral(" (") +
         patterns(kTerrainEndings + kModelEndings) + QStringLiteral(");;") +
         text(QT_TRANSLATE_NOOP("spin::ImportJob", "Elevation models")) + QStringLiteral(" (") +
         patterns(kTerrainEndings) + QStringLiteral(");;") +
         text(QT_TRANSLATE_NOOP("spin::ImportJob", "Models")) + QStringLiteral(" (") +
         patterns(kModelEndings) + QStringLiteral(")");
}

ImportJob::ImportJob(std::shared_ptr<AssetReader> reader, QObject* parent)
    : QObject(parent), m_reader(std::move(reader)) {
  m_pool.setMaxThreadCount(1);
}

ImportJob::~ImportJob() {
  cancel();
  m_pool.waitForDone();
}

void ImportJob::cancel() {
  m_cancel.cancel();
  ++m_number;
  m_running = false;
}

void ImportJob::read(const QString& file, ImportKind kind, const ImportOptions& options) {
  cancel();
  m_cancel = CancelToken();
  m_running = true;
  m_pool.start([this, number = m_number, cancel = m_cancel, path = file.toStdString(), kind, options] {
    const Result<ImportFindings> result = look(*m_reader, path, kind, options, cancel);
    QMetaObject::invokeMethod(this, [this, number, result] { answer(number, result); });
  });
}

void ImportJob::answer(quint64 number, const Result<ImportFindings>& result) {
  if (number != m_number) return;
  m_running = false;
  if (result.ok())
    Q_EMIT done(*result);
  else
    Q_EMIT failed(QString::fromStdString(result.error().text()));
}

}  // namespace spin
