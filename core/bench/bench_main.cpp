// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/base/cpu_features.h"
#include "core/base/log.h"
#include "core/base/parallel.h"
#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"

namespace spin {
namespace {

struct Command {
  BenchOptions options;
  bool list = false;
  bool help = false;
  std::string jsonFile;
  std::string reportDirectory;
  std::vector<const BenchCase*> chosen;
};

constexpr const char* kUsage =
    "bench [CASE...] [OPTIONS] [--json FILE]   run cases (none named: all) and print their rows\n"
    "bench --list                              name the cases: id, what it measures, reference\n"
    "bench --report DIR --json FILE            write DIR/index.html from the rows of an earlier run\n"
    "\n"
    "  --quick                 seconds per case instead of minutes\n"
    "  --json FILE             write the rows as JSON\n"
    "  --threads N             threads; 0 takes all\n"
    "  --device auto|cpu|cuda  where to compute\n"
    "  --isa auto|avx512|avx2|baseline\n"
    "  --data DIR              folder of reference data; cases without theirs are skipped\n"
    "  --met, --obs, --site FILE   weather, observations and site of a season\n";

Error usage(std::string what, std::string where, std::string why) {
  return {ErrorKind::Usage, std::move(what), std::move(where), std::move(why),
          "bench --help names the options, bench --list the cases"};
}

bool isFileOption(const std::string& option, const std::vector<BenchCase>& cases) {
  if (option == "--met" || option == "--obs" || option == "--site") return true;
  return std::any_of(cases.begin(), cases.end(), [&](const BenchCase& c) {
    return std::any_of(c.fileOptions.begin(), c.fileOptions.end(),
                       [&](const std::string& name) { return option == "--" + name; });
  });
}

void printHelp(const std::vector<BenchCase>& cases) {
  fmt::print("{}", kUsage);
  for (const BenchCase& c : cases)
    for (const std::string& name : c.fileOptions)
      fmt::print("  {:<24}of the case {}\n", fmt::format("--{} FILE", name), c.id);
  fmt::print("\nExit codes: 0 ok, 1 an error bar was missed or a case could not finish, 2 usage\n");
}

Status setThreads(Command& command, const std::string& text) {
  int threads = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), threads);
  if (error != std::errc{} || end != text.data() + text.size() || threads < 0 || threads > 1024)
    return usage("Wrong value", "--threads", fmt::format("'{}' is no number from 0 to 1024", text));
  command.options.threads = threads;
  return {};
}

Status setOption(Command& command, const std::string& option, const std::string& value,
                 const std::vector<BenchCase>& cases) {
  BenchOptions& o = command.options;
  if (option == "--json") return command.jsonFile = value, Status{};
  if (option == "--report") return command.reportDirectory = value, Status{};
  if (option == "--data") return o.dataDirectory = value, Status{};
  if (option == "--threads") return setThreads(command, value);
  if (isFileOption(option, cases)) return o.files[option.substr(2)] = value, Status{};
  if (option == "--device") {
    if (value != "auto" && value != "cpu" && value != "cuda")
      return usage("Wrong value", option, fmt::format("'{}' is none of auto, cpu and cuda", value));
    return o.device = value, Status{};
  }
  if (option == "--isa") {
    const Result<Isa> isa = chooseIsa(value);
    if (!isa && isa.error().kind == ErrorKind::Usage) return usage("Wrong value", option, isa.error().why);
    return o.isa = value, Status{};
  }
  return usage("Unknown option", option, "there is no such option");
}

Result<Command> parse(const std::vector<std::string>& arguments, const std::vector<BenchCase>& cases) {
  Command command;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    if (word == "--list") {
      command.list = true;
    } else if (word == "--quick") {
      command.options.quick = true;
    } else if (word == "--help" || word == "-h") {
      command.help = true;
    } else if (word.starts_with("--")) {
      const std::size_t equals = word.find('=');
      const bool joined = equals != std::string::npos;
      if (!joined && i + 1 == arguments.size())
        return usage("Incomplete option", word, "its value is missing");
      const Status set = setOption(command, word.substr(0, equals),
                                   joined ? word.substr(equals + 1) : arguments[++i], cases);
      if (!set) return set.error();
    } else {
      const auto found =
          std::find_if(cases.begin(), cases.end(), [&](const BenchCase& c) { return c.id == word; });
      if (found == cases.end()) return usage("Unknown case", word, "there is no such case");
      command.chosen.push_back(&*found);
    }
  }
  if (!command.reportDirectory.empty() && command.jsonFile.empty())
    return usage("Incomplete call", "--report", "it reads the rows from --json FILE");
  if (command.chosen.empty())
    for (const BenchCase& c : cases) command.chosen.push_back(&c);
  return command;
}

Status writeText(const std::string& file, const std::string& text) {
  // Written beside and renamed, so that a reader never sees half a file.
  const std::string part = file + ".part";
  std::ofstream out(part, std::ios::binary);
  out << text;
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(part, file, error);
  if (!out || error)
    return Error{ErrorKind::OutOfResources,
                 "The results could not be written",
                 file,
                 error ? error.message() : "the file cannot be created or the disk is full",
                 {}};
  return {};
}

Status report(const Command& command) {
  std::ifstream in(command.jsonFile, std::ios::binary);
  if (!in)
    return badInput("The benchmark results could not be read", command.jsonFile, "the file cannot be opened");
  std::ostringstream text;
  text << in.rdbuf();
  const auto rows = readBenchJson(text.str());
  if (!rows) return rows.error();
  return writeBenchReport(*rows, command.reportDirectory);
}

void print(const BenchRow& row) {
  std::string head = row.caseId;
  for (const auto& [name, value] : row.settings) head += fmt::format(" {}={}", name, value);
  if (!row.skipped.empty()) return fmt::print("{}\n  skipped: {}\n", head, row.skipped);
  fmt::print("{}\n  {:.3f} s, {:.1f} MB, {} {} {} threads\n", head, row.seconds, row.peakBytes / 1e6,
             row.device, row.isa, row.threads);
  for (const auto& [name, m] : row.metrics) {
    const std::string bar =
        m.hasBar ? fmt::format("  (bar {:.4g}: {})", m.bar, m.pass ? "met" : "MISSED") : "";
    fmt::print("  {:<28} {:>14.6g} {}{}\n", name, m.value, m.unit, bar);
  }
}

/// Fills what the case left empty with the figures of the whole case.
void complete(BenchRow& row, const BenchCase& bench, const BenchOptions& options, const BenchMeter& meter) {
  BenchRow whole;
  meter.finish(whole);
  if (row.caseId.empty()) row.caseId = bench.id;
  if (row.seconds == 0.0) row.seconds = whole.seconds;
  if (row.peakBytes == 0.0) row.peakBytes = whole.peakBytes;
  if (row.device.empty()) row.device = "cpu";
  const Result<Isa> isa = chooseIsa(options.isa);
  if (row.isa.empty()) row.isa = isa ? isaName(*isa) : options.isa;
  if (row.threads == 0) row.threads = CpuBackend(options.threads).threads();
}

int runCases(const Command& command) {
  std::vector<BenchRow> all;
  int exit = 0;
  for (const BenchCase* bench : command.chosen) {
    const BenchMeter meter;
    auto rows = bench->run(command.options);
    if (!rows) {
      logError(fmt::format("{}: {}", bench->id, rows.error().text()));
      exit = 1;
      continue;
    }
    for (BenchRow& row : *rows) {
      complete(row, *bench, command.options, meter);
      print(row);
      if (!row.pass()) exit = 1;
      all.push_back(std::move(row));
    }
  }
  if (command.jsonFile.empty()) return exit;
  const Status written = writeText(command.jsonFile, benchJson(all));
  if (written) return exit;
  logError(written.error().text());
  return exitCode(written.error().kind);
}

}  // namespace

int benchMain(const std::vector<std::string>& arguments, const std::vector<BenchCase>& cases,
              const RaySceneFactory& makeRayScene) {
  Result<Command> command = parse(arguments, cases);
  if (!command) {
    logError(command.error().text());
    return exitCode(command.error().kind);
  }
  command->options.makeRayScene = makeRayScene;
  if (command->help) {
    printHelp(cases);
    return 0;
  }
  if (command->list) {
    for (const BenchCase& c : cases) fmt::print("{}\t{}\t{}\n", c.id, c.measures, c.reference);
    return 0;
  }
  if (command->reportDirectory.empty()) return runCases(*command);
  const Status written = report(*command);
  if (written) return 0;
  logError(written.error().text());
  return exitCode(written.error().kind);
}

}  // namespace spin
