// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/import_flow.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "core/nodes/node_registry.h"
#include "core/nodes/terrain_node.h"
#include "core/scene/collect_files.h"
#include "editor/app/import_dialog.h"

namespace spin {
namespace {

/// Names of the layers that hold cells of the terrain.
QStringList paintedLayers(const Scene& scene) {
  QStringList names;
  for (const SceneNode& node : scene.nodes())
    if (isPaintedType(*node.type)) names << QStringLiteral("\"%1\"").arg(QString::fromStdString(node.name));
  return names;
}

}  // namespace

ImportFlow::ImportFlow(SceneDocument* document, std::shared_ptr<AssetReader> reader, QWidget* window)
    : QObject(window), m_document(document), m_reader(std::move(reader)), m_window(window) {
  m_copier.setMaxThreadCount(1);
  askReplace = [this](const QString& question, const QString& meaning) {
    QMessageBox box(QMessageBox::Question, tr("Import terrain"), question, QMessageBox::Cancel, m_window);
    box.setObjectName("replaceTerrain");
    box.setInformativeText(meaning);
    const QPushButton* replace = box.addButton(tr("Replace"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == replace;
  };
}

ImportFlow::~ImportFlow() {
  m_copier.waitForDone();
}

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
  const QString path = QDir::cleanPath(QFileInfo(file).absoluteFilePath());
  m_lastFolder = QFileInfo(path).absolutePath();
  auto* dialog = new ImportDialog(m_reader, path, kind, m_window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  if (!liesOutside(path)) dialog->hideCopy();
  connect(dialog, &QDialog::accepted, this, [this, dialog, path] { accept(path, *dialog); });
  dialog->open();
}

void ImportFlow::accept(const QString& file, const ImportDialog& dialog) {
  const bool terrain = importKindOf(file) == ImportKind::Terrain;
  const ImportFindings findings = dialog.findings();
  const bool copy = dialog.copyWanted() && liesOutside(file);
  Accepted accepted{terrain ? &kTerrainType : &kModelType, file, {}};
  accepted.details.options = dialog.options();
  accepted.details.credit = findings.credit;
  accepted.details.view = findings.view;
  if (!terrain) accepted.details.position = placeForModel();
  // The dialog may be gone when the question is answered.
  const SceneNode* old = terrain ? m_document->scene().firstOf(kTerrainType) : nullptr;
  if (old && !mayReplace(*old)) return;
  if (copy && !m_document->path().isEmpty()) return copyAndAdd(accepted);
  accepted.details.copyOnSave = copy;
  add(accepted);
}

bool ImportFlow::mayReplace(const SceneNode& terrain) {
  QString meaning = tr("Its coordinates, credit line, name and import options go with it.");
  const QStringList layers = paintedLayers(m_document->scene());
  if (!layers.isEmpty())
    meaning +=
        QStringLiteral("\n\n") +
        tr("What is painted on it (%1) is kept cell by cell if the new terrain has as many columns and "
           "rows. Otherwise it is left out, and the list of issues says so.")
            .arg(layers.join(QStringLiteral(", ")));
  return askReplace(tr("Replace the terrain \"%1\"?").arg(QString::fromStdString(terrain.name)), meaning);
}

void ImportFlow::copyAndAdd(const Accepted& accepted) {
  const QString scene = m_document->path();
  m_copier.start([this, scene, accepted] {
    const Result<std::string> copy = copyBeside(accepted.file.toStdString(), scene.toStdString());
    QMetaObject::invokeMethod(this, [this, scene, accepted, copy] {
      if (!copy) return showError(copy.error());
      if (m_document->path() != scene) {
        Q_EMIT message(tr("\"%1\" was not imported: another scene was opened meanwhile.")
                           .arg(QFileInfo(accepted.file).fileName()));
        return;
      }
      Accepted copied = accepted;
      copied.file = QString::fromStdString(*copy);
      Q_EMIT message(tr("Copied to \"%1\".").arg(QDir::toNativeSeparators(copied.file)));
      add(copied);
    });
  });
}

void ImportFlow::add(const Accepted& accepted) {
  const bool first = accepted.type == &kTerrainType && !m_document->scene().firstOf(kTerrainType);
  const bool outside = liesOutside(accepted.file);
  const Result<std::string> added =
      edit::addAssetNode(*m_document, *accepted.type, accepted.file, accepted.details);
  if (!added) return showError(added.error());
  if (first) Q_EMIT firstTerrainAdded();
  if (accepted.type == &kModelType) Q_EMIT modelAdded(*added);
  if (accepted.details.copyOnSave)
    Q_EMIT message(tr("\"%1\" will be copied beside the scene when it is saved.")
                       .arg(QFileInfo(accepted.file).fileName()));
  else if (outside)
    Q_EMIT message(tr("The file stays where it is; scenes may use the folder \"%1\" from now on.")
                       .arg(QDir::toNativeSeparators(QFileInfo(accepted.file).absolutePath())));
}

bool ImportFlow::liesOutside(const QString& file) const {
  return !resolveAssetPath(m_document->path().toStdString(), m_document->storedPath(file), {});
}

std::optional<Vec3d> ImportFlow::placeForModel() const {
  const Sight seen = sight ? sight() : Sight();
  const std::optional<Vec3d> at = seen.ground ? seen.ground : cameraTarget(m_document->scene());
  if (!at) return {};
  return standingPlace(*at, seen.terrain ? &seen.terrain->heights : nullptr);
}

void ImportFlow::showError(const Error& error) {
  QMessageBox::warning(m_window, tr("Import"), QString::fromStdString(error.text()));
}

Status ImportFlow::collect() {
  const Result<int> collected = edit::collectFiles(*m_document);
  if (!collected) return collected.error();
  Q_EMIT message(*collected == 0 ? tr("All files lie in the scene's folder already; nothing was copied.")
                                 : tr("%n file(s) copied to \"%1\". Save the scene to use them from there.",
                                      nullptr, *collected)
                                       .arg(QDir::toNativeSeparators(QString::fromStdString(
                                           assetFolderOf(m_document->path().toStdString())))));
  return {};
}

}  // namespace spin
