// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace spin {

/// sRGB transfer function (IEC 61966-2-1) of a linear value in [0, 1].
double encodeSrgb(double linear);
/// Its inverse.
double decodeSrgb(double encoded);

/// Linear light to the nearest sRGB code of 0..maxCode, exactly rounded: by comparing with the linear values
/// half way between codes instead of evaluating a power per value. NaN gives 0.
class SrgbQuantizer {
 public:
  explicit SrgbQuantizer(int maxCode);

  std::uint16_t operator()(float linear) const {
    if (!(linear > 0.0f)) return 0;
    if (linear >= 1.0f) return static_cast<std::uint16_t>(m_half.size());
    std::uint32_t code = m_start[static_cast<std::size_t>(linear * kBuckets)];
    while (code < m_half.size() && linear >= m_half[code]) ++code;
    return static_cast<std::uint16_t>(code);
  }

 private:
  static constexpr float kBuckets = 65536.0f;
  std::vector<float> m_half;           ///< linear value where code k turns into k + 1
  std::vector<std::uint32_t> m_start;  ///< lowest code in each of the buckets
};

}  // namespace spin
