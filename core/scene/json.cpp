// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace spin {

JsonValue JsonValue::of(bool value) {
  JsonValue json;
  json.kind = Kind::Bool;
  json.boolean = value;
  return json;
}

JsonValue JsonValue::of(double value) {
  SPIN_CHECK(std::isfinite(value), "JSON has no number for NaN and infinity");
  JsonValue json;
  json.kind = Kind::Number;
  json.number = value;
  return json;
}

JsonValue JsonValue::of(std::string value) {
  JsonValue json;
  json.kind = Kind::Text;
  json.text = std::move(value);
  return json;
}

JsonValue JsonValue::array(std::vector<JsonValue> items) {
  JsonValue json;
  json.kind = Kind::Array;
  json.items = std::move(items);
  return json;
}

JsonValue JsonValue::object() {
  JsonValue json;
  json.kind = Kind::Object;
  return json;
}

const JsonValue* JsonValue::find(std::string_view key) const {
  for (const Member& member : members)
    if (member.key == key) return &member.value;
  return nullptr;
}

JsonValue* JsonValue::find(std::string_view key) {
  return const_cast<JsonValue*>(std::as_const(*this).find(key));
}

void JsonValue::set(const std::string& key, JsonValue value) {
  SPIN_CHECK(kind == Kind::Null || kind == Kind::Object, "member of a JSON value that is no object");
  kind = Kind::Object;
  if (JsonValue* old = find(key))
    *old = std::move(value);
  else
    members.push_back({key, std::move(value)});
}

JsonValue JsonValue::take(std::string_view key) {
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const Member& member) { return member.key == key; });
  if (found == members.end()) return {};
  JsonValue value = std::move(found->value);
  members.erase(found);
  return value;
}

const char* kindText(JsonValue::Kind kind) {
  switch (kind) {
    case JsonValue::Kind::Null:
      return "null";
    case JsonValue::Kind::Bool:
      return "true or false";
    case JsonValue::Kind::Number:
      return "a number";
    case JsonValue::Kind::Text:
      return "a text";
    case JsonValue::Kind::Array:
      return "an array";
    case JsonValue::Kind::Object:
      return "an object";
  }
  return "a value";
}

namespace {

void writeText(const std::string& text, std::string& out) {
  out += '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20 || byte == 0x7F) {
      out += fmt::format("\\u{:04x}", byte);
    } else {
      out += c;
    }
  }
  out += '"';
}

bool isShortList(const JsonValue& array) {
  return array.items.size() <= 4 && std::all_of(array.items.begin(), array.items.end(), [](const auto& item) {
           return item.is(JsonValue::Kind::Number);
         });
}

class Writer {
 public:
  explicit Writer(std::span<const char* const> headKeys) : m_headKeys(headKeys) {}

  void write(const JsonValue& value, int depth) {
    switch (value.kind) {
      case JsonValue::Kind::Null:
        m_out += "null";
        break;
      case JsonValue::Kind::Bool:
        m_out += value.boolean ? "true" : "false";
        break;
      case JsonValue::Kind::Number:
        // Adding zero turns -0 into 0: both compare equal, so they must not make different files.
        m_out += fmt::format("{}", value.number + 0.0);
        break;
      case JsonValue::Kind::Text:
        writeText(value.text, m_out);
        break;
      case JsonValue::Kind::Array:
        writeArray(value, depth);
        break;
      case JsonValue::Kind::Object:
        writeObject(value, depth);
        break;
    }
  }
  std::string take() { return std::move(m_out); }

 private:
  void newLine(int depth) {
    m_out += '\n';
    m_out.append(static_cast<std::size_t>(2 * depth), ' ');
  }

  void writeArray(const JsonValue& array, int depth) {
    const bool oneLine = isShortList(array);
    m_out += '[';
    for (std::size_t i = 0; i < array.items.size(); ++i) {
      if (i > 0) m_out += oneLine ? ", " : ",";
      if (!oneLine) newLine(depth + 1);
      write(array.items[i], depth + 1);
    }
    if (!oneLine) newLine(depth);
    m_out += ']';
  }

  void writeObject(const JsonValue& object, int depth) {
    if (object.members.empty()) {
      m_out += "{}";
      return;
    }
    std::vector<const JsonValue::Member*> order;
    for (const JsonValue::Member& member : object.members) order.push_back(&member);
    std::sort(order.begin(), order.end(), [&](const auto* a, const auto* b) {
      const std::size_t rankA = rank(a->key, depth), rankB = rank(b->key, depth);
      return rankA != rankB ? rankA < rankB : a->key < b->key;
    });
    m_out += '{';
    for (const JsonValue::Member* member : order) {
      if (member != order.front()) m_out += ',';
      newLine(depth + 1);
      writeText(member->key, m_out);
      m_out += ": ";
      write(member->value, depth + 1);
    }
    newLine(depth);
    m_out += '}';
  }

  std::size_t rank(const std::string& key, int depth) const {
    if (depth > 0) return 0;
    for (std::size_t i = 0; i < m_headKeys.size(); ++i)
      if (key == m_headKeys[i]) return i;
    return m_headKeys.size();
  }

  std::span<const char* const> m_headKeys;
  std::string m_out;
};

}  // namespace

std::string writeJson(const JsonValue& root, std::span<const char* const> headKeys) {
  Writer writer(headKeys);
  writer.write(root, 0);
  return writer.take() + '\n';
}

}  // namespace spin
