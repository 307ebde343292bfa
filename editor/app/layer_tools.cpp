// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/layer_tools.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <cmath>

#include "core/fields/terrain_surface.h"
#include "core/scene/layer_import.h"
#include "plugins/host/plugin_host.h"

namespace spin {
namespace {

/// A dense copy for filters; only of measures.
Raster<float> rasterOf(const TiledRaster<float>& layer, double cellSize) {
  Raster<float> raster(layer.width(), layer.height(), 0.0, 0.0, cellSize);
  for (int j = 0; j < raster.height; ++j)
    for (int i = 0; i < raster.width; ++i) raster.at(i, j) = layer.at(i, j);
  return raster;
}

TiledRaster<float> layerOf(const Raster<float>& raster, const PaintedKind& kind) {
  TiledRaster<float> layer(raster.width, raster.height, kind.blank);
  for (int j = 0; j < raster.height; ++j)
    for (int i = 0; i < raster.width; ++i) {
      const float v = raster.at(i, j);
      layer.set(i, j,
                std::isnan(v) ? kind.blank
                              : std::clamp(v, static_cast<float>(kind.least), static_cast<float>(kind.most)));
    }
  return layer;
}

struct FillWork {
  PaintedLayer layer;
  const PaintedKind* kind;
  std::shared_ptr<const TerrainData> terrain;
  std::shared_ptr<const TerrainShape> shape;
  FillDialog::Choice choice;
  double base;
};

Result<LayerAnswer> filledLayer(const FillWork& work) {
  CpuBackend backend;
  const Raster<float>& heights = work.terrain->heights;
  const Raster<float> weights =
      fillWeights(heights, *work.shape, work.choice.rule, work.terrain->geo.origin.z, backend);
  LayerAnswer answer;
  double sum = 0.0;
  std::size_t ground = 0;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    sum += static_cast<double>(weights.values[k]);
    if (!std::isnan(heights.values[k])) ++ground;
  }
  answer.share = ground > 0 ? sum / static_cast<double>(ground) : 0.0;
  answer.area = sum * heights.cellSize * heights.cellSize;
  if (work.kind->numbers) {
    const auto value = static_cast<std::uint8_t>(work.choice.value);
    answer.layer = filled(std::get<TiledRaster<std::uint8_t>>(work.layer), weights, value);
  } else {
    const LayerFill fill{work.choice.combine, work.choice.value, work.base, work.kind->least,
                         work.kind->most};
    answer.layer = filled(std::get<TiledRaster<float>>(work.layer), weights, fill);
  }
  return answer;
}

}  // namespace

LayerTools::LayerTools(SceneDocument* document, std::shared_ptr<AssetReader> reader,
                       const PluginHost* plugins, Viewport* viewport, QWidget* window)
    : QObject(window),
      m_document(document),
      m_reader(std::move(reader)),
      m_plugins(plugins),
      m_viewport(viewport),
      m_window(window) {
  askOpen = [this](const QString& title, const QString& filter) {
    return QFileDialog::getOpenFileName(m_window, title, {}, filter);
  };
  askSave = [this](const QString& title, const QString& suggestion, const QString& filter) {
    return QFileDialog::getSaveFileName(m_window, title, suggestion, filter);
  };
  connect(&m_job, &LayerJob::done, this, &LayerTools::take);
  connect(&m_job, &LayerJob::failed, this, &LayerTools::fail);
  connect(&m_writer, &LayerJob::done, this, [this] { Q_EMIT message(tr("Written: %1").arg(m_written)); });
  connect(&m_writer, &LayerJob::failed, this, &LayerTools::message);
}

bool LayerTools::possible() const {
  const SnapshotPointer scene = m_viewport->context().scene;
  return scene && scene->terrain && !scene->terrain->heights.empty();
}

std::optional<LayerTools::Target> LayerTools::target() {
  if (m_document->isLoadingLayers()) {
    Q_EMIT message(tr("The painted layers are still being read."));
    return std::nullopt;
  }
  if (m_accepted) {
    Q_EMIT message(tr("The last change of a layer is still being worked out."));
    return std::nullopt;
  }
  if (!possible()) {
    Q_EMIT message(tr("There is no terrain to paint on: import one first."));
    return std::nullopt;
  }
  const SnapshotPointer scene = m_viewport->context().scene;
  Target target;
  target.kind = &m_viewport->brush().kind();
  target.layer = m_viewport->layerToPaint();
  target.terrain = scene->terrain;
  // The snapshot may be a moment behind the document.
  const SceneNode* node = m_document->node(m_viewport->brush().node());
  if (!node || node->type != target.kind->type) node = m_document->scene().firstOf(*target.kind->type);
  if (node) target.node = node->id;
  return target;
}

/// Shows a dialog beside the view; only one at a time.
bool LayerTools::open(QDialog* dialog, const QString& text) {
  const std::optional<Target> wanted = target();
  if (m_dialog) m_dialog->reject();
  if (!wanted) {
    delete dialog;
    return false;
  }
  m_target = *wanted;
  m_text = text;
  m_dialog = dialog;
  m_preview.reset();
  m_accepted = false;
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, &LayerTools::accept);
  connect(dialog, &QDialog::rejected, this, &LayerTools::reject);
  dialog->show();
  return true;
}

void LayerTools::take(const LayerAnswer& answer) {
  m_preview = answer.layer;
  if (m_accepted && !m_job.busy()) return commit();
  m_viewport->setPreview(Viewport::LayerPreview{m_target.kind, m_target.node, answer.layer});
  if (auto* dialog = qobject_cast<FillDialog*>(m_dialog.data()))
    dialog->showExtent(answer.share, answer.area);
  if (auto* dialog = qobject_cast<LayerFileDialog*>(m_dialog.data()); dialog && m_raster)
    dialog->showFindings(*m_raster, answer.remarks);
}

void LayerTools::fail(const QString& text) {
  m_preview.reset();
  m_accepted = false;
  m_viewport->setPreview(std::nullopt);
  if (auto* filter = qobject_cast<FilterDialog*>(m_dialog.data())) return filter->showProblem(text);
  if (auto* file = qobject_cast<LayerFileDialog*>(m_dialog.data())) return file->showProblem(text);
  Q_EMIT message(text);
}

/// What was asked for last is taken, even if it is still being worked out.
void LayerTools::accept() {
  m_dialog = nullptr;
  m_accepted = true;
  if (!m_job.busy()) commit();
}

void LayerTools::reject() {
  m_dialog = nullptr;
  m_job.forget();
  m_preview.reset();
  m_viewport->setPreview(std::nullopt);
}

void LayerTools::commit() {
  m_accepted = false;
  const SceneNode* known = m_document->node(m_target.node);
  if (m_preview && !(known && known->painted == *m_preview)) {
    QUndoStack* undo = m_document->undoStack();
    const QString name = QCoreApplication::translate("Properties", m_target.kind->label);
    const std::string selected = m_document->selected();
    undo->beginMacro(m_text.arg(name));
    Result<std::string> node = m_target.node;
    if (m_target.node.empty()) {
      node = edit::addNode(*m_document, *m_target.kind->type,
                           QCoreApplication::translate("Properties", m_target.kind->type->label));
      m_document->select(selected);
    }
    const Status status = node.ok() ? edit::paint(*m_document, *node, *m_preview, 0) : Status(node.error());
    undo->endMacro();
    if (!status.ok()) Q_EMIT message(QString::fromStdString(status.error().text()));
  }
  m_preview.reset();
  m_viewport->setPreview(std::nullopt);
}

void LayerTools::fill() {
  if (!possible()) return void(target());
  const SnapshotPointer scene = m_viewport->context().scene;
  const Vec2d range = valueRange(scene->terrain->heights);
  const double sea = scene->terrain->geo.origin.z;
  auto* dialog = new FillDialog(m_viewport->brush().kind(), m_viewport->brush().value(), range.x + sea,
                                range.y + sea, m_window);
  connect(dialog, &FillDialog::changed, this, &LayerTools::askFill);
  if (open(dialog, tr("Fill %1"))) askFill();
}

void LayerTools::askFill() {
  const auto* dialog = qobject_cast<FillDialog*>(m_dialog.data());
  if (!dialog) return;
  const SnapshotPointer scene = m_viewport->context().scene;
  const double base = unpaintedValue(*scene, *m_target.kind, m_viewport->context().filmTime);
  FillWork work{m_target.layer, m_target.kind, m_target.terrain, nullptr, dialog->choice(), base};
  // The first piece of work finds the terrain's shape, the others use it.
  if (m_shapeOf != m_target.terrain) m_shape = std::make_shared<std::optional<TerrainShape>>();
  m_shapeOf = m_target.terrain;
  m_job.start([work, shape = m_shape]() mutable {
    if (!shape->has_value()) {
      CpuBackend backend;
      shape->emplace(terrainShape(work.terrain->heights, backend));
    }
    work.shape = std::shared_ptr<const TerrainShape>(shape, &**shape);
    return filledLayer(work);
  });
}

void LayerTools::filter() {
  if (!possible()) return void(target());
  if (m_viewport->brush().kind().numbers) {
    Q_EMIT message(
        tr("Filters work on temperature, depth and keep-clear layers; for ground types there is "
           "the smoothing brush."));
    return;
  }
  const std::vector<LayerFilterInfo> filters = m_plugins->layerFilters();
  if (filters.empty()) {
    Q_EMIT message(tr("No plugin with filters is installed."));
    return;
  }
  auto* dialog = new FilterDialog(m_viewport->brush().kind(), filters, m_window);
  connect(dialog, &FilterDialog::changed, this, &LayerTools::askFilter);
  if (open(dialog, tr("Filter %1"))) askFilter();
}

void LayerTools::askFilter() {
  const auto* dialog = qobject_cast<FilterDialog*>(m_dialog.data());
  const LayerFilter* filter = dialog ? m_plugins->layerFilter(dialog->filter()) : nullptr;
  if (!filter) return;
  const double cell = m_target.terrain->heights.cellSize;
  const LayerFilterSettings settings{dialog->radius() / cell, dialog->threshold(),
                                     m_target.kind->unit == Unit::Factor};
  m_job.start([filter, settings, cell, id = dialog->filter(), target = m_target]() -> Result<LayerAnswer> {
    Raster<float> values = rasterOf(std::get<TiledRaster<float>>(target.layer), cell);
    if (Status status = filter->apply(id, settings, values); !status) return status.error();
    return LayerAnswer{layerOf(values, *target.kind), {}};
  });
}

void LayerTools::importFile() {
  if (!target()) return;
  const QString file = askOpen(tr("Import a layer"), tr("Rasters (*.png *.tif *.tiff *.asc *.xyz)"));
  if (file.isEmpty()) return;
  m_raster = nullptr;
  m_rasterPath = file.toStdString();
  auto* dialog = new LayerFileDialog(m_viewport->brush().kind(), LayerFileDialog::Way::Import, m_window);
  connect(dialog, &LayerFileDialog::changed, this, &LayerTools::askImport);
  if (open(dialog, tr("Import %1"))) askImport();
}

void LayerTools::askImport() {
  const auto* dialog = qobject_cast<LayerFileDialog*>(m_dialog.data());
  if (!dialog) return;
  const LayerFormat format = dialog->format();
  // The first piece of work reads the file, the others use what it found.
  if (!m_raster) m_raster = std::make_shared<RasterImport>();
  m_job.start([raster = m_raster, reader = m_reader, path = m_rasterPath, format,
               target = m_target]() -> Result<LayerAnswer> {
    if (raster->values.empty()) {
      Result<RasterImport> read = reader->readRaster(path, CancelToken());
      if (!read.ok()) return read.error();
      *raster = std::move(*read);
    }
    Result<LaidRaster> laid =
        laidOver(*raster, *target.terrain, *target.kind, {format.low, format.high}, path);
    if (!laid.ok()) return laid.error();
    return LayerAnswer{std::move(laid->layer), std::move(laid->remarks)};
  });
}

void LayerTools::exportFile() {
  const std::optional<Target> wanted = target();
  if (!wanted) return;
  auto* dialog = new LayerFileDialog(*wanted->kind, LayerFileDialog::Way::Export, m_window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog, target = *wanted] {
    const QString ending = dialog->ending();
    const QString name = target.node.empty() ? QString::fromLatin1(target.kind->type->id)
                                             : QString::fromStdString(target.node);
    QString file =
        askSave(tr("Export a layer"), name + QLatin1Char('.') + ending, QStringLiteral("*.%1").arg(ending));
    if (file.isEmpty()) return;
    if (QFileInfo(file).suffix().isEmpty()) file += QLatin1Char('.') + ending;
    write(file, dialog->format(), target);
  });
  dialog->show();
}

void LayerTools::write(const QString& file, LayerFormat format, const Target& target) {
  format.unit = target.kind->fileUnit;
  m_written = file;
  m_writer.start([reader = m_reader, target, format, path = file.toStdString()]() -> Result<LayerAnswer> {
    const Status status = reader->writeLayer(target.layer, format, *target.terrain, path);
    if (!status.ok()) return status.error();
    return LayerAnswer{};
  });
}

void LayerTools::clear() {
  const std::optional<Target> wanted = target();
  if (!wanted || wanted->node.empty()) return;
  m_target = *wanted;
  m_text = tr("Clear %1");
  const Raster<float>& heights = m_target.terrain->heights;
  const PaintedKind& kind = *m_target.kind;
  if (kind.numbers)
    m_preview =
        TiledRaster<std::uint8_t>(heights.width, heights.height, static_cast<std::uint8_t>(kind.blank));
  else
    m_preview = TiledRaster<float>(heights.width, heights.height, kind.blank);
  commit();
}

}  // namespace spin
