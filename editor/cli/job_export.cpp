// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/cli/job_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "core/base/check.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/scene/flake_shapes.h"
#include "core/snow/flake_field.h"
#include "editor/cli/bitmap_font.h"
#include "editor/cli/cancel_watch.h"
#include "editor/cli/legend_painter.h"
#include "editor/render/air_values.h"
#include "editor/render/cover_values.h"
#include "editor/render/egl_context.h"
#include "editor/render/flow_scale.h"
#include "editor/render/renderer.h"
#include "plugins/host/plugin_host.h"
#include "plugins/sdk/output_file.h"

namespace spin {
namespace {

namespace fs = std::filesystem;

Error cancelledAt(int frame) {
  return {ErrorKind::Cancelled, "The export was cancelled", fmt::format("frame {}", frame),
          "the user stopped it", "Finished files are kept"};
}

std::uint64_t bytesOf(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  return error ? 0 : size;
}

}  // namespace

struct JobExport::Pictures {
  ImageFormat format;
  ImageWriter* writer = nullptr;
  std::vector<std::string> files;  ///< names in the folder
};

struct JobExport::Cache {
  std::string format;
  std::unique_ptr<CacheExporter> exporter;
};

Status checkFormats(const JobOptions& options, const PluginHost& plugins) {
  std::vector<std::string> known;
  for (const ImageFormat& format : plugins.imageFormats()) known.push_back(format.id);
  for (const std::string& id : plugins.exporterIds()) known.push_back(id);
  for (const std::string& format : options.formats)
    if (std::find(known.begin(), known.end(), format) == known.end())
      return Error{ErrorKind::Usage, "There is no such format", format, "no plugin writes it",
                   known.empty() ? "No export plugin was found; check the installation"
                                 : fmt::format("Choose one of {}", fmt::join(known, ", "))};
  return {};
}

Status makeOutputFolders(const JobOptions& options) {
  for (const std::string& format : options.formats) {
    const std::string folder = (fs::path(options.output) / folderOfFormat(format)).string();
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
      return Error{ErrorKind::Failed, "The output folder could not be made", folder, error.message(),
                   "Choose another folder with --output"};
  }
  return {};
}

std::string folderOfFormat(const std::string& format) {
  static const std::map<std::string, std::string> kFolders{{"png8", "images"},
                                                           {"ply", "particles"},
                                                           {"vtp", "paraview"},
                                                           {"cover_tif", "cover"},
                                                           {"vdb", "volumes"}};
  const auto found = kFolders.find(format);
  return found == kFolders.end() ? format : found->second;
}

FramePointer unwrapAtCamera(const FramePointer& frame, const SceneSnapshot& scene) {
  const Vec3d eye = cameraOf(scene, frame->info.time.film).position;
  std::shared_ptr<Frame> copy;
  for (const auto& [name, part] : frame->parts) {
    if (const auto* flakes = dynamic_cast<const FlakesPart*>(part.get())) {
      auto around = std::make_shared<ParticlePart>();
      CpuBackend backend;
      const auto snowfall = scene.settings<SnowfallNode>(frame->info.time.film);
      around->particles = flakesAround(flakes->flakes, snowfall, eye, backend);
      if (!copy) copy = std::make_shared<Frame>(*frame);
      copy->parts[name] = std::move(around);
      continue;
    }
    const auto* particles = dynamic_cast<const ParticlePart*>(part.get());
    if (!particles || particles->particles.wrapBox <= 0.0) continue;
    auto unwrapped = std::make_shared<ParticlePart>(*particles);
    ParticleSet& set = unwrapped->particles;
    for (Vec3f& p : set.positions) p = wrapAround(p.to<double>(), eye, set.wrapBox).to<float>();
    set.wrapBox = 0.0;
    if (!copy) copy = std::make_shared<Frame>(*frame);
    copy->parts[name] = std::move(unwrapped);
  }
  return copy ? FramePointer(copy) : frame;
}

FramePointer onlyParts(const FramePointer& frame, const std::vector<std::string>& parts) {
  if (parts.empty()) return frame;
  auto copy = std::make_shared<Frame>(*frame);
  std::erase_if(copy->parts, [&](const auto& entry) {
    return std::find(parts.begin(), parts.end(), entry.first) == parts.end();
  });
  return copy;
}

std::vector<std::string> creditLines(const SceneSnapshot& scene) {
  std::vector<std::string> credits;
  if (const SceneNode* terrain = scene.first<TerrainNode>()) {
    const auto* node = terrain->as<TerrainNode>();
    if (node && !node->credit.empty())
      credits.push_back(node->credit);
    else if (scene.terrain && !scene.terrain->credit.empty())
      credits.push_back(scene.terrain->credit);
  }
  return credits;
}

std::vector<std::string> captionLines(const SceneSnapshot& scene) {
  const RenderNode render = scene.settings<RenderNode>(0.0);
  if (!render.showCaption) return {};
  std::vector<std::string> lines;
  if (!render.caption.empty()) lines.push_back(render.caption);
  for (std::string& credit : creditLines(scene)) lines.push_back(std::move(credit));
  return lines;
}

JobExport::JobExport(const OpenedScene& opened, const JobOptions& options, FrameRange frames,
                     const PluginHost& plugins, std::string cacheFolder, const CancelToken& cancel)
    : m_opened(opened),
      m_options(options),
      m_frames(frames),
      m_plugins(plugins),
      m_cacheFolder(std::move(cacheFolder)),
      m_cancel(cancel),
      m_baseName(fs::path(opened.file).stem().string()) {}

JobExport::~JobExport() = default;

Status JobExport::begin() {
  if (Status known = checkFormats(m_options, m_plugins); !known) return known;
  if (Status made = makeOutputFolders(m_options); !made) return made;
  for (const std::string& format : m_options.formats) {
    const std::vector<std::string> ids = m_plugins.exporterIds();
    const bool cache = std::find(ids.begin(), ids.end(), format) != ids.end();
    if (Status made = cache ? beginCache(format) : beginPictures(format); !made) return made;
  }
  return m_pictures.empty() ? Status() : beginRenderer();
}

Status JobExport::beginRenderer() {
  Result<std::unique_ptr<EglContext>> context = EglContext::create();
  if (!context) return context.error();
  m_context = std::move(*context);
  m_renderer = std::make_unique<Renderer>();
  if (Status ready = m_renderer->initialise(); !ready) return ready;
  m_renderer->setScene(m_opened.snapshot);
  if (m_opened.snapshot->first<SnowfallNode>()) {
    const ScopedStage stage(m_timings, "grow flakes");
    auto atlas =
        obtainFlakeAtlas(atlasSettingsOf(*m_opened.snapshot), m_cacheFolder, m_cancel, {}, m_options.threads);
    if (!atlas) return atlas.error();
    m_renderer->setFlakeAtlas(*atlas);
  }
  if (m_options.abandon) m_watch = std::make_unique<CancelWatch>(m_cancel);
  return {};
}

Status JobExport::beginPictures(const std::string& format) {
  const std::vector<ImageFormat> known = m_plugins.imageFormats();
  const auto found =
      std::find_if(known.begin(), known.end(), [&](const ImageFormat& f) { return f.id == format; });
  SPIN_CHECK(found != known.end(), "checkFormats lets only known formats pass");
  m_pictures.push_back({*found, m_plugins.imageWriter(format), {}});
  return {};
}

Status JobExport::beginCache(const std::string& format) {
  Cache cache{format, m_plugins.makeExporter(format)};
  if (!cache.exporter)
    return Error{ErrorKind::Failed, "The exporter could not be made", format, "its plugin refused", ""};
  ExportContext context{m_opened.snapshot, (fs::path(m_options.output) / folderOfFormat(format)).string(),
                        m_baseName, m_frames.first, m_frames.last};
  if (Status begun = cache.exporter->begin(context); !begun) return begun;
  m_caches.push_back(std::move(cache));
  return {};
}

std::string JobExport::pathOf(const Pictures& pictures, int frame) const {
  const std::string name = fmt::format("{}.{:04}.{}", m_baseName, frame, pictures.format.extension);
  return (fs::path(m_options.output) / folderOfFormat(pictures.format.id) / name).string();
}

Status JobExport::writePictures(const FramePointer& frame) {
  const CancelWatch::Section section(m_watch.get(), [&] {
    // The program ends without the writer's own cleaning up.
    for (const Pictures& pictures : m_pictures)
      std::remove(OutputFile::temporaryPathOf(pathOf(pictures, frame->info.time.frame)).c_str());
    const Status finished = finish();
    m_options.abandon(finished ? cancelledAt(frame->info.time.frame) : finished.error());
  });
  const double time = frame->info.time.film;
  const RenderNode settings = m_opened.snapshot->settings<RenderNode>(time);
  RenderOptions options;
  options.width = settings.width;
  options.height = settings.height;
  options.showFlakes = settings.showFlakes;
  ImageFloat image{settings.width, settings.height, {}};
  {
    const ScopedStage stage(m_timings, "render");
    m_renderer->setFrame(frame);
    Result<std::vector<float>> pixels =
        m_renderer->drawLinear(cameraOf(*m_opened.snapshot, time), time, options, settings.samples);
    if (!pixels) return pixels.error();
    image.rgba = std::move(*pixels);
  }
  const std::vector<std::string> caption = captionLines(*m_opened.snapshot);
  if (!caption.empty()) drawCaption(image, caption);
  int taken = 0;
  for (const auto& legend :
       {flowLegend(*m_opened.snapshot, frame.get(), time), coverLegend(*m_opened.snapshot, frame.get(), time),
        airLegend(*m_opened.snapshot, frame.get(), time)})
    if (legend) taken = drawLegend(image, *legend, taken);
  for (Pictures& pictures : m_pictures) {
    const ScopedStage stage(m_timings, pictures.format.id);
    const std::string path = pathOf(pictures, frame->info.time.frame);
    if (Status written = pictures.writer->write(image, pictures.format.id, path); !written) return written;
    pictures.files.push_back(fs::path(path).filename().string());
  }
  return {};
}

Status JobExport::writeFrame(const FramePointer& frame) {
  const FramePointer unwrapped = onlyParts(unwrapAtCamera(frame, *m_opened.snapshot), m_options.parts);
  for (Cache& cache : m_caches) {
    if (m_cancel.cancelled()) break;
    const ScopedStage stage(m_timings, cache.format);
    if (!cache.exporter->applies(*unwrapped)) continue;
    if (Status written = cache.exporter->writeFrame(*unwrapped); !written) return written;
  }
  if (m_cancel.cancelled()) return cancelledAt(frame->info.time.frame);
  return m_pictures.empty() ? Status() : writePictures(frame);
}

Status JobExport::finish() {
  Status status;
  for (Cache& cache : m_caches)
    if (Status finished = cache.exporter->finish(); !finished && status) status = finished;
  return status;
}

std::vector<WrittenFormat> JobExport::written() const {
  std::vector<WrittenFormat> all;
  const auto add = [&](const std::string& format, const std::vector<std::string>& files) {
    WrittenFormat entry{format, folderOfFormat(format), files.size(), 0};
    for (const std::string& file : files)
      entry.bytes += bytesOf((fs::path(m_options.output) / entry.folder / file).string());
    all.push_back(std::move(entry));
  };
  for (const Pictures& pictures : m_pictures) add(pictures.format.id, pictures.files);
  for (const Cache& cache : m_caches) add(cache.format, cache.exporter->files());
  return all;
}

JsonValue JobExport::outputsForManifest() const {
  std::vector<JsonValue> outputs;
  const auto add = [&](const std::string& format, const std::vector<std::string>& files,
                       const std::vector<ExportedAttribute>& attributes) {
    JsonValue output = JsonValue::object();
    output.set("format", JsonValue::of(format));
    output.set("folder", JsonValue::of(folderOfFormat(format)));
    std::vector<JsonValue> names, columns;
    for (const std::string& file : files) names.push_back(JsonValue::of(file));
    for (const ExportedAttribute& attribute : attributes) {
      JsonValue column = JsonValue::object();
      column.set("name", JsonValue::of(attribute.name));
      column.set("unit", JsonValue::of(attribute.unit));
      column.set("components", JsonValue::of(static_cast<double>(attribute.components)));
      columns.push_back(std::move(column));
    }
    output.set("files", JsonValue::array(std::move(names)));
    if (!columns.empty()) output.set("attributes", JsonValue::array(std::move(columns)));
    outputs.push_back(std::move(output));
  };
  for (const Pictures& pictures : m_pictures) add(pictures.format.id, pictures.files, {});
  for (const Cache& cache : m_caches)
    add(cache.format, cache.exporter->files(), cache.exporter->attributes());
  return JsonValue::array(std::move(outputs));
}

std::string JobExport::rendererName() const {
  return m_context ? m_context->rendererName() : std::string();
}

}  // namespace spin
