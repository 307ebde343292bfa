// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/cli/progress.h"

#include <gtest/gtest.h>

#include "core/scene/json.h"
#include "editor/cli/job.h"

namespace spin {
namespace {

TEST(Progress, LinesHaveTheirDocumentedForm) {
  EXPECT_EQ(progressLine({"load", -1, 0, 0, 0.0, -1.0}), R"({"stage":"load","fraction":0})");
  EXPECT_EQ(progressLine({"simulate", 12, 0, 119, 0.0504, -1.0, 33.21}),
            R"({"stage":"simulate","frame":12,"first":0,"last":119,"fraction":0.0504,)"
            R"("seconds_left":null,"stage_seconds_left":33.2})");
  EXPECT_EQ(progressLine({"export", 3, 0, 9, 0.5, 7.0, 7.0}),
            R"({"stage":"export","frame":3,"first":0,"last":9,"fraction":0.5,)"
            R"("seconds_left":7.0,"stage_seconds_left":7.0})");
  EXPECT_EQ(doneLine("out", 361, 5),
            R"({"stage":"done","fraction":1,"exit_code":0,"output":"out","files":361,"bytes":5})");
}

TEST(Progress, MessagesOfAnyContentStayOneJsonLine) {
  const Error error{ErrorKind::BadInput, "Bad \"file\"", "C:\\x\n", "tab\there, \u00e9", ""};
  const std::string line = failedLine(error);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const Result<JsonValue> parsed = parseJson(line, "line");
  ASSERT_TRUE(parsed.ok()) << parsed.error().text();
  EXPECT_EQ(parsed->find("error")->text, error.text());
  EXPECT_EQ(parsed->find("exit_code")->number, 3);
}

std::string printed(ProgressStyle style, int reports) {
  std::FILE* file = std::tmpfile();
  ProgressPrinter printer(style, file);
  printer.print({"load", -1, 0, 0, 0.0, -1.0});
  for (int i = 0; i < reports; ++i) printer.print({"simulate", i, 0, reports, i * 1.0 / reports, -1.0});
  printer.done("out", 1, 2);
  std::string text(static_cast<std::size_t>(std::ftell(file)), '\0');
  std::rewind(file);
  const std::size_t read = std::fread(text.data(), 1, text.size(), file);
  std::fclose(file);
  text.resize(read);
  return text;
}

TEST(Progress, ReadableLinesDoNotFloodLogs) {
  const std::string text = printed(ProgressStyle::Lines, 1000);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
}

TEST(Progress, ATerminalShowsOneLineThatGoes) {
  const std::string text = printed(ProgressStyle::Terminal, 1000);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 0) << text;
  EXPECT_TRUE(text.ends_with("\r\033[K"));
}

TEST(Progress, JsonNamesEveryFrameAndEndsWithDone) {
  const std::string text = printed(ProgressStyle::Json, 10);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 10 + 1);
  EXPECT_NE(text.find("\"stage\":\"done\""), std::string::npos);
}

TEST(FrameRange, ReadsRangesAndRefusesNonsense) {
  EXPECT_EQ(parseFrameRange("3:7")->count(), 5);
  EXPECT_EQ(parseFrameRange("4")->last, 4);
  for (const char* wrong :
       {"", ":", "3:", ":3", "7:3", "-1:3", "a:b", "1:2:3", "1.5", "0:99999999999", " 1"}) {
    const Result<FrameRange> range = parseFrameRange(wrong);
    ASSERT_FALSE(range.ok()) << wrong;
    EXPECT_EQ(range.error().kind, ErrorKind::Usage);
  }
}

}  // namespace
}  // namespace spin
