// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/fields/ray_scene.h"

namespace spin {

struct BenchOptions {
  bool quick = false;
  std::string device = "auto";               ///< auto | cpu | cuda
  std::string isa = "auto";                  ///< auto | avx512 | avx2 | baseline
  int threads = 0;                           ///< 0 = all
  std::string dataDirectory;                 ///< reference data; cases whose data is absent are skipped
  std::map<std::string, std::string> files;  ///< further files by option name, such as met
  RaySceneFactory makeRayScene = makeBvhRayScene;
};

/// A measured value. bar and pass are absent where there is none; a time's bar never fails a run.
struct BenchMetric {
  double value = 0.0;
  std::string unit;
  bool hasBar = false;
  double bar = 0.0;
  bool pass = true;
  bool isTime = false;
};

/// One row: a case at one setting.
struct BenchRow {
  std::string caseId;
  std::map<std::string, std::string> settings;
  std::vector<std::pair<std::string, BenchMetric>> metrics;  ///< in the order of the report
  double seconds = 0.0;
  double peakBytes = 0.0;
  std::string device, isa;
  int threads = 0;
  std::string skipped;  ///< why, if the case did not run

  /// error <= bar
  void addError(const std::string& name, double value, const std::string& unit, double bar);
  void addFigure(const std::string& name, double value, const std::string& unit);
  /// A time or rate without a bar.
  void addTime(const std::string& name, double value, const std::string& unit);
  /// A rate with its bar, value >= bar; reported, never failing.
  void addRate(const std::string& name, double value, const std::string& unit, double bar);
  /// No error bar was missed. A NaN misses every bar.
  bool pass() const;
};

/// A measured case. Cases live in core/bench; those that need a scene register from the command line.
struct BenchCase {
  std::string id;
  std::string measures;
  std::string reference;
  Result<std::vector<BenchRow>> (*run)(const BenchOptions& options) = nullptr;
  std::vector<std::string> fileOptions =
      {};  ///< "scene": it reads BenchOptions::files["scene"], --scene FILE
};

/// Built-in cases, in the order of the report. A new case adds its file and one line in bench_registry.cpp.
const std::vector<BenchCase>& builtInBenchCases();

/// The contract's JSON: a list of rows.
std::string benchJson(const std::vector<BenchRow>& rows);
/// Parses benchJson's output back (for --report).
Result<std::vector<BenchRow>> readBenchJson(const std::string& text);
/// Writes DIR/index.html with tables and speed-error plots (SVG) from rows. Creates the folder.
Status writeBenchReport(const std::vector<BenchRow>& rows, const std::string& directory);

/// `bench` of both programs: parses --list, --quick, --json FILE, --report DIR, --device, --isa, --threads,
/// --data, --met, --obs, --site, the cases' own file options, --help and case names; prints a table; returns
/// the exit code: 0, 1 (an error bar was missed or a case could not finish), 2 (usage). A row that leaves
/// seconds, peakBytes, device, isa or threads empty gets those of its whole case.
int benchMain(const std::vector<std::string>& arguments, const std::vector<BenchCase>& cases,
              const RaySceneFactory& makeRayScene);

}  // namespace spin
