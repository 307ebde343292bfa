// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <QCoreApplication>
#include <algorithm>
#include <filesystem>

#include "core/bench/exposure_trial.h"
#include "core/nodes/weather_nodes.h"
#include "editor/cli/commands.h"
#include "plugins/host/plugin_host.h"

namespace spin {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExposureCase = "exposure-raytraced";
constexpr const char* kExample = "resources/scenes/kontertal.spindrift";
/// The program lies in build/PRESET/bin of a checkout.
constexpr int kMostParents = 4;

const BenchCase& builtInExposureCase() {
  const std::vector<BenchCase>& cases = builtInBenchCases();
  return *std::find_if(cases.begin(), cases.end(),
                       [](const BenchCase& bench) { return bench.id == kExposureCase; });
}

BenchRow skippedRow(const std::string& scene, const std::string& why) {
  BenchRow row;
  row.caseId = kExposureCase;
  row.settings["scene"] = scene;
  row.skipped = why;
  return row;
}

Result<std::vector<BenchRow>> exposureOfScene(const std::string& file, const BenchOptions& options) {
  const Result<OpenedScene> opened = openScene({file, {}, {}}, makeHelperAssetReader(), {});
  if (!opened) return opened.error();
  if (Status whole = requireFiles(*opened); !whole) return whole.error();
  ExposureTrial trial = exposureTrial(opened->snapshot, options);
  trial.byKind = true;
  trial.settings["scene"] = fs::path(file).filename().string();
  trial.settings["wind_m_s"] = fmt::format("{:g}", opened->snapshot->settings<WeatherNode>(0.0).windSpeed);
  return compareExposure(trial, options);
}

Result<std::vector<BenchRow>> runExposure(const BenchOptions& options) {
  Result<std::vector<BenchRow>> rows = builtInExposureCase().run(options);
  if (!rows) return rows;
  const auto named = options.files.find("scene");
  const std::string scene = named != options.files.end() ? named->second : exampleScene();
  if (scene.empty()) {
    rows->push_back(skippedRow(fs::path(kExample).filename().string(),
                               fmt::format("{} lies neither here nor above the program; name a scene with "
                                           "--scene FILE",
                                           kExample)));
    return rows;
  }
  Result<std::vector<BenchRow>> more = exposureOfScene(scene, options);
  if (!more) return more;
  rows->insert(rows->end(), std::make_move_iterator(more->begin()), std::make_move_iterator(more->end()));
  return rows;
}

}  // namespace

std::string exampleScene() {
  std::error_code error;
  if (fs::exists(kExample, error)) return kExample;
  if (!QCoreApplication::instance()) return {};
  fs::path folder(QCoreApplication::applicationDirPath().toStdString());
  for (int i = 0; i < kMostParents; ++i, folder = folder.parent_path())
    if (fs::exists(folder / kExample, error)) return (folder / kExample).string();
  return {};
}

std::vector<BenchCase> commandLineBenchCases() {
  std::vector<BenchCase> cases = builtInBenchCases();
  for (BenchCase& bench : cases) {
    if (bench.id != kExposureCase) continue;
    bench.measures = "exposure of the cover's cells in a valley with houses and in a scene (--scene FILE)";
    bench.run = runExposure;
    bench.fileOptions = {"scene"};
  }
  return cases;
}

}  // namespace spin
