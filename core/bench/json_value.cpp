// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/json_value.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace spin {
namespace {

constexpr int kMaxDepth = 64;

void appendUtf8(std::string& out, unsigned code) {
  const auto put = [&out](unsigned byte) { out += static_cast<char>(byte); };
  if (code < 0x80) return put(code);
  if (code < 0x800) return put(0xC0 | code >> 6), put(0x80 | (code & 0x3F));
  if (code < 0x10000)
    return put(0xE0 | code >> 12), put(0x80 | (code >> 6 & 0x3F)), put(0x80 | (code & 0x3F));
  put(0xF0 | code >> 18), put(0x80 | (code >> 12 & 0x3F)), put(0x80 | (code >> 6 & 0x3F));
  put(0x80 | (code & 0x3F));
}

class Parser {
 public:
  explicit Parser(std::string_view text) : m_text(text) {}

  Result<BenchJson> run() {
    BenchJson value;
    if (parseValue(value, 0)) {
      skipSpace();
      if (m_at == m_text.size()) return value;
      fail("text after the value");
    }
    return badInput("The JSON text could not be read", fmt::format("byte {}", m_at), m_why);
  }

 private:
  bool fail(const char* why) {
    if (m_why.empty()) m_why = why;
    return false;
  }
  void skipSpace() {
    while (m_at < m_text.size() && std::string_view(" \t\r\n").find(m_text[m_at]) != std::string_view::npos)
      ++m_at;
  }
  bool take(char c) {
    if (m_at >= m_text.size() || m_text[m_at] != c) return false;
    ++m_at;
    return true;
  }
  bool takeWord(std::string_view word) {
    if (m_text.substr(m_at, word.size()) != word) return fail("a value is expected");
    m_at += word.size();
    return true;
  }

  bool parseValue(BenchJson& value, int depth) {
    if (depth > kMaxDepth) return fail("nested too deeply");
    skipSpace();
    if (m_at >= m_text.size()) return fail("the text ends early");
    switch (m_text[m_at]) {
      case '{':
        return parseObject(value, depth);
      case '[':
        return parseList(value, depth);
      case '"':
        value.kind = BenchJson::Kind::String;
        return parseString(value.text);
      case 't':
      case 'f':
        value.kind = BenchJson::Kind::Bool;
        value.boolean = m_text[m_at] == 't';
        return takeWord(value.boolean ? "true" : "false");
      case 'n':
        return takeWord("null");
      default:
        return parseNumber(value);
    }
  }

  bool parseNumber(BenchJson& value) {
    value.kind = BenchJson::Kind::Number;
    const std::size_t digit = m_at + (m_text[m_at] == '-' ? 1 : 0);
    const auto isDigit = [this](std::size_t at) {
      return at < m_text.size() && m_text[at] >= '0' && m_text[at] <= '9';
    };
    if (!isDigit(digit)) return fail("a value is expected");
    if (m_text[digit] == '0' && isDigit(digit + 1)) return fail("a number starts with 0");
    const auto [end, error] =
        std::from_chars(m_text.data() + m_at, m_text.data() + m_text.size(), value.number);
    if (error != std::errc{} || !std::isfinite(value.number)) return fail("a number is out of range");
    m_at = static_cast<std::size_t>(end - m_text.data());
    if (m_text[m_at - 1] == '.') return fail("a number ends with a point");
    return true;
  }

  bool parseHex4(unsigned& code) {
    if (m_at + 4 > m_text.size()) return fail("the text ends early");
    const auto [end, error] = std::from_chars(m_text.data() + m_at, m_text.data() + m_at + 4, code, 16);
    if (error != std::errc{} || end != m_text.data() + m_at + 4)
      return fail("four hexadecimal digits expected");
    m_at += 4;
    return true;
  }

  bool parseEscape(std::string& out) {
    static constexpr std::string_view kShort = "\"\\/bfnrt", kMeaning = "\"\\/\b\f\n\r\t";
    if (m_at >= m_text.size()) return fail("the text ends early");
    const char c = m_text[m_at++];
    if (const auto at = kShort.find(c); at != std::string_view::npos) return out += kMeaning[at], true;
    if (c != 'u') return fail("unknown escape");
    unsigned code = 0;
    if (!parseHex4(code)) return false;
    if (code >= 0xD800 && code < 0xDC00) {
      unsigned low = 0;
      if (!take('\\') || !take('u') || !parseHex4(low) || low < 0xDC00 || low > 0xDFFF)
        return fail("half of a surrogate pair");
      code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
    } else if (code >= 0xDC00 && code < 0xE000) {
      return fail("half of a surrogate pair");
    }
    appendUtf8(out, code);
    return true;
  }

  bool parseString(std::string& out) {
    if (!take('"')) return fail("a quoted name is expected");
    while (m_at < m_text.size()) {
      const char c = m_text[m_at++];
      if (c == '"') return true;
      if (static_cast<unsigned char>(c) < 0x20) return fail("control character in a string");
      if (c != '\\')
        out += c;
      else if (!parseEscape(out))
        return false;
    }
    return fail("the text ends early");
  }

  bool parseList(BenchJson& value, int depth) {
    value.kind = BenchJson::Kind::List;
    take('[');
    skipSpace();
    if (take(']')) return true;
    do {
      if (!parseValue(value.items.emplace_back(), depth + 1)) return false;
      skipSpace();
    } while (take(','));
    return take(']') || fail("',' or ']' is expected");
  }

  bool parseObject(BenchJson& value, int depth) {
    value.kind = BenchJson::Kind::Object;
    take('{');
    skipSpace();
    if (take('}')) return true;
    do {
      std::string name;
      skipSpace();
      if (!parseString(name)) return false;
      if (value.find(name)) return fail("a member is repeated");
      skipSpace();
      if (!take(':')) return fail("':' is expected");
      value.members.emplace_back(std::move(name), BenchJson{});
      if (!parseValue(value.members.back().second, depth + 1)) return false;
      skipSpace();
    } while (take(','));
    return take('}') || fail("',' or '}' is expected");
  }

  std::string_view m_text;
  std::size_t m_at = 0;
  std::string m_why;
};

}  // namespace

const BenchJson* BenchJson::find(std::string_view name) const {
  for (const auto& [key, value] : members)
    if (key == name) return &value;
  return nullptr;
}

Result<BenchJson> parseBenchJson(std::string_view text) {
  return Parser(text).run();
}

std::string jsonQuote(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += '\\', out += c;
    else if (static_cast<unsigned char>(c) < 0x20)
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + '"';
}

std::string jsonNumber(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

}  // namespace spin
