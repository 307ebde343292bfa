// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/import_flow.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "core/nodes/terrain_node.h"
#include "editor/app/import_dialog.h"

namespace spin {

ImportFlow::ImportFlow(SceneDocument* document, std::shared_ptr<AssetReader> reader, QWidget* window)
    : QObject(window), m_document(document), m_reader(std::move(reader)), m_window(window) {}

void ImportFlow::choose() {
  const QStringList files =
      QFileDialog::getOpenFileNames(m_window, tr("Import terrain or model"), m_lastFolder, importFilter());
  for (const QString& file : files) import(file);
}

void ImportFlow::import(const QString& file) {
  const ImportKind kind = importKindOf(file);
  if (kind == ImportKind::Unknown) {
    Q_EMIT message(
        tr("\"%1\" is neither a terrain nor a model this program reads.").arg(QFileInfo(file).fileName()));
    return;
  }
  m_lastFolder = QFileInfo(file).absolutePath();
  auto* dialog = new ImportDialog(m_reader, file, kind, m_window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog, file, kind] {
    const NodeType& type = kind == ImportKind::Terrain ? kTerrainType : kModelType;
    const Result<std::string> added = edit::addAssetNode(*m_document, type, file, dialog->values());
    if (added.ok())
      m_document->select(*added);
    else
      QMessageBox::warning(m_window, tr("Import"), QString::fromStdString(added.error().text()));
  });
  dialog->open();
}

}  // namespace spin
