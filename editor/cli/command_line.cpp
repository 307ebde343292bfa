// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/base/log.h"
#include "core/bench/bench_case.h"
#include "editor/cli/commands.h"
#include "plugins/host/plugin_host.h"
#include "plugins/sdk/output_file.h"

namespace spin {
namespace {

/// All that the options fill in.
struct Words {
  JobOptions job;
  std::string frames;
  std::string progress = "text";
  bool json = false;
  bool timings = false;
  ImportRequest import;
  std::string upAxis = "file";
  std::string referenceFile;
};

void addScene(CLI::App& command, Words& words) {
  command.add_option("SCENE", words.job.scene.file, "Scene file (*.spindrift)")->required();
  command
      .add_option("--set", words.job.scene.assignments, "Set a property for this run: node.property=value")
      ->expected(1)
      ->take_all();
  command
      .add_option("--allow", words.job.scene.allowedFolders,
                  "Folder outside the scene's that its files may lie in")
      ->expected(1)
      ->take_all();
}

void addSimulation(CLI::App& command, Words& words) {
  command.add_option("--frames", words.frames, "A:B, both included; frame 0 is the initial state");
  command.add_option("--device", words.job.device, "auto, cpu or cuda")
      ->check(CLI::IsMember({"auto", "cpu", "cuda"}));
  command.add_option("--isa", words.job.isa, "auto, avx512, avx2 or baseline")
      ->check(CLI::IsMember({"auto", "avx512", "avx2", "baseline"}));
  command.add_option("--threads", words.job.threads, "Threads; 0 takes all")->check(CLI::Range(0, 1024));
  command.add_option("--cache", words.job.cache, "Cache folder (default: NAME.cache beside the scene)");
}

void addJob(CLI::App& command, Words& words, bool formats) {
  addScene(command, words);
  addSimulation(command, words);
  command.add_option("--output", words.job.output, "Output folder")->capture_default_str();
  command.add_option("--progress", words.progress, "text or json (one object per line on stdout)")
      ->check(CLI::IsMember({"text", "json"}));
  command.add_flag("--timings", words.timings, "Print the seconds of each stage at the end");
  if (formats)
    command
        .add_option("--format", words.job.formats,
                    "Format to write (repeatable): png8, png16, exr, ply, vtp, cover_tif")
        ->expected(1)
        ->take_all();
}

void addImport(CLI::App& command, Words& words) {
  ImportOptions& o = words.import.options;
  command.add_option("FILE", words.import.file, "Terrain or model file")->required();
  command.add_option("--into", words.import.into, "Scene to add it to; made if it does not exist");
  command.add_option("--name", words.import.name, "Name of the new node");
  command.add_flag("--copy", words.import.copy, "Copy the file into NAME.assets/ beside the scene");
  command
      .add_option("--allow", words.import.allowedFolders,
                  "Folder outside the scene's that its files may lie in")
      ->expected(1)
      ->take_all();
  command.add_option("--epsg", o.epsg, "EPSG code of the terrain's coordinates");
  command.add_option("--nodata", o.noDataValue,
                     "Value of cells without height, for files that cannot name one");
  command.add_option("--height-scale", o.heightScale, "Metres per unit of height, for files without a unit");
  command.add_option("--cell-size", o.cellSize, "Cell size in m, for files without coordinates");
  command.add_option("--up", words.upAxis, "Up axis of the model: file, y or z")
      ->check(CLI::IsMember({"file", "y", "z"}));
  command.add_option("--unit-scale", o.unitScale,
                     "Metres per unit of the model file; 0 = as the format says");
}

int fail(const Error& error) {
  logError(error.text());
  return exitCode(error.kind);
}

void printReport(const JobReport& report, const std::string& output, bool timings) {
  std::printf("frames %d..%d: %d simulated now, cache in %s\n", report.frames.first, report.frames.last,
              report.simulatedFrames, report.cache.c_str());
  for (const WrittenFormat& format : report.written)
    std::printf("wrote %zu files (%s, %.1f MB) to %s/%s\n", format.files, format.format.c_str(),
                static_cast<double>(format.bytes) / 1e6, output.c_str(), format.folder.c_str());
  if (!report.written.empty()) std::printf("wrote %s/manifest.json\n", output.c_str());
  if (!timings) return;
  for (const StageTime& stage : report.timings.table())
    std::printf("stage %s: %.3f s in %zu calls\n", stage.name.c_str(), stage.seconds, stage.calls);
}

Status readFrames(Words& words) {
  if (words.frames.empty()) return {};
  Result<FrameRange> range = parseFrameRange(words.frames);
  if (!range) return range.error();
  words.job.frames = *range;
  return {};
}

int jobCommand(const std::string& name, Words& words, const CancelToken& cancel) {
  if (Status frames = readFrames(words); !frames) return fail(frames.error());
  words.job.command = name;
  if (words.job.formats.empty() && name == "run") words.job.formats = defaultFormats();
  if (words.job.formats.empty() && name == "render") words.job.formats = {"png8"};
  const PluginHost plugins;
  for (const std::string& warning : plugins.warnings()) logWarning(warning);
  ProgressPrinter printer(words.progress == "json" ? ProgressStyle::Json : ProgressStyle::Lines, stdout);
  words.job.abandon = [&printer](const Error& error) {
    printer.failed(error);
    std::_Exit(fail(error));
  };
  const Result<JobReport> report = runJob(
      words.job, plugins, [&](const Progress& p) { printer.print(p); }, cancel);
  if (!report) {
    printer.failed(report.error());
    return fail(report.error());
  }
  std::size_t files = 0;
  std::uint64_t bytes = 0;
  for (const WrittenFormat& format : report->written) files += format.files, bytes += format.bytes;
  printer.done(words.job.output, files, bytes);
  if (printer.style() == ProgressStyle::Lines) printReport(*report, words.job.output, words.timings);
  return 0;
}

int infoCommand(Words& words, const CancelToken& cancel) {
  if (Status frames = readFrames(words); !frames) return fail(frames.error());
  const Result<OpenedScene> opened = openScene(words.job.scene, makeHelperAssetReader(), cancel);
  if (!opened) return fail(opened.error());
  const FrameRange range = words.job.frames.value_or(sceneRange(*opened->snapshot));
  FrameStoreOptions options;
  options.directory = cacheFolderFor(opened->file, words.job.cache, words.job.output);
  FrameStore store(options);
  store.setKeys(frameKeys(*opened->snapshot, runOptionsFor(words.job, range.last)));
  const JsonValue info = sceneInfo(*opened, store, range);
  std::fputs((words.json ? writeJson(info) : infoText(info)).c_str(), stdout);
  return 0;
}

int validateCommand(Words& words, const CancelToken& cancel) {
  const Result<OpenedScene> opened = openScene(words.job.scene, makeHelperAssetReader(), cancel);
  if (!opened) return fail(opened.error());
  int errors = 0;
  for (const SceneProblem& problem : findProblems(*opened)) {
    errors += problem.error ? 1 : 0;
    std::printf("%s: %s: %s\n", problem.error ? "error" : "warning",
                problem.node.empty() ? "scene" : problem.node.c_str(), problem.text.c_str());
  }
  if (errors == 0) std::printf("%s is fine\n", words.job.scene.file.c_str());
  return errors == 0 ? 0 : exitCode(ErrorKind::BadInput);
}

int importCommand(Words& words, const CancelToken& cancel) {
  words.import.options.upAxis = words.upAxis == "y" ? 1 : words.upAxis == "z" ? 2 : 0;
  const PluginHost plugins;
  const Status imported = importFile(words.import, plugins, cancel);
  return imported ? 0 : fail(imported.error());
}

int referenceCommand(const std::string& file) {
  const std::string page = propertyReference();
  if (file.empty()) {
    std::fputs(page.c_str(), stdout);
    return 0;
  }
  OutputFile out(file);
  Status written = out.write({page.begin(), page.end()});
  if (written) written = out.commit(page.size());
  return written ? 0 : fail(written.error());
}

int dispatch(const CLI::App& app, Words& words, const CancelToken& cancel) {
  const std::string name = app.get_subcommands().front()->get_name();
  if (name == "info") return infoCommand(words, cancel);
  if (name == "validate") return validateCommand(words, cancel);
  if (name == "import") return importCommand(words, cancel);
  if (name == "reference") return referenceCommand(words.referenceFile);
  return jobCommand(name, words, cancel);
}

void describe(CLI::App& app, Words& words) {
  app.require_subcommand(1);
  app.set_version_flag("--version", std::string("spindrift ") + SPIN_VERSION);
  addJob(*app.add_subcommand("run", "Simulate and export pictures, particles and cover"), words, true);
  addJob(*app.add_subcommand("simulate", "Simulate into the cache"), words, false);
  addJob(*app.add_subcommand("render", "Render pictures; missing frames are simulated first"), words, true);
  CLI::App* exporting =
      app.add_subcommand("export", "Write one or more formats; missing frames are simulated first");
  addJob(*exporting, words, true);
  exporting->get_option("--format")->required();
  CLI::App* info =
      app.add_subcommand("info", "Nodes, files, cache, and the mass budget of every cached frame");
  addScene(*info, words);
  addSimulation(*info, words);
  info->add_flag("--json", words.json, "As JSON");
  addScene(*app.add_subcommand("validate", "Name every problem of a scene and its files"), words);
  addImport(*app.add_subcommand("import", "Look at a terrain or model file; add it to a scene"), words);
  app.add_subcommand("reference", "Write the reference page of all properties")
      ->add_option("FILE", words.referenceFile, "Where to write it (default: stdout)");
  app.add_subcommand(
      "bench", "Measured cases: bench --list, bench [CASE...] --json FILE, bench --report DIR --json FILE");
}

}  // namespace

int cliMain(const std::vector<std::string>& arguments, const CancelToken& cancel) {
  if (!arguments.empty() && arguments[0] == "bench")
    return benchMain({arguments.begin() + 1, arguments.end()}, builtInBenchCases(), programRayCaster());
  CLI::App app("Spindrift: snow scenes without a window", "spindrift-cli");
  Words words;
  describe(app, words);
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ParseError& error) {
    return app.exit(error, std::cout, std::cerr) == 0 ? 0 : exitCode(ErrorKind::Usage);
  }
  return dispatch(app, words, cancel);
}

}  // namespace spin
