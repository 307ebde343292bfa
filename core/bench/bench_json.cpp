// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <limits>

#include "core/bench/bench_case.h"
#include "core/bench/json_value.h"

namespace spin {
namespace {

using Kind = BenchJson::Kind;

std::string metricJson(const BenchMetric& m) {
  const std::string bar = m.hasBar ? jsonNumber(m.bar) : "null";
  const char* pass = !m.hasBar ? "null" : m.pass ? "true" : "false";
  return fmt::format("{{\"value\":{},\"unit\":{},\"bar\":{},\"pass\":{},\"time\":{}}}", jsonNumber(m.value),
                     jsonQuote(m.unit), bar, pass, m.isTime);
}

std::string rowJson(const BenchRow& row) {
  std::string settings, metrics;
  for (const auto& [name, value] : row.settings)
    settings += fmt::format("{}{}:{}", settings.empty() ? "" : ",", jsonQuote(name), jsonQuote(value));
  for (const auto& [name, metric] : row.metrics)
    metrics += fmt::format("{}{}:{}", metrics.empty() ? "" : ",", jsonQuote(name), metricJson(metric));
  const std::string skipped =
      row.skipped.empty() ? "" : fmt::format(",\"skipped\":{}", jsonQuote(row.skipped));
  return fmt::format(
      "{{\"case\":{},\"settings\":{{{}}},\"metrics\":{{{}}},\"seconds\":{},\"peak_bytes\":{},\"device\":{},"
      "\"isa\":{},\"threads\":{},\"version\":{}{}}}",
      jsonQuote(row.caseId), settings, metrics, jsonNumber(row.seconds), jsonNumber(row.peakBytes),
      jsonQuote(row.device), jsonQuote(row.isa), row.threads, jsonQuote(SPIN_VERSION), skipped);
}

/// Reads members of a row and remembers the first that is missing or of the wrong kind.
class Reader {
 public:
  const BenchJson* member(const BenchJson& object, const char* name, Kind kind, bool nullable = false) {
    const BenchJson* value = object.find(name);
    if (value && (value->kind == kind || (nullable && value->isNull()))) return value;
    if (m_problem.empty()) m_problem = fmt::format("member '{}' is missing or of the wrong kind", name);
    return nullptr;
  }
  std::string text(const BenchJson& object, const char* name) {
    const BenchJson* value = member(object, name, Kind::String);
    return value ? value->text : std::string();
  }
  /// null reads as NaN.
  double number(const BenchJson& object, const char* name) {
    const BenchJson* value = member(object, name, Kind::Number, true);
    return value && !value->isNull() ? value->number : std::numeric_limits<double>::quiet_NaN();
  }
  void note(std::string problem) {
    if (m_problem.empty()) m_problem = std::move(problem);
  }
  const std::string& problem() const { return m_problem; }

 private:
  std::string m_problem;
};

BenchMetric readMetric(Reader& reader, const BenchJson& value) {
  BenchMetric metric;
  metric.value = reader.number(value, "value");
  metric.unit = reader.text(value, "unit");
  const BenchJson* pass = reader.member(value, "pass", Kind::Bool, true);
  metric.hasBar = pass && !pass->isNull();
  if (metric.hasBar) {
    metric.bar = reader.number(value, "bar");
    metric.pass = pass->boolean;
  }
  if (const BenchJson* time = value.find("time")) metric.isTime = time->boolean;
  return metric;
}

BenchRow readRow(Reader& reader, const BenchJson& value) {
  BenchRow row;
  row.caseId = reader.text(value, "case");
  if (const BenchJson* settings = reader.member(value, "settings", Kind::Object))
    for (const auto& [name, setting] : settings->members) {
      if (setting.kind != Kind::String) reader.note(fmt::format("setting '{}' is no text", name));
      row.settings[name] = setting.text;
    }
  if (const BenchJson* metrics = reader.member(value, "metrics", Kind::Object))
    for (const auto& [name, metric] : metrics->members)
      row.metrics.emplace_back(name, readMetric(reader, metric));
  row.seconds = reader.number(value, "seconds");
  row.peakBytes = reader.number(value, "peak_bytes");
  row.device = reader.text(value, "device");
  row.isa = reader.text(value, "isa");
  const double threads = reader.number(value, "threads");
  if (!(threads >= 0.0 && threads <= 1e6)) reader.note("member 'threads' is out of range");
  row.threads = threads >= 0.0 && threads <= 1e6 ? static_cast<int>(threads) : 0;
  if (value.find("skipped")) row.skipped = reader.text(value, "skipped");
  return row;
}

}  // namespace

std::string benchJson(const std::vector<BenchRow>& rows) {
  std::string out = "[";
  for (std::size_t i = 0; i < rows.size(); ++i) out += (i ? ",\n " : "\n ") + rowJson(rows[i]);
  return out + "\n]\n";
}

Result<std::vector<BenchRow>> readBenchJson(const std::string& text) {
  Result<BenchJson> json = parseBenchJson(text);
  if (!json) return json.error();
  constexpr const char* kWhat = "The benchmark results could not be read";
  if (json->kind != Kind::List) return badInput(kWhat, {}, "the file is no list of rows");
  std::vector<BenchRow> rows;
  for (const BenchJson& item : json->items) {
    Reader reader;
    rows.push_back(readRow(reader, item));
    if (!reader.problem().empty())
      return badInput(kWhat, fmt::format("row {}", rows.size()), reader.problem());
  }
  return rows;
}

}  // namespace spin
