// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/images_opencv/srgb_quantizer.h"

#include <cmath>

namespace spin {

double encodeSrgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double decodeSrgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

SrgbQuantizer::SrgbQuantizer(int maxCode) : m_half(static_cast<std::size_t>(maxCode)) {
  for (std::size_t k = 0; k < m_half.size(); ++k)
    m_half[k] = static_cast<float>(decodeSrgb((static_cast<double>(k) + 0.5) / maxCode));
  m_start.resize(static_cast<std::size_t>(kBuckets));
  std::uint32_t code = 0;
  for (std::size_t b = 0; b < m_start.size(); ++b) {
    const float low = static_cast<float>(b) / kBuckets;
    while (code < m_half.size() && low >= m_half[code]) ++code;
    m_start[b] = code;
  }
}

}  // namespace spin
