// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/property/property_table.h"

#include <gtest/gtest.h>

#include <locale>
#include <sstream>

#include "core/nodes/ground_nodes.h"
#include "core/nodes/weather_nodes.h"
#include "core/property/text_check.h"

namespace spin {
namespace {

TEST(ToText, RealsAreShortestAndReadBack) {
  EXPECT_EQ(toText(Value(0.1)), "0.1");
  EXPECT_EQ(toText(Value(Vec3d{1, -2.5, 1e-9})), "1 -2.5 1e-09");
  EXPECT_EQ(toText(Value(true)), "true");
  EXPECT_EQ(toText(Value(std::int64_t{-7})), "-7");
}

TEST(Units, KelvinShowsAsCelsiusAndRateAsMillimetresPerHour) {
  EXPECT_NEAR(toDisplay(Unit::Kelvin, 268.15), -5.0, 1e-12);
  EXPECT_NEAR(toDisplay(Unit::PrecipitationRate, 5.0 / 3600.0), 5.0, 1e-12);
  EXPECT_STREQ(unitInfo(Unit::PrecipitationRate).suffix, "mm/h");
  EXPECT_NEAR(fromDisplay(Unit::Byte, 2.0), 2.0 * 1048576.0, 0.0);
}

TEST(ParseValue, ReadsWhatPeopleType) {
  const PropertyInfo& wind = *kWeatherType.find("wind_speed_m_s");
  EXPECT_EQ(*parseValue(wind, " +2.5 "), Value(2.5));
  EXPECT_EQ(*parseValue(wind, "1e1"), Value(10.0));
  const PropertyInfo& base = *kGroundTypeLayerType.find("base");
  EXPECT_EQ(*parseValue(base, "rock"), Value(static_cast<std::int64_t>(GroundType::Rock)));
}

TEST(ParseValue, VectorsTakeBlanksOrCommas) {
  PropertyRow row;
  row.id = "v";
  row.kind = PropertyKind::Vector;
  for (const char* text : {"1 2.5 -3", "1, 2.5, -3", "1,2.5,-3", " 1\t2.5  -3 "}) {
    const Result<Value> value = parseValue(row, text);
    ASSERT_TRUE(value.ok()) << text;
    EXPECT_EQ(*value, Value(Vec3d{1, 2.5, -3}));
  }
  for (const char* text : {"1 2", "1 2 3 4", "1,,2 3", "", "1 2 x"})
    EXPECT_FALSE(parseValue(row, text).ok()) << text;
}

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(ParseValue, DoesNotDependOnTheLocale) {
  const std::locale old = std::locale::global(std::locale(std::locale(), new DecimalComma));
  std::ostringstream shown;
  shown << 2.5;
  EXPECT_EQ(shown.str(), "2,5") << "the locale is not in force, the test proves nothing";
  EXPECT_EQ(*parseValue(*kWeatherType.find("wind_speed_m_s"), "2.5"), Value(2.5));
  EXPECT_EQ(toText(Value(2.5)), "2.5");
  std::locale::global(old);
}

TEST(ParseValue, WrongChoiceNamesTheNearestOne) {
  const Result<Value> value = parseValue(*kGroundTypeLayerType.find("base"), "rok");
  ASSERT_FALSE(value.ok());
  EXPECT_NE(value.error().advice.find("\"rock\""), std::string::npos) << value.error().text();
  EXPECT_NE(value.error().why.find("vegetation"), std::string::npos) << value.error().text();
}

TEST(Validate, LongOrBrokenTextIsRefused) {
  const PropertyInfo& source = *kGroundTypeLayerType.find("source");
  EXPECT_TRUE(validate(source, Value(std::string(4096, 'a'))).ok());
  EXPECT_FALSE(validate(source, Value(std::string(4097, 'a'))).ok());
  EXPECT_FALSE(validate(source, Value(std::string("a\nb"))).ok());
  EXPECT_FALSE(validate(source, Value(std::string("a\0b", 3))).ok());
  EXPECT_FALSE(validate(source, Value(std::string("\xC3("))).ok());
}

TEST(CleanText, FollowsRfc3629) {
  EXPECT_TRUE(isCleanText(""));
  EXPECT_TRUE(isCleanText("plain \u00e9 \u96ea \U0001F328"));
  EXPECT_FALSE(isCleanText("\xC0\x80")) << "overlong NUL";
  EXPECT_FALSE(isCleanText("\xED\xA0\x80")) << "surrogate";
  EXPECT_FALSE(isCleanText("\xF4\x90\x80\x80")) << "above U+10FFFF";
  EXPECT_FALSE(isCleanText("\xE2\x82")) << "cut short";
  EXPECT_FALSE(isCleanText("\x1b[31m")) << "terminal command";
  EXPECT_FALSE(isCleanText("\xC2\x9B")) << "one-byte terminal command";
  EXPECT_EQ(printable("a\x1b[\xFFz"), "a?[?z");
}

TEST(NearestName, FindsTyposAndMissingUnits) {
  const std::string_view names[] = {"wind_speed_m_s", "wind_from_deg", "cloud_cover"};
  EXPECT_EQ(nearestName("wind_sped_m_s", names), "wind_speed_m_s");
  EXPECT_EQ(nearestName("wind_speed", names), "wind_speed_m_s");
  EXPECT_EQ(nearestName("cloudcover", names), "cloud_cover");
  EXPECT_EQ(nearestName("banana", names), "");
  EXPECT_EQ(nearestName("", names), "");
  EXPECT_EQ(nearestName(std::string(100000, 'w'), names), "");
  const std::string_view shortNames[] = {"ab"};
  EXPECT_EQ(nearestName("xy", shortNames), "") << "two letters have nothing in common";
}

}  // namespace
}  // namespace spin
