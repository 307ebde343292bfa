// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <set>

#include "core/property/text_check.h"
#include "core/scene/json.h"

namespace spin {
namespace {

using Kind = JsonValue::Kind;

void appendUtf8(unsigned code, std::string& out) {
  const auto put = [&](unsigned byte) { out += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0 | code >> 6);
    put(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    put(0xE0 | code >> 12);
    put(0x80 | (code >> 6 & 0x3F));
    put(0x80 | (code & 0x3F));
  } else {
    put(0xF0 | code >> 18);
    put(0x80 | (code >> 12 & 0x3F));
    put(0x80 | (code >> 6 & 0x3F));
    put(0x80 | (code & 0x3F));
  }
}

/// Recursive descent over the text; the first error ends it.
class Parser {
 public:
  Parser(std::string_view text, const JsonLimits& limits) : m_text(text), m_limits(limits) {}

  bool parse(JsonValue& root) {
    if (!value(root, 0)) return false;
    skipBlanks();
    return m_at == m_text.size() || fail("there is more text behind the end of the outermost value");
  }
  int line() const { return m_line; }
  const std::string& why() const { return m_why; }

 private:
  bool fail(std::string why) {
    if (m_why.empty()) m_why = std::move(why);
    return false;
  }
  char peek() const { return m_at < m_text.size() ? m_text[m_at] : '\0'; }
  std::string shown() const {
    if (m_at >= m_text.size()) return "the end of the file";
    return "\"" + printable(m_text.substr(m_at, 12)) + "\"";
  }
  void skipBlanks() {
    for (; m_at < m_text.size(); ++m_at) {
      const char c = m_text[m_at];
      if (c == '\n') ++m_line;
      if (c != ' ' && c != '\t' && c != '\n' && c != '\r') break;
    }
  }
  bool word(std::string_view expected) {
    if (m_text.substr(m_at, expected.size()) != expected)
      return fail("expected is a value, found " + shown());
    m_at += expected.size();
    return true;
  }

  bool value(JsonValue& out, int depth) {
    skipBlanks();
    if (depth > m_limits.depth) return fail(fmt::format("nested deeper than {} levels", m_limits.depth));
    if (++m_count > m_limits.values) return fail(fmt::format("more than {} values", m_limits.values));
    out.line = m_line;
    switch (peek()) {
      case '{':
        return object(out, depth);
      case '[':
        return array(out, depth);
      case '"':
        out.kind = Kind::Text;
        return string(out.text);
      case 't':
      case 'f':
        out.kind = Kind::Bool;
        out.boolean = peek() == 't';
        return word(out.boolean ? "true" : "false");
      case 'n':
        return word("null");
      default:
        return number(out);
    }
  }

  bool object(JsonValue& out, int depth) {
    out.kind = Kind::Object;
    std::set<std::string> keys;
    ++m_at;
    skipBlanks();
    if (peek() == '}') return ++m_at, true;
    while (true) {
      skipBlanks();
      if (peek() != '"') return fail("expected is a key in quotes, found " + shown());
      JsonValue::Member& member = out.members.emplace_back();
      if (!string(member.key)) return false;
      if (!keys.insert(member.key).second)
        return fail("the key \"" + printable(member.key) + "\" stands twice");
      skipBlanks();
      if (peek() != ':') return fail("expected is ':', found " + shown());
      ++m_at;
      if (!value(member.value, depth + 1)) return false;
      skipBlanks();
      if (peek() == '}') return ++m_at, true;
      if (peek() != ',') return fail("expected is ',' or '}', found " + shown());
      ++m_at;
    }
  }

  bool array(JsonValue& out, int depth) {
    out.kind = Kind::Array;
    ++m_at;
    skipBlanks();
    if (peek() == ']') return ++m_at, true;
    while (true) {
      if (!value(out.items.emplace_back(), depth + 1)) return false;
      skipBlanks();
      if (peek() == ']') return ++m_at, true;
      if (peek() != ',') return fail("expected is ',' or ']', found " + shown());
      ++m_at;
    }
  }

  bool number(JsonValue& out) {
    const std::size_t end = std::min(m_text.find_first_not_of("+-0123456789.eE", m_at), m_text.size());
    std::string_view digits = m_text.substr(m_at, end - m_at);
    if (!isNumber(digits)) return fail("expected is a value, found " + shown());
    const auto [stop, code] = std::from_chars(digits.data(), digits.data() + digits.size(), out.number);
    if (code == std::errc::result_out_of_range)
      return fail("the number " + printable(digits.substr(0, 40)) +
                  " is beyond what a computer number holds");
    if (stop != digits.data() + digits.size()) return fail("expected is a value, found " + shown());
    out.kind = Kind::Number;
    m_at = end;
    return true;
  }

  /// RFC 8259, section 6: -? (0 | [1-9] digits) (. digits)? ([eE] [+-]? digits)?
  static bool isNumber(std::string_view text) {
    std::size_t i = 0;
    const auto digits = [&] {
      const std::size_t first = i;
      while (i < text.size() && text[i] >= '0' && text[i] <= '9') ++i;
      return i - first;
    };
    if (i < text.size() && text[i] == '-') ++i;
    const bool zero = i < text.size() && text[i] == '0';
    const std::size_t whole = digits();
    if (whole == 0 || (zero && whole > 1)) return false;
    if (i < text.size() && text[i] == '.' && (++i, digits() == 0)) return false;
    if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
      ++i;
      if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
      if (digits() == 0) return false;
    }
    return i == text.size();
  }

  bool string(std::string& out) {
    ++m_at;
    const std::size_t begin = m_at;
    for (; m_at < m_text.size(); ++m_at) {
      const auto c = static_cast<unsigned char>(m_text[m_at]);
      if (c == '"') {
        ++m_at;
        return isCleanText(m_text.substr(begin, m_at - begin - 1)) ||
               fail("a text is not well-formed UTF-8 or has control characters");
      }
      if (c < 0x20) return fail("a text runs over the end of its line");
      if (c == '\\') {
        if (!escape(out)) return false;
      } else {
        out += static_cast<char>(c);
      }
    }
    return fail("a text has no end");
  }

  /// Leaves m_at on the last character of the sequence.
  bool escape(std::string& out) {
    static constexpr std::string_view kNames = "\"\\/bfnrt", kMeant = "\"\\/\b\f\n\r\t";
    ++m_at;
    if (peek() == 'u') return unicode(out);
    const std::size_t which = m_at < m_text.size() ? kNames.find(peek()) : std::string_view::npos;
    if (which == std::string_view::npos) return fail("unknown escape in a text");
    out += kMeant[which];
    return true;
  }

  bool unicode(std::string& out) {
    unsigned code = 0, low = 0;
    if (!hex(code)) return false;
    if (code >= 0xDC00 && code < 0xE000) return fail("half of a surrogate pair in a text");
    if (code >= 0xD800 && code < 0xDC00) {
      if (m_text.substr(m_at + 1, 2) != "\\u") return fail("half of a surrogate pair in a text");
      m_at += 2;
      if (!hex(low)) return false;
      if (low < 0xDC00 || low >= 0xE000) return fail("half of a surrogate pair in a text");
      code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
    }
    appendUtf8(code, out);
    return true;
  }

  /// Reads the four digits behind the 'u' at m_at and stops on the last of them.
  bool hex(unsigned& code) {
    const std::string_view digits = m_text.substr(std::min(m_at + 1, m_text.size()), 4);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (digits.size() != 4 || error != std::errc() || end != digits.data() + 4)
      return fail("\\u wants four hexadecimal digits");
    m_at += 4;
    return true;
  }

  std::string_view m_text;
  JsonLimits m_limits;
  std::size_t m_at = 0;
  std::size_t m_count = 0;
  int m_line = 1;
  std::string m_why;
};

}  // namespace

Result<JsonValue> parseJson(std::string_view text, const std::string& nameForMessages,
                            const JsonLimits& limits) {
  Parser parser(text, limits);
  JsonValue root;
  if (parser.parse(root)) return root;
  return badInput("The file is no valid JSON", fmt::format("{}, line {}", nameForMessages, parser.line()),
                  parser.why());
}

}  // namespace spin
