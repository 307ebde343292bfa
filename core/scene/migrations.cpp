// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/migrations.h"

#include <fmt/format.h>

#include "core/base/units.h"
#include "core/scene/scene_file.h"

namespace spin {
namespace {

using Kind = JsonValue::Kind;

void scaleNumber(JsonValue* json, double (*convert)(double)) {
  if (json && json->is(Kind::Number)) json->number = convert(json->number);
}

/// A property's plain value, or the value and all keys where it is animated.
void scaleProperty(JsonValue& json, double (*convert)(double)) {
  scaleNumber(&json, convert);
  scaleNumber(json.find("value"), convert);
  if (JsonValue* keys = json.find("keys"))
    for (JsonValue& key : keys->items) scaleNumber(key.find("value"), convert);
}

bool isOfType(const JsonValue& node, const char* type) {
  const JsonValue* json = node.find("type");
  return json && json->is(Kind::Text) && json->text == type;
}

/// Schema 1 kept the weather's precipitation in mm/h; since schema 2 every number in the file is SI.
void precipitationToSi(JsonValue& root, std::vector<std::string>& messages) {
  JsonValue* nodes = root.find("nodes");
  if (!nodes) return;
  for (JsonValue& node : nodes->items) {
    JsonValue* properties = node.find("properties");
    if (!isOfType(node, "weather") || !properties || !properties->find("precipitation_mm_h")) continue;
    JsonValue value = properties->take("precipitation_mm_h");
    scaleProperty(value, [](double mmPerHour) { return millimetresPerHourToSi(mmPerHour); });
    if (!properties->find("precipitation_rate_kg_m2_s"))
      properties->set("precipitation_rate_kg_m2_s", std::move(value));
    messages.emplace_back("schema 1 to 2: precipitation_mm_h became precipitation_rate_kg_m2_s");
  }
}

using Migration = void (*)(JsonValue&, std::vector<std::string>&);
/// Entry i leads from schema i + 1 to i + 2.
constexpr Migration kMigrations[] = {precipitationToSi};
static_assert(std::size(kMigrations) + 1 == kSceneSchema, "every older schema needs its step");

}  // namespace

void migrate(JsonValue& root, int fromSchema, std::vector<std::string>& messages) {
  for (int schema = fromSchema; schema < kSceneSchema; ++schema)
    kMigrations[static_cast<std::size_t>(schema - 1)](root, messages);
}

}  // namespace spin
