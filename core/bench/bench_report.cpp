// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/bench/bench_case.h"
#include "core/bench/svg_plot.h"

namespace spin {
namespace {

using Rows = std::vector<const BenchRow*>;

template <class Value>
void addUnique(std::vector<Value>& list, const Value& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

const BenchMetric* findMetric(const BenchRow& row, const std::string& name) {
  for (const auto& [key, metric] : row.metrics)
    if (key == name) return &metric;
  return nullptr;
}

std::vector<std::string> metricNames(const Rows& rows) {
  std::vector<std::string> names;
  for (const BenchRow* row : rows)
    for (const auto& [name, metric] : row->metrics) addUnique(names, name);
  return names;
}

std::string metricCell(const BenchMetric* m) {
  if (!m) return "<td></td>";
  const char* style = !m->hasBar ? "" : m->pass ? " class='met'" : " class='missed'";
  const std::string bar = m->hasBar ? fmt::format("<br><small>bar {:.4g}</small>", m->bar) : "";
  return fmt::format("<td{}>{:.5g} {}{}</td>", style, m->value, htmlEscape(m->unit), bar);
}

std::string rowHtml(const BenchRow& row, const std::vector<std::string>& settings,
                    const std::vector<std::string>& metrics) {
  std::string out = "<tr>";
  for (const std::string& name : settings) {
    const auto found = row.settings.find(name);
    out += fmt::format("<td>{}</td>", found == row.settings.end() ? "" : htmlEscape(found->second));
  }
  if (!row.skipped.empty())
    return out + fmt::format("<td colspan='{}'>skipped: {}</td></tr>\n", metrics.size() + 5,
                             htmlEscape(row.skipped));
  for (const std::string& name : metrics) out += metricCell(findMetric(row, name));
  return out + fmt::format("<td>{:.4g}</td><td>{:.1f}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                           row.seconds, row.peakBytes / 1e6, htmlEscape(row.device), htmlEscape(row.isa),
                           row.threads);
}

std::string tableHtml(const Rows& rows) {
  std::vector<std::string> settings;
  for (const BenchRow* row : rows)
    for (const auto& [name, value] : row->settings) addUnique(settings, name);
  const std::vector<std::string> metrics = metricNames(rows);
  std::string out = "<table><tr>";
  for (const std::string& name : settings) out += fmt::format("<th>{}</th>", htmlEscape(name));
  for (const std::string& name : metrics) out += fmt::format("<th>{}</th>", htmlEscape(name));
  out += "<th>seconds</th><th>peak MB</th><th>device</th><th>instructions</th><th>threads</th></tr>\n";
  for (const BenchRow* row : rows) out += rowHtml(*row, settings, metrics);
  return out + "</table>\n";
}

constexpr const char* kPace = "seconds_per_simulated_second";

/// Error against seconds (for a simulated second where all rows say so), one curve for each metric with an
/// error bar.
std::string speedErrorPlot(const Rows& rows) {
  std::vector<PlotSeries> series;
  const bool paced =
      std::all_of(rows.begin(), rows.end(), [](const BenchRow* row) { return findMetric(*row, kPace); });
  for (const std::string& name : metricNames(rows)) {
    PlotSeries s{name, {}, false, 0.0};
    for (const BenchRow* row : rows) {
      const BenchMetric* m = findMetric(*row, name);
      if (!m || !m->hasBar || m->isTime) continue;
      if (s.points.empty()) s.name += m->unit.empty() ? "" : " [" + m->unit + "]";
      s.points.emplace_back(paced ? findMetric(*row, kPace)->value : row->seconds, m->value);
      s.hasBar = true;
      s.bar = m->bar;
    }
    std::sort(s.points.begin(), s.points.end());
    if (!s.points.empty()) series.push_back(std::move(s));
  }
  return series.empty()
             ? std::string()
             : logPlotSvg(series, paced ? "seconds per simulated second" : "seconds", "error (dashed: bar)");
}

constexpr const char* kHead =
    "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><title>Spindrift benchmarks</title>\n"
    "<style>body{font-family:sans-serif;margin:2em}table{border-collapse:collapse;margin:1em 0}"
    "td,th{border:1px solid #bbb;padding:.3em .6em;text-align:right}th{background:#eee}"
    ".met{background:#e3f4e3}.missed{background:#f8d7d7}</style></head><body>\n";

}  // namespace

Status writeBenchReport(const std::vector<BenchRow>& rows, const std::string& directory) {
  std::vector<std::string> cases;
  for (const BenchRow& row : rows) addUnique(cases, row.caseId);
  std::string page = kHead;
  page += fmt::format("<h1>Spindrift {} benchmarks</h1>\n", SPIN_VERSION);
  for (const std::string& id : cases) {
    Rows own;
    for (const BenchRow& row : rows)
      if (row.caseId == id) own.push_back(&row);
    page += fmt::format("<h2>{}</h2>\n", htmlEscape(id)) + tableHtml(own) + speedErrorPlot(own);
  }
  page += "</body></html>\n";

  std::error_code error;
  std::filesystem::create_directories(directory, error);
  const std::filesystem::path file = std::filesystem::path(directory) / "index.html";
  std::ofstream out(file, std::ios::binary);
  out << page;
  out.close();
  if (!out)
    return Error{ErrorKind::OutOfResources,
                 "The report could not be written",
                 file.string(),
                 error ? error.message() : "the file cannot be created or the disk is full",
                 {}};
  return {};
}

}  // namespace spin
