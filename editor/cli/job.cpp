// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/cli/job.h"

#include <fmt/format.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/base/log.h"
#include "core/flow/flow_scene.h"
#include "core/nodes/settings_nodes.h"
#include "editor/cli/job_export.h"
#include "editor/cli/manifest.h"
#include "plugins/host/plugin_host.h"
#include "plugins/sdk/output_file.h"
#ifdef SPIN_HAVE_EMBREE
#include "core/raycast/embree_ray_scene.h"
#endif
#ifdef SPIN_HAVE_CUDA
#include "gpu/cuda_device.h"
#include "gpu/flow_solver_cuda.h"
#include "gpu/map_raster_cuda.h"
#endif

namespace spin {
namespace {

namespace fs = std::filesystem;

/// Simulating again is worth it when a cached frame turns out to be damaged, but not for ever.
constexpr int kRepairs = 3;

bool canWrite(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  const std::string probe = fmt::format("{}/.probe{}", folder, ::getpid());
  const bool written = static_cast<bool>(std::ofstream(probe) << "x");
  fs::remove(probe, error);
  return written;
}

std::string sizeText(double bytes) {
  if (bytes < 1e6) return fmt::format("{:.0f} kB", bytes / 1e3);
  return bytes < 1e9 ? fmt::format("{:.1f} MB", bytes / 1e6) : fmt::format("{:.2f} GB", bytes / 1e9);
}

std::string durationText(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", std::ceil(seconds));
  return seconds < 5400.0 ? fmt::format("{:.0f} min", seconds / 60.0)
                          : fmt::format("{:.1f} h", seconds / 3600.0);
}

Status cardIsThere() {
#ifdef SPIN_HAVE_CUDA
  return cudaAvailable() ? Status() : Status(cudaDevice().error());
#else
  return Error{ErrorKind::Failed, "The flow cannot be computed on a card", "--device cuda",
               "this program was built without CUDA", "Use --device cpu"};
#endif
}

/// The nearest folder above (or at) the path that exists.
std::string existingParent(const std::string& path) {
  fs::path folder = fs::absolute(path);
  std::error_code error;
  while (!fs::exists(folder, error) && folder.has_parent_path() && folder != folder.parent_path())
    folder = folder.parent_path();
  return folder.string();
}

struct Disk {
  std::uint64_t id = 0;
  double freeBytes = -1.0;  ///< < 0 = unknown
};

Disk diskOf(const std::string& path) {
  struct statvfs info {};
  if (::statvfs(existingParent(path).c_str(), &info) != 0) return {};
  return {info.f_fsid, static_cast<double>(info.f_bavail) * static_cast<double>(info.f_frsize)};
}

/// Upper estimate of what the formats take on disk.
double exportBytes(const SceneSnapshot& scene, const JobOptions& options, FrameRange frames,
                   double frameBytes, const PluginHost& plugins) {
  const RenderNode render = scene.settings<RenderNode>(0.0);
  const double pixels = static_cast<double>(render.width) * render.height;
  const std::vector<std::string> ids = plugins.exporterIds();
  double perFrame = 0.0;
  for (const std::string& format : options.formats) {
    const bool cache = std::find(ids.begin(), ids.end(), format) != ids.end();
    // Uncompressed pictures; PNG needs about half of it. VTP holds its arrays in base64.
    perFrame += cache ? 1.4 * frameBytes : pixels * (format == "exr" ? 16.0 : format == "png16" ? 6.0 : 3.0);
  }
  return perFrame * frames.count();
}

class Job {
 public:
  Job(const JobOptions& options, const PluginHost& plugins, const ProgressSink& progress,
      const CancelToken& cancel)
      : m_options(options), m_plugins(plugins), m_progress(progress), m_cancel(cancel) {}

  Result<JobReport> run();

 private:
  Status prepare();
  Status checkRoom();
  Status simulate();
  Status exportFrames();
  Result<FramePointer> frameAt(int frame);
  Status writeManifest(const JobExport& out);
  void report(const std::string& stage, int frame, int first, double stageShare, double base, double share,
              double left);

  const JobOptions& m_options;
  const PluginHost& m_plugins;
  const ProgressSink& m_progress;
  const CancelToken& m_cancel;
  OpenedScene m_opened;
  RunOptions m_run;
  std::unique_ptr<FrameStore> m_store;
  double m_simulationShare = 0.0;  ///< of the whole job, by frames
  double m_fraction = 0.0;
  JobReport m_report;
};

void Job::report(const std::string& stage, int frame, int first, double stageShare, double base, double share,
                 double left) {
  m_fraction = std::max(m_fraction, base + share * stageShare);
  // How long an export takes is not known before it has begun.
  const bool more = stage == "simulate" && !m_options.formats.empty();
  if (m_progress)
    m_progress({stage, frame, first, m_report.frames.last, m_fraction, more ? -1.0 : left, left});
}

Result<JobReport> Job::run() {
  // Whatever can be refused is refused before the long work.
  if (Status known = checkFormats(m_options, m_plugins); !known) return known.error();
  if (Status prepared = prepare(); !prepared) return prepared.error();
  if (Status room = checkRoom(); !room) return room.error();
  if (Status made = makeOutputFolders(m_options); !made) return made.error();
  if (Status simulated = simulate(); !simulated) {
    Error error = simulated.error();
    if (error.kind == ErrorKind::Cancelled) error.advice = "Start it again to go on from the cached frames";
    return error;
  }
  if (!m_options.formats.empty())
    if (Status exported = exportFrames(); !exported) return exported.error();
  return m_report;
}

Status Job::prepare() {
  if (m_progress) m_progress({"load"});
  Result<OpenedScene> opened = openScene(m_options.scene, makeHelperAssetReader(), m_cancel);
  if (!opened) return opened.error();
  m_opened = std::move(*opened);
  if (Status whole = requireFiles(m_opened); !whole) return whole;
  m_report.frames = m_options.frames.value_or(sceneRange(*m_opened.snapshot));
  if (m_report.frames.count() < 1)
    return Error{ErrorKind::BadInput, "There is nothing to do", m_opened.file,
                 fmt::format("the scene's first frame {} lies after its last frame {}", m_report.frames.first,
                             m_report.frames.last),
                 "Correct first_frame and last_frame, or name the range with --frames"};
  if (m_options.device == "cuda") {
    if (!sceneHasFlow(*m_opened.snapshot))
      logWarning("no process of this scene runs on the GPU; it is computed on the CPU");
    else if (Status there = cardIsThere(); !there)
      return there;
  }
  m_run = runOptionsFor(m_options, m_report.frames.last);
  m_report.cache = cacheFolderFor(m_opened.file, m_options.cache, m_options.output);
  FrameStoreOptions store;
  store.directory = m_report.cache;
  m_store = std::make_unique<FrameStore>(store);
  return {};
}

Status Job::checkRoom() {
  const RunEstimate need = estimateRun(*m_opened.snapshot, *m_store, m_run);
  m_report.simulatedFrames = need.framesToCompute;
  // Found now, not after the first frame has been computed.
  if (need.framesToCompute > 0 && !canWrite(m_report.cache))
    return Error{ErrorKind::OutOfResources, "The cache folder cannot be written", m_report.cache,
                 "no file can be made there", "Name another folder with --cache"};
  const double output =
      exportBytes(*m_opened.snapshot, m_options, m_report.frames, need.frameBytes, m_plugins);
  const int exported = m_options.formats.empty() ? 0 : m_report.frames.count();
  m_simulationShare =
      exported == 0 ? 1.0 : static_cast<double>(need.framesToCompute) / (need.framesToCompute + exported);
  logInfo(fmt::format("{} frames to simulate ({} memory, {} cache in {}), {} to export (at most {} in {})",
                      need.framesToCompute, sizeText(need.memoryBytes), sizeText(need.diskBytes),
                      m_report.cache, exported, sizeText(output), m_options.output));
  if (need.particles > 0.0 && need.seconds > 0.0)
    logInfo(fmt::format("at most {:.0f} particles; about {} of computing on {} threads ({})", need.particles,
                        durationText(need.seconds), CpuBackend(m_run.threads).threads(),
                        backendName(m_run.isa)));
  const Disk cache = diskOf(m_report.cache), out = diskOf(m_options.output);
  const bool shared = cache.id == out.id;
  const auto lacks = [](const Disk& disk, double bytes) {
    return disk.freeBytes >= 0.0 && disk.freeBytes < bytes;
  };
  const double onCache = need.diskBytes + (shared ? output : 0.0);
  for (const auto& [disk, bytes, folder] :
       {std::tuple(cache, onCache, m_report.cache), std::tuple(out, output, m_options.output)})
    if (lacks(disk, bytes))
      return Error{
          ErrorKind::OutOfResources, "The job does not fit on the disk", folder,
          fmt::format("about {} are needed and {} are free", sizeText(bytes), sizeText(disk.freeBytes)),
          "Free some space, export fewer frames or formats, or choose other folders with --output and "
          "--cache"};
  return {};
}

Status Job::simulate() {
  RunCallbacks callbacks;
  callbacks.progress = [this](const RunProgress& p) {
    report("simulate", p.frame, 0, p.fractionDone, 0.0, m_simulationShare, p.secondsLeft);
    m_report.timings = p.timings;
  };
  return runSimulation(*m_opened.snapshot, *m_store, m_run, callbacks, m_cancel);
}

/// A frame from the cache; simulates again if it turns out to be damaged.
Result<FramePointer> Job::frameAt(int frame) {
  for (int attempt = 0; attempt < kRepairs; ++attempt) {
    if (FramePointer found = m_store->get(frame)) return found;
    if (Status again = simulate(); !again) return again.error();
  }
  return Error{ErrorKind::Failed, "The frame cannot be kept in the cache", fmt::format("frame {}", frame),
               "it was simulated and could not be read back",
               "Check the disk of the cache folder " + m_report.cache};
}

Status Job::exportFrames() {
  JobExport out(m_opened, m_options, m_report.frames, m_plugins, m_report.cache, m_cancel);
  if (Status begun = out.begin(); !begun) return begun;
  const auto start = std::chrono::steady_clock::now();
  Status status;
  for (int frame = m_report.frames.first; frame <= m_report.frames.last && status; ++frame) {
    const int done = frame - m_report.frames.first;
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    report("export", frame, m_report.frames.first, static_cast<double>(done) / m_report.frames.count(),
           m_simulationShare, 1.0 - m_simulationShare,
           done > 0 ? spent / done * (m_report.frames.count() - done) : -1.0);
    const Result<FramePointer> found = frameAt(frame);
    status = found ? out.writeFrame(*found) : Status(found.error());
  }
  const Status finished = out.finish();
  if (!status) return status;
  if (!finished) return finished;
  m_report.written = out.written();
  m_report.timings.merge(out.timings());
  return writeManifest(out);
}

Status Job::writeManifest(const JobExport& out) {
  const std::string text =
      manifestText(m_opened, m_options, m_report.frames, out.outputsForManifest(), out.rendererName());
  OutputFile file((fs::path(m_options.output) / "manifest.json").string());
  if (Status written = file.write({text.begin(), text.end()}); !written) return written;
  return file.commit(text.size());
}

}  // namespace

Result<FrameRange> parseFrameRange(const std::string& text) {
  const Error wrong{ErrorKind::Usage, "The range of frames makes no sense", text,
                    "it is not A:B with 0 <= A <= B", "Write for instance --frames 0:119"};
  const auto read = [](std::string_view word, int& value) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size() && value >= 0 && value <= 1000000;
  };
  const std::size_t colon = text.find(':');
  FrameRange range;
  if (!read(std::string_view(text).substr(0, colon), range.first)) return wrong;
  range.last = range.first;
  if (colon != std::string::npos && !read(std::string_view(text).substr(colon + 1), range.last)) return wrong;
  return range.count() >= 1 ? Result<FrameRange>(range) : Result<FrameRange>(wrong);
}

std::vector<std::string> defaultFormats() {
  return {"png8", "ply", "vtp", "cover_tif"};
}

RaySceneFactory programRayCaster() {
#ifdef SPIN_HAVE_EMBREE
  return makeEmbreeRayScene;
#else
  return makeBvhRayScene;
#endif
}

std::string cacheFolderFor(const std::string& sceneFile, const std::string& wish,
                           const std::string& fallback) {
  if (!wish.empty()) return wish;
  const fs::path scene(sceneFile);
  const std::string name = scene.stem().string() + ".cache";
  const std::string beside = (scene.parent_path() / name).string();
  if (canWrite(beside)) return beside;
  const std::string other = (fs::path(fallback) / name).string();
  logWarning(fmt::format("{} cannot be written; the cache goes to {}", beside, other));
  return other;
}

FrameRange sceneRange(const SceneSnapshot& scene) {
  const SimulationNode settings = scene.settings<SimulationNode>(0.0);
  return {settings.firstFrame, settings.lastFrame};
}

RunOptions runOptionsFor(const JobOptions& job, int lastFrame) {
  RunOptions options;
  options.lastFrame = lastFrame;
  options.threads = job.threads;
  options.isa = job.isa;
  options.makeRayScene = programRayCaster();
#ifdef SPIN_HAVE_CUDA
  // Only where it is asked for by name: the editor and other machines then share the cache.
  if (job.device == "cuda" && cudaAvailable()) {
    options.makeFlowSolver = makeFlowSolverCuda;
    options.makeMapRaster = makeMapRasterCuda;
    options.device = cudaDevice().value().backend;
  }
#endif
  return options;
}

Result<JobReport> runJob(const JobOptions& options, const PluginHost& plugins, const ProgressSink& progress,
                         const CancelToken& cancel) {
  return Job(options, plugins, progress, cancel).run();
}

}  // namespace spin
