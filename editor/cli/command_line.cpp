// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/base/log.h"
#include "editor/cli/commands.h"
#include "plugins/host/plugin_host.h"
#include "plugins/sdk/output_file.h"

namespace spin {
namespace {

constexpr const char* kFooter =
    "\nA scene from nothing to pictures:\n"
    "  spindrift-cli import dem.tif --into valley.spindrift --copy\n"
    "  spindrift-cli import hut.gltf --into valley.spindrift --copy\n"
    "  spindrift-cli validate valley.spindrift\n"
    "  spindrift-cli run valley.spindrift --set weather.wind_speed_m_s=6 --output out\n"
    "\nspindrift-cli COMMAND --help names the options of a command.\n"
    "Exit codes: 0 ok, 1 run failed or an error bar missed, 2 usage, 3 bad input file, 4 out of resources,\n"
    "5 cancelled.";

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

void addAllow(CLI::App& command, std::vector<std::string>& folders) {
  command.add_option("--allow", folders, "Folder outside the scene's that its files may lie in (repeatable)")
      ->type_name("FOLDER")
      ->expected(1)
      ->take_all();
}

void addScene(CLI::App& command, Words& words) {
  command.add_option("SCENE", words.job.scene.file, "Scene file (*.spindrift)")->required();
  command
      .add_option(
          "--set", words.job.scene.assignments,
          "Set a property for this run only (repeatable), e.g. weather.wind_speed_m_s=6; info names the "
          "nodes, reference their properties")
      ->type_name("NODE.PROPERTY=VALUE")
      ->expected(1)
      ->take_all();
  addAllow(command, words.job.scene.allowedFolders);
}

void addSimulation(CLI::App& command, Words& words) {
  command
      .add_option("--frames", words.frames,
                  "Both included; frame 0 is the initial state; default: the scene's own")
      ->type_name("A:B");
  command.add_option("--device", words.job.device, "auto, cpu or cuda")
      ->check(CLI::IsMember({"auto", "cpu", "cuda"}));
  command.add_option("--isa", words.job.isa, "auto, avx512, avx2 or baseline")
      ->check(CLI::IsMember({"auto", "avx512", "avx2", "baseline"}));
  command.add_option("--threads", words.job.threads, "Threads; 0 takes all")->check(CLI::Range(0, 1024));
  command
      .add_option("--cache", words.job.cache, "Where frames are kept (default: NAME.cache beside the scene)")
      ->type_name("FOLDER");
}

void addJob(CLI::App& command, Words& words, bool formats) {
  addScene(command, words);
  addSimulation(command, words);
  command
      .add_option("--output", words.job.output,
                  formats ? "Where the files go" : "Where the cache goes if the scene's folder is read-only")
      ->type_name("FOLDER")
      ->capture_default_str();
  command.add_option("--progress", words.progress, "text or json (one object per line on stdout)")
      ->check(CLI::IsMember({"text", "json"}));
  command.add_flag("--timings", words.timings, "Print the seconds of each stage at the end");
  if (formats)
    command
        .add_option("--part", words.job.parts,
                    "Part to write to caches (repeatable; default: all): flakes, flow, air, cover")
        ->type_name("PART")
        ->expected(1)
        ->take_all();
  if (formats)
    command
        .add_option("--format", words.job.formats,
                    "Format to write (repeatable): png8, png16, exr, ply, vtp, vdb, cover_tif")
        ->type_name("FORMAT")
        ->expected(1)
        ->take_all();
}

void addImport(CLI::App& command, Words& words) {
  ImportOptions& o = words.import.options;
  command.add_option("FILE", words.import.file, "Terrain or model file")->required();
  command.add_option("--into", words.import.into, "Scene to add it to; made if it does not exist");
  command.add_option("--name", words.import.name, "Name of the new node");
  command.add_flag("--copy", words.import.copy,
                   "Copy the file and what it refers to into NAME.assets/ beside the scene");
  addAllow(command, words.import.allowedFolders);
  command
      .add_option("--position", words.import.position,
                  "Where the model stands, in m from the terrain's south-west corner, Z above the ground "
                  "(default: where the camera looks)")
      ->type_name("'X Y Z'");
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
  std::fflush(stdout);
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
  const ProgressStyle readable = ::isatty(STDOUT_FILENO) ? ProgressStyle::Terminal : ProgressStyle::Lines;
  ProgressPrinter printer(words.progress == "json" ? ProgressStyle::Json : readable, stdout);
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
  if (printer.style() != ProgressStyle::Json) printReport(*report, words.job.output, words.timings);
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
  store.setKeys(validKeys(*opened->snapshot, runOptionsFor(words.job, range.last), store));
  const JsonValue info = sceneInfo(*opened, store, range);
  std::fputs((words.json ? writeJson(info) : infoText(info)).c_str(), stdout);
  return 0;
}

int validateCommand(Words& words, const CancelToken& cancel) {
  const Result<OpenedScene> opened = openScene(words.job.scene, makeHelperAssetReader(), cancel);
  if (!opened) return fail(opened.error());
  int errors = 0, warnings = 0;
  for (const SceneProblem& problem : findProblems(*opened)) {
    ++(problem.error ? errors : warnings);
    std::printf("%s: %s: %s\n", problem.error ? "error" : "warning",
                problem.node.empty() ? "scene" : problem.node.c_str(), problem.text.c_str());
  }
  const std::string count =
      errors + warnings == 0 ? "is fine" : fmt::format("has {} errors and {} warnings", errors, warnings);
  std::printf("%s %s\n", words.job.scene.file.c_str(), count.c_str());
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
  app.footer(kFooter);
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
  app.add_subcommand("bench",
                     "Measure speed and errors: bench --list, bench [CASE...] --json FILE; see bench --help");
}

}  // namespace

int cliMain(const std::vector<std::string>& arguments, const CancelToken& cancel) {
  if (!arguments.empty() && arguments[0] == "bench")
    return benchMain({arguments.begin() + 1, arguments.end()}, commandLineBenchCases(), programRayCaster());
  CLI::App app("Spindrift: snow scenes without a window", "spindrift-cli");
  Words words;
  describe(app, words);
  if (arguments.empty()) {
    std::fputs(app.help().c_str(), stderr);
    return exitCode(ErrorKind::Usage);
  }
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (!arguments[0].starts_with('-') && std::find(names.begin(), names.end(), arguments[0]) == names.end()) {
    return fail({ErrorKind::Usage, "There is no such command", arguments[0], "the name is unknown",
                 fmt::format("The commands are {}", fmt::join(names, ", "))});
  }
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ParseError& error) {
    return app.exit(error, std::cout, std::cerr) == 0 ? 0 : exitCode(ErrorKind::Usage);
  }
  return dispatch(app, words, cancel);
}

}  // namespace spin
