// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/scene/asset_library.h"
#include "core/sim/serialize.h"

namespace spin {

/// A counted list, item by item.
template <class T, class Encode>
void encodeAll(ByteWriter& out, const std::vector<T>& items, Encode encodeOne) {
  out.put(static_cast<std::uint64_t>(items.size()));
  for (const T& item : items) encodeOne(out, item);
}

/// Stops at the first item that is not there, so a false count takes no memory.
template <class T>
std::vector<T> decodeAll(ByteReader& in, T (*decodeOne)(ByteReader&)) {
  std::vector<T> items;
  const auto count = in.get<std::uint64_t>();
  for (std::uint64_t i = 0; i < count && in.ok(); ++i) items.push_back(decodeOne(in));
  return items;
}

inline void encodeTexts(ByteWriter& out, const std::vector<std::string>& texts) {
  encodeAll(out, texts, [](ByteWriter& o, const std::string& text) { o.put(text); });
}

inline std::vector<std::string> decodeTexts(ByteReader& in) {
  return decodeAll<std::string>(in, [](ByteReader& i) { return i.getText(); });
}

inline void encodeSummary(ByteWriter& out, const ImportSummary& summary) {
  encodeAll(out, summary.lines, [](ByteWriter& o, const SummaryLine& line) {
    o.put(line.label);
    o.put(line.value);
  });
  encodeTexts(out, summary.warnings);
}

inline ImportSummary decodeSummary(ByteReader& in) {
  ImportSummary summary;
  summary.lines = decodeAll<SummaryLine>(in, [](ByteReader& i) {
    SummaryLine line;
    line.label = i.getText();
    line.value = i.getText();
    return line;
  });
  summary.warnings = decodeTexts(in);
  return summary;
}

}  // namespace spin
