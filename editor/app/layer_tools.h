// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>
#include <functional>
#include <memory>

#include "editor/app/fill_dialog.h"
#include "editor/app/layer_dialogs.h"
#include "editor/app/layer_job.h"
#include "editor/commands/edits.h"
#include "editor/viewport/viewport.h"

namespace spin {

class PluginHost;

/// What is done to the whole painted layer that the brush works on: fill, filters, import, export, clearing.
/// Dialogs stay open beside the view, which shows what would come; accepting is one undo step.
class LayerTools : public QObject {
  Q_OBJECT
 public:
  LayerTools(SceneDocument* document, std::shared_ptr<AssetReader> reader, const PluginHost* plugins,
             Viewport* viewport, QWidget* window);

  void fill();
  void filter();
  void importFile();
  void exportFile();
  /// Takes away all that is painted.
  void clear();
  /// Whether there is a terrain, so that a layer has a size.
  bool possible() const;

  /// File dialogs: title and filter to a path, empty when cancelled. Functions, so that tests answer.
  std::function<QString(const QString& title, const QString& filter)> askOpen;
  std::function<QString(const QString& title, const QString& suggestion, const QString& filter)> askSave;
  bool busy() const { return m_job.busy() || m_writer.busy(); }

 Q_SIGNALS:
  void message(const QString& text);

 private:
  /// The layer that is worked on, frozen when a dialog opens.
  struct Target {
    const PaintedKind* kind = nullptr;
    std::string node;  ///< empty = to be made
    PaintedLayer layer;
    std::shared_ptr<const TerrainData> terrain;
  };
  std::optional<Target> target();
  bool open(QDialog* dialog, const QString& text);
  void take(const LayerAnswer& answer);
  void fail(const QString& text);
  void accept();
  void reject();
  void commit();
  void askFill();
  void askFilter();
  void askImport();
  void write(const QString& file, LayerFormat format, const Target& target);

  SceneDocument* m_document;
  std::shared_ptr<AssetReader> m_reader;
  const PluginHost* m_plugins;
  Viewport* m_viewport;
  QWidget* m_window;
  LayerJob m_job;
  LayerJob m_writer;
  QString m_written;  ///< the file that the writer writes
  Target m_target;
  std::shared_ptr<const TerrainData> m_shapeOf;
  std::shared_ptr<std::optional<TerrainShape>> m_shape;  ///< of that terrain; written by the job's thread
  std::shared_ptr<RasterImport> m_raster;                ///< what is imported; written by the job's thread
  std::string m_rasterPath;
  std::optional<PaintedLayer> m_preview;
  bool m_accepted = false;  ///< take the answer that is to come
  QString m_text;           ///< of the undo step
  QPointer<QDialog> m_dialog;
};

}  // namespace spin
