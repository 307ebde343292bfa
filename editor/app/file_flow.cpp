// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/file_flow.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

namespace spin {

namespace {

/// Not every account has a folder for documents.
QString firstFolder() {
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

}  // namespace

FileFlow::FileFlow(SceneDocument* document, QWidget* window)
    : QObject(window), m_lastFolder(firstFolder()), m_document(document), m_window(window) {
  askUnsaved = [this] {
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                    tr("\"%1\" has changes that are not saved.").arg(m_document->displayName()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, m_window);
    box.setDefaultButton(QMessageBox::Save);
    const int answer = box.exec();
    return answer == QMessageBox::Save      ? Unsaved::Save
           : answer == QMessageBox::Discard ? Unsaved::Discard
                                            : Unsaved::Cancel;
  };
  askOverwrite = [this] { return showOverwriteQuestion(); };
  askOpenPath = [this] {
    return QFileDialog::getOpenFileName(m_window, tr("Open scene"), m_lastFolder,
                                        tr("Spindrift scenes (*.spindrift)"));
  };
  askSavePath = [this](const QString& suggestion) {
    return QFileDialog::getSaveFileName(m_window, tr("Save scene"), suggestion,
                                        tr("Spindrift scenes (*.spindrift)"));
  };
  showError = [this](const QString& text) { QMessageBox::warning(m_window, tr("Spindrift"), text); };
  connect(document, &SceneDocument::saveFinished, this, [this](bool ok, const QString& message) {
    if (!ok) showError(message);
  });
}

bool FileFlow::newScene() {
  if (!mayDiscard()) return false;
  m_document->newScene();
  return true;
}

bool FileFlow::open() {
  if (!mayDiscard()) return false;
  const QString path = askOpenPath();
  if (path.isEmpty()) return false;
  m_lastFolder = QFileInfo(path).absolutePath();
  const Status status = m_document->open(path);
  if (!status.ok()) showError(QString::fromStdString(status.error().text()));
  return status.ok();
}

bool FileFlow::openPath(const QString& path) {
  if (!mayDiscard()) return false;
  m_lastFolder = QFileInfo(path).absolutePath();
  const Status status = m_document->open(path);
  if (!status.ok()) showError(QString::fromStdString(status.error().text()));
  return status.ok();
}

bool FileFlow::save() {
  if (m_document->path().isEmpty()) return saveAs();
  if (m_document->isChangedOnDisk()) {
    const Overwrite answer = askOverwrite();
    if (answer == Overwrite::SaveAs) return saveAs();
    if (answer == Overwrite::Cancel) return false;
  }
  m_document->save();
  return true;
}

FileFlow::Overwrite FileFlow::showOverwriteQuestion() {
  QMessageBox box(
      QMessageBox::Warning, tr("Changed on disk"),
      tr("Another program has changed \"%1\" since it was opened or saved here. Saving overwrites "
         "these changes.")
          .arg(QDir::toNativeSeparators(m_document->path())),
      QMessageBox::Cancel, m_window);
  const QPushButton* overwrite = box.addButton(tr("Overwrite"), QMessageBox::DestructiveRole);
  QPushButton* elsewhere = box.addButton(tr("Save as..."), QMessageBox::AcceptRole);
  box.setDefaultButton(elsewhere);
  box.exec();
  return box.clickedButton() == overwrite   ? Overwrite::Overwrite
         : box.clickedButton() == elsewhere ? Overwrite::SaveAs
                                            : Overwrite::Cancel;
}

bool FileFlow::saveAs() {
  const QString suggestion = m_document->path().isEmpty()
                                 ? QDir(m_lastFolder).filePath(tr("scene") + QStringLiteral(".spindrift"))
                                 : m_document->path();
  QString path = askSavePath(suggestion);
  if (path.isEmpty()) return false;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".spindrift");
  m_lastFolder = QFileInfo(path).absolutePath();
  m_document->saveAs(path);
  return true;
}

bool FileFlow::saveNow() {
  if (!save()) return false;
  const Status status = m_document->finishSaving();
  return status.ok() && !m_document->isModified();
}

bool FileFlow::mayDiscard() {
  if (!m_document->isModified()) return true;
  switch (askUnsaved()) {
    case Unsaved::Save:
      return saveNow();
    case Unsaved::Discard:
      return true;
    case Unsaved::Cancel:
      break;
  }
  return false;
}

void FileFlow::fillRecent(QMenu* menu) {
  menu->clear();
  for (const QString& path : m_document->recentFiles()) {
    QAction* action = menu->addAction(QFileInfo(path).fileName());
    action->setToolTip(QDir::toNativeSeparators(path));
    connect(action, &QAction::triggered, this, [this, path] { openPath(path); });
  }
  menu->setEnabled(!menu->isEmpty());
  menu->setToolTipsVisible(true);
}

}  // namespace spin
