// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "core/base/log.h"
#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/bench/json_value.h"
#include "core/bench/svg_plot.h"

namespace spin {
namespace {

namespace fs = std::filesystem;

BenchRow sampleRow() {
  BenchRow row;
  row.caseId = "demo";
  row.settings = {{"n", "10"}, {"mode", "fast \"a\"\n"}};
  row.addError("error", 0.5, "m", 1.0);
  row.addFigure("count", 3, "");
  row.addTime("time", 0.25, "s");
  row.addRate("rate", 5, "1/s", 8);
  row.seconds = 0.125;
  row.peakBytes = 1e6;
  row.device = "cpu";
  row.isa = "avx2";
  row.threads = 2;
  return row;
}

std::string readFile(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// A folder of the test's own, removed at the end; messages of the code under test are kept from stderr.
class BenchRun : public ::testing::Test {
 protected:
  void SetUp() override {
    m_folder = fs::temp_directory_path() / (std::string("spindrift_bench_") +
                                            ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(m_folder);
    fs::create_directories(m_folder);
    setLogSink([this](LogLevel, std::string_view text) { m_messages += text; });
  }
  void TearDown() override {
    setLogSink({});
    fs::remove_all(m_folder);
  }
  int run(std::vector<std::string> arguments) {
    const std::vector<BenchCase> cases = {
        {"good", "what is good", "known", &BenchRun::good},
        {"bad", "what misses its bar", "known", &BenchRun::bad},
        {"slow", "a rate below its bar", "known", &BenchRun::slow},
        {"broken", "cannot finish", "known", &BenchRun::broken},
        {"absent", "has no data", "known", &BenchRun::absent, {"place"}},
    };
    return benchMain(arguments, cases, {});
  }
  static Result<std::vector<BenchRow>> rowWith(void (*fill)(BenchRow&)) {
    BenchRow row;
    fill(row);
    return std::vector<BenchRow>{row};
  }
  static Result<std::vector<BenchRow>> good(const BenchOptions& o) {
    BenchRow row;
    row.settings["quick"] = o.quick ? "yes" : "no";
    row.settings["met"] = o.files.count("met") ? o.files.at("met") : "";
    row.addError("error", 1, "m", 2);
    return std::vector<BenchRow>{row};
  }
  static Result<std::vector<BenchRow>> bad(const BenchOptions&) {
    return rowWith([](BenchRow& row) { row.addError("error", 3, "m", 2); });
  }
  static Result<std::vector<BenchRow>> slow(const BenchOptions&) {
    return rowWith([](BenchRow& row) { row.addRate("rate", 3, "1/s", 8); });
  }
  static Result<std::vector<BenchRow>> broken(const BenchOptions&) { return badInput("no", "where", "why"); }
  static Result<std::vector<BenchRow>> absent(const BenchOptions&) {
    return rowWith([](BenchRow& row) { row.skipped = "no data"; });
  }
  fs::path m_folder;
  std::string m_messages;
};

TEST(BenchRowTest, BarsOfErrorsCountAndBarsOfTimesDoNot) {
  BenchRow row;
  row.addRate("rate", 1, "1/s", 8);
  EXPECT_FALSE(row.metrics[0].second.pass);
  EXPECT_TRUE(row.pass());
  row.addError("error", 2, "", 2);
  EXPECT_TRUE(row.pass());
  row.addError("worse", 2.001, "", 2);
  EXPECT_FALSE(row.pass());
}

TEST(BenchRowTest, NotANumberMissesItsBar) {
  BenchRow row;
  row.addError("error", std::nan(""), "", 2);
  EXPECT_FALSE(row.pass());
}

TEST(BenchRowDeathTest, AMetricHasItsNameForItself) {
  BenchRow row;
  row.addFigure("mass", 1, "kg");
  EXPECT_DEATH(row.addError("mass", 1, "1", 2), "two metrics named mass");
}

TEST(BenchJsonTest, ReadsBackWhatItWrote) {
  BenchRow skipped;
  skipped.caseId = "absent";
  skipped.skipped = "no data";
  const auto rows = readBenchJson(benchJson({sampleRow(), skipped}));
  ASSERT_TRUE(rows.ok()) << rows.error().text();
  ASSERT_EQ(rows->size(), 2u);
  const BenchRow& row = (*rows)[0];
  EXPECT_EQ(row.settings, sampleRow().settings);
  ASSERT_EQ(row.metrics.size(), 4u);
  EXPECT_EQ(row.metrics[0].first, "error");
  EXPECT_EQ(row.metrics[0].second.bar, 1.0);
  EXPECT_TRUE(row.metrics[0].second.pass);
  EXPECT_FALSE(row.metrics[1].second.hasBar);
  EXPECT_TRUE(row.metrics[2].second.isTime);
  EXPECT_TRUE(row.metrics[3].second.isTime);
  EXPECT_FALSE(row.metrics[3].second.pass);
  EXPECT_EQ(row.seconds, 0.125);
  EXPECT_EQ(row.threads, 2);
  EXPECT_EQ((*rows)[1].skipped, "no data");
}

TEST(BenchJsonTest, BarAndPassAreNullWhereThereIsNone) {
  BenchRow row;
  row.addFigure("count", 3, "");
  const auto json = parseBenchJson(benchJson({row}));
  ASSERT_TRUE(json.ok());
  const BenchJson* count = json->items[0].find("metrics")->find("count");
  ASSERT_NE(count, nullptr);
  EXPECT_TRUE(count->find("bar")->isNull());
  EXPECT_TRUE(count->find("pass")->isNull());
  EXPECT_EQ(json->items[0].find("version")->text, SPIN_VERSION);
}

TEST(BenchJsonTest, InfinityIsWrittenAsNullAndReadAsNotANumber) {
  BenchRow row;
  row.addError("error", std::numeric_limits<double>::infinity(), "", 1);
  const auto rows = readBenchJson(benchJson({row}));
  ASSERT_TRUE(rows.ok());
  EXPECT_TRUE(std::isnan((*rows)[0].metrics[0].second.value));
  EXPECT_FALSE((*rows)[0].pass());
}

TEST(BenchJsonTest, RefusesBrokenText) {
  const char* broken[] = {"",     "[",        "[1,]",        "{\"a\":1,\"a\":2}", "[01]",
                          "[1.]", "[1e999]",  "\"\\u12g4\"", "\"\\ud800\"",       "[nul]",
                          "[] x", "\"a\nb\"", "{a:1}"};
  for (const char* text : broken) EXPECT_FALSE(parseBenchJson(text).ok()) << text;
  EXPECT_FALSE(parseBenchJson(std::string(100000, '[')).ok());
  EXPECT_FALSE(readBenchJson("{}").ok());
  EXPECT_FALSE(readBenchJson("[{\"case\":\"x\"}]").ok());
  EXPECT_FALSE(readBenchJson("[3]").ok());
}

TEST(BenchJsonTest, ReadsEscapes) {
  const auto json = parseBenchJson(R"("\u00e9\u4e2d\ud83d\ude00\n\"")");
  ASSERT_TRUE(json.ok());
  EXPECT_EQ(json->text, "\xC3\xA9\xE4\xB8\xAD\xF0\x9F\x98\x80\n\"");
}

TEST_F(BenchRun, ExitCodesFollowTheContract) {
  EXPECT_EQ(run({"good"}), 0);
  EXPECT_EQ(run({"slow"}), 0);
  EXPECT_EQ(run({"absent"}), 0);
  EXPECT_EQ(run({"bad"}), 1);
  EXPECT_EQ(run({"broken"}), 1);
  EXPECT_EQ(run({}), 1);
  EXPECT_EQ(run({"--list"}), 0);
  EXPECT_EQ(run({"--help"}), 0);
  EXPECT_EQ(run({"absent", "--place", "file"}), 0) << "an option of the case's own";
}

TEST_F(BenchRun, WrongCallsAreUsageErrors) {
  const std::vector<std::vector<std::string>> wrong = {
      {"unknown"},         {"--what"},       {"--json"},          {"--threads", "x"},
      {"--threads", "-1"}, {"--isa", "mmx"}, {"--device", "tpu"}, {"--report", "x"}};
  for (const auto& arguments : wrong) EXPECT_EQ(run(arguments), 2) << arguments[0];
}

TEST_F(BenchRun, ListIsTabSeparated) {
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(run({"--list"}), 0);
  const std::string text = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(text.substr(0, text.find('\n')), "good\twhat is good\tknown");
}

TEST_F(BenchRun, WritesAllRowsAlsoWhenABarIsMissed) {
  const std::string file = (m_folder / "rows.json").string();
  EXPECT_EQ(run({"good", "bad", "--quick", "--met", "m.csv", "--threads", "2", "--json", file}), 1);
  const auto rows = readBenchJson(readFile(file));
  ASSERT_TRUE(rows.ok()) << rows.error().text();
  ASSERT_EQ(rows->size(), 2u);
  EXPECT_EQ((*rows)[0].caseId, "good");
  EXPECT_EQ((*rows)[0].settings.at("quick"), "yes");
  EXPECT_EQ((*rows)[0].settings.at("met"), "m.csv");
  EXPECT_EQ((*rows)[0].threads, 2);
  EXPECT_EQ((*rows)[0].device, "cpu");
  EXPECT_GT((*rows)[0].seconds, 0.0);
  EXPECT_GT((*rows)[0].peakBytes, 0.0);
}

TEST_F(BenchRun, UnwritableResultFileIsAnError) {
  EXPECT_EQ(run({"good", "--json", (m_folder / "none" / "rows.json").string()}), 4);
  EXPECT_NE(m_messages.find("rows.json"), std::string::npos);
}

TEST_F(BenchRun, ReportHasATableAndAPlotPerCase) {
  const fs::path json = m_folder / "rows.json";
  std::ofstream(json) << benchJson({sampleRow()});
  EXPECT_EQ(run({"--report", (m_folder / "page").string(), "--json", json.string()}), 0);
  const std::string page = readFile(m_folder / "page" / "index.html");
  EXPECT_NE(page.find("<h2>demo</h2>"), std::string::npos);
  EXPECT_NE(page.find("fast &quot;a&quot;"), std::string::npos);
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_EQ(run({"--report", (m_folder / "page").string(), "--json", (m_folder / "no.json").string()}), 3);
}

TEST(SvgPlotTest, PlacesPointsOnLogarithmicAxes) {
  // One decade each: x from 0.1 to 1 on pixels 80 to 420, y from 1 to 10 on pixels 350 to 20.
  const std::string svg = logPlotSvg({{"e", {{0.1, 10.0}, {1.0, 1.0}}, true, 10.0}}, "x", "y");
  EXPECT_NE(svg.find("points='80.0,20.0 420.0,350.0 '"), std::string::npos) << svg;
  EXPECT_NE(svg.find("stroke-dasharray"), std::string::npos);
}

TEST(SvgPlotTest, LeavesOutWhatHasNoLogarithm) {
  EXPECT_EQ(logPlotSvg({{"e", {{0.0, 1.0}, {1.0, -1.0}, {std::nan(""), 1.0}}, true, 1.0}}, "x", "y"), "");
}

/// The peak of a row in which a block of this size was held.
double peakWithBlock(std::size_t bytes) {
  BenchRow row;
  const BenchMeter meter;
  // Written page by page: memory that is only reserved is not held.
  std::vector<char> block(bytes, 1);
  EXPECT_EQ(block[bytes / 2], 1);
  meter.finish(row);
  return row.peakBytes;
}

TEST(BenchMeterTest, SeesMemoryOfItsOwnRow) {
  constexpr std::size_t kBytes = 64u << 20;
  EXPECT_GE(peakWithBlock(kBytes), static_cast<double>(kBytes));
}

// Under the address sanitizer freed memory stays resident, and some systems let no process reset its peak:
// there the second row truly has the first one's.
#if !defined(__SANITIZE_ADDRESS__)
TEST(BenchMeterTest, ForgetsTheRowBefore) {
  constexpr std::size_t kBytes = 64u << 20;
  const double first = peakWithBlock(kBytes);
  const double second = peakWithBlock(1);
  if (resetPeakResidentBytes())
    EXPECT_LT(second, first - 0.5 * kBytes);
  else
    EXPECT_GE(second, first);
}
#endif

}  // namespace
}  // namespace spin
