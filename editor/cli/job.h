// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/fields/ray_scene.h"
#include "core/sim/runner.h"
#include "editor/cli/open_scene.h"
#include "editor/cli/progress.h"

namespace spin {

class PluginHost;

/// Frames first .. last, both included.
struct FrameRange {
  int first = 0;
  int last = 0;
  int count() const { return last - first + 1; }
};
/// "A:B" or "N".
Result<FrameRange> parseFrameRange(const std::string& text);

/// What to simulate and export. The command line and the editor's export run the same job.
struct JobOptions {
  SceneRequest scene;
  std::string command = "run";  ///< for the manifest's equivalent command line: run, render or export
  std::string device = "auto";  ///< auto | cpu | cuda
  std::string isa = "auto";
  int threads = 0;
  std::optional<FrameRange> frames;  ///< absent = the scene's own range
  std::string output = "out";
  std::string cache;                 ///< absent = NAME.cache beside the scene
  std::vector<std::string> formats;  ///< image and cache formats; empty = simulate only
  std::vector<std::string> parts;    ///< of the frames that caches are written of; empty = all
  /// Ends the program; called when a cancelled job hangs in the driver, drawing a large picture. Absent: the
  /// job waits for the picture.
  std::function<void(const Error&)> abandon;
};

/// Files of one format.
struct WrittenFormat {
  std::string format;
  std::string folder;  ///< below the output folder
  std::size_t files = 0;
  std::uint64_t bytes = 0;
};

struct JobReport {
  FrameRange frames;
  int simulatedFrames = 0;  ///< computed now; the others came from the cache
  std::string cache;
  std::vector<WrittenFormat> written;
  StageTimings timings;  ///< simulation stages and export stages
};

/// The formats of `run` when none is named.
std::vector<std::string> defaultFormats();

/// Opens the scene, simulates what the cache lacks, exports, writes the manifest. Refuses with OutOfResources
/// when the disks cannot hold the result. Ends with ErrorKind::Cancelled soon after cancel; finished files
/// stay.
Result<JobReport> runJob(const JobOptions& options, const PluginHost& plugins, const ProgressSink& progress,
                         const CancelToken& cancel);

/// The ray caster that this program was built with.
RaySceneFactory programRayCaster();
/// The folder beside the scene, or one below `fallback` where that cannot be written; `wish` wins if not
/// empty.
std::string cacheFolderFor(const std::string& sceneFile, const std::string& wish,
                           const std::string& fallback);
/// The scene's own range of frames.
FrameRange sceneRange(const SceneSnapshot& scene);
/// Options of the simulation behind a job.
RunOptions runOptionsFor(const JobOptions& job, int lastFrame);

}  // namespace spin
