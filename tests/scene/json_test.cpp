// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/json.h"

#include <gtest/gtest.h>

#include <array>

namespace spin {
namespace {

TEST(Json, ReadsAllKindsWithLines) {
  const Result<JsonValue> json = parseJson(
      "{\n\"a\": [1, -2.5e3],\n\"b\": {\"c\": null, \"d\": true}, \"e\": \"x\\u00e9\\n\\ud83c\\udf28\"}",
      "f");
  ASSERT_TRUE(json.ok()) << json.error().text();
  EXPECT_EQ(json->find("a")->items[1].number, -2500.0);
  EXPECT_EQ(json->find("b")->line, 3);
  EXPECT_TRUE(json->find("b")->find("d")->boolean);
  EXPECT_EQ(json->find("e")->text, "x\u00e9\n\U0001F328");
}

TEST(Json, RefusesWhatIsNoJson) {
  for (const char* text : {"",
                           "{",
                           "[1,]",
                           "{\"a\":1,}",
                           "{a:1}",
                           "01",
                           "1.",
                           ".5",
                           "+1",
                           "0x1",
                           "1e999",
                           "-1e999",
                           "nan",
                           "NaN",
                           "Infinity",
                           "\"\\x\"",
                           "\"\\ud800\"",
                           "\"\\ud800\\u0041\"",
                           "\"\\u12\"",
                           "\"line\nbreak\"",
                           "\"open",
                           "tru",
                           "[1] 2",
                           "{\"a\":1,\"a\":2}",
                           "\"\xff\"",
                           "[1 2]",
                           "{\"a\" 1}",
                           "'a'",
                           "/* */1"}) {
    const Result<JsonValue> json = parseJson(text, "file.json");
    ASSERT_FALSE(json.ok()) << text;
    EXPECT_NE(json.error().where.find("file.json, line "), std::string::npos);
  }
}

TEST(Json, NamesTheLineAndTheDoubledKey) {
  const Result<JsonValue> json = parseJson("{\n\"wind\": 1,\n\"wind\": 2}", "f");
  ASSERT_FALSE(json.ok());
  EXPECT_NE(json.error().text().find("line 3"), std::string::npos) << json.error().text();
  EXPECT_NE(json.error().text().find("wind"), std::string::npos);
}

TEST(Json, BoundsDepthAndCount) {
  EXPECT_TRUE(parseJson(std::string(20, '[') + std::string(20, ']'), "f").ok());
  EXPECT_FALSE(parseJson(std::string(1'000'000, '['), "f").ok());
  EXPECT_TRUE(parseJson("[1,2,3]", "f", {8, 4}).ok());
  EXPECT_FALSE(parseJson("[1,2,3,4]", "f", {8, 4}).ok());
}

TEST(Json, WritesSortedWithHeadFirst) {
  JsonValue root = JsonValue::object();
  root.set("b", JsonValue::of(0.1));
  root.set("a", JsonValue::array({JsonValue::of(1.0), JsonValue::of(2.0)}));
  root.set("z", JsonValue::of("q\"\\\n"));
  root.set("n", JsonValue::object());
  root.set("t", JsonValue::array({JsonValue::of("x")}));
  const std::array<const char*, 1> head{"z"};
  EXPECT_EQ(writeJson(root, head),
            "{\n  \"z\": \"q\\\"\\\\\\u000a\",\n  \"a\": [1, 2],\n  \"b\": 0.1,\n  \"n\": {},\n  \"t\": [\n  "
            "  \"x\"\n  ]\n}\n");
}

TEST(Json, WhatIsWrittenReadsBack) {
  for (double number : {0.0, -0.0, 0.1, 1.0 / 3.0, 1e300, -5e-324, 123456789012345678.0}) {
    const Result<JsonValue> back = parseJson(writeJson(JsonValue::of(number)), "f");
    ASSERT_TRUE(back.ok()) << number << " " << writeJson(JsonValue::of(number));
    EXPECT_EQ(back->number, number);
  }
}

}  // namespace
}  // namespace spin
