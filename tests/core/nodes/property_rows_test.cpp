// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>
#include <set>
#include <vector>

#include "core/nodes/node_registry.h"
#include "core/property/scene_node.h"

namespace spin {
namespace {

struct Row {
  const NodeType* type;
  const PropertyRow* property;
};

std::vector<Row> allRows() {
  std::vector<Row> rows;
  for (const NodeType* type : nodeTypes())
    for (const PropertyRow& row : type->properties) rows.push_back({type, &row});
  return rows;
}

std::string rowName(const testing::TestParamInfo<Row>& info) {
  return std::string(info.param.type->id) + "_" + info.param.property->id;
}

/// A number as a value of the property's kind; vectors take it in the component named.
Value numberValue(const PropertyInfo& property, double number, int axis = 0) {
  if (property.kind == PropertyKind::Int) return static_cast<std::int64_t>(number);
  if (property.kind == PropertyKind::Real) return number;
  if (property.kind == PropertyKind::Points)
    return PlanPoints{{0.0, 0.0}, axis == 0 ? Vec2d{number, 0.0} : Vec2d{0.0, number}};
  const double mid = 0.5 * (property.min + property.max);
  return Vec3d{axis == 0 ? number : mid, axis == 1 ? number : mid, axis == 2 ? number : mid};
}

bool isNumeric(const PropertyInfo& property) {
  return property.kind == PropertyKind::Int || property.kind == PropertyKind::Real ||
         property.kind == PropertyKind::Vector || property.kind == PropertyKind::Colour ||
         property.kind == PropertyKind::Points;
}

std::vector<Row> numericRows() {
  std::vector<Row> rows = allRows();
  std::erase_if(rows, [](const Row& row) { return !isNumeric(*row.property); });
  return rows;
}

class PropertyRowTest : public testing::TestWithParam<Row> {
 protected:
  const NodeType& type() const { return *GetParam().type; }
  const PropertyInfo& property() const { return *GetParam().property; }
};

class NumericRowTest : public PropertyRowTest {};

TEST_P(PropertyRowTest, IsDescribed) {
  static const std::regex kSnake("[a-z][a-z0-9]*(_[a-z0-9]+)*");
  EXPECT_TRUE(std::regex_match(property().id, kSnake)) << property().id;
  EXPECT_NE(*property().label, '\0');
  EXPECT_NE(*property().doc, '\0');
  EXPECT_EQ(std::string(property().doc).back(), '.') << property().doc;
  EXPECT_EQ(type().find(property().id), &property());
}

TEST_P(NumericRowTest, NumbersHaveARangeAndAStepWithinIt) {
  EXPECT_LT(property().min, property().max);
  EXPECT_GT(property().step, 0.0);
  EXPECT_LE(property().step, property().max - property().min);
}

TEST_P(PropertyRowTest, DefaultIsValidAndRoundTripsAsText) {
  const Value value = defaultValue(type(), property());
  EXPECT_TRUE(validate(property(), value).ok()) << validate(property(), value).error().text();
  const Result<Value> read = parseValue(property(), toText(property(), value));
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(*read, value);
}

TEST_P(PropertyRowTest, AwkwardValuesRoundTripAsText) {
  std::vector<Value> values;
  if (isNumeric(property())) {
    const double third = property().min + (property().max - property().min) / 3.0;
    for (int axis = 0; axis < 3; ++axis)
      for (double number : {property().min, property().max, third})
        values.emplace_back(numberValue(property(), number, axis));
  } else if (property().kind == PropertyKind::Bool) {
    values = {true, false};
  } else if (property().kind == PropertyKind::Choice) {
    for (std::size_t i = 0; i < property().choices.size(); ++i)
      values.emplace_back(static_cast<std::int64_t>(i));
  } else {
    values = {std::string(), std::string("a b/\"c\".tif"), std::string("Schn\u00ee, \u96ea")};
  }
  SceneNode node = makeNode(type(), "node", "Node");
  for (const Value& value : values) {
    const Result<Value> read = parseValue(property(), toText(property(), value));
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(*read, value);
    setPlainValue(node, property(), value);
    EXPECT_EQ(plainValue(node, property()), value) << "the member holds less than the row promises";
  }
}

TEST_P(NumericRowTest, BeyondTheRangeIsRefusedByName) {
  const double beyond = property().kind == PropertyKind::Int ? 1.0 : 1e-6 * (property().max - property().min);
  const bool vector = property().kind == PropertyKind::Vector || property().kind == PropertyKind::Colour;
  const int axes = vector ? 3 : property().kind == PropertyKind::Points ? 2 : 1;
  for (int axis = 0; axis < axes; ++axis)
    for (double number : {property().min - beyond, property().max + beyond}) {
      const Status status = validate(property(), numberValue(property(), number, axis));
      ASSERT_FALSE(status.ok()) << number;
      EXPECT_NE(status.error().text().find(property().id), std::string::npos) << status.error().text();
      EXPECT_NE(status.error().why.find(toText(Value(property().max))), std::string::npos)
          << status.error().text();
    }
}

TEST_P(PropertyRowTest, NotANumberIsRefused) {
  if (isNumeric(property()) && property().kind != PropertyKind::Int) {
    EXPECT_FALSE(validate(property(), numberValue(property(), std::nan(""))).ok());
    EXPECT_FALSE(
        validate(property(), numberValue(property(), std::numeric_limits<double>::infinity(), 1)).ok());
  }
  if (property().kind >= PropertyKind::Text) return;
  if (property().kind == PropertyKind::Points) {
    for (const char* text : {"nan 1", "1", "1 2 3", "1 2;", ";", "1 2; 3", "1,,2", "1 1e999", "a b"})
      EXPECT_FALSE(parseValue(property(), text).ok()) << text;
    for (const char* text : {"", " ", "1 2", "1,2;3,4", " -1.5  2e3 ; 0,\t1 "})
      EXPECT_TRUE(parseValue(property(), text).ok()) << text;
    return;
  }
  for (const char* text :
       {"", "nan", "1e999", "inf", "0x10", "12 apples", "1,5", "99999999999999999999", "1 2"}) {
    EXPECT_FALSE(parseValue(property(), text).ok()) << text;
  }
}

TEST_P(PropertyRowTest, WrongKindIsRefused) {
  const std::vector<Value> samples{true, std::int64_t{0}, 0.5, Vec3d{}, std::string("x"), PlanPoints{{1, 2}}};
  const std::size_t right = defaultValue(type(), property()).index();
  for (const Value& value : samples)
    EXPECT_EQ(validate(property(), value).ok() && value.index() != right, false) << value.index();
}

TEST_P(NumericRowTest, UnitConvertsBothWays) {
  for (double si : {property().min, property().max, 0.25 * property().max})
    EXPECT_NEAR(fromDisplay(property().unit, toDisplay(property().unit, si)), si,
                1e-12 * std::max(1.0, std::abs(si)));
}

INSTANTIATE_TEST_SUITE_P(All, PropertyRowTest, testing::ValuesIn(allRows()), rowName);
INSTANTIATE_TEST_SUITE_P(All, NumericRowTest, testing::ValuesIn(numericRows()), rowName);

TEST(NodeTypes, IdsAreUniqueAndDescribed) {
  std::set<std::string> types;
  for (const NodeType* type : nodeTypes()) {
    EXPECT_TRUE(types.insert(type->id).second) << type->id;
    EXPECT_NE(*type->label, '\0');
    EXPECT_NE(*type->doc, '\0');
    EXPECT_EQ(findNodeType(type->id), type);
    std::set<std::string> ids;
    for (const PropertyRow& row : type->properties)
      EXPECT_TRUE(ids.insert(row.id).second) << type->id << "." << row.id;
  }
  EXPECT_EQ(findNodeType("weather2"), nullptr);
}

TEST(NodeTypes, ChoicesAreDescribedAndUnique) {
  for (const Row& row : allRows()) {
    if (row.property->kind != PropertyKind::Choice) continue;
    ASSERT_FALSE(row.property->choices.empty()) << row.property->id;
    std::set<std::string> ids;
    for (const Choice& choice : row.property->choices) {
      EXPECT_TRUE(ids.insert(choice.id).second);
      EXPECT_NE(*choice.label, '\0');
    }
  }
}

}  // namespace
}  // namespace spin
