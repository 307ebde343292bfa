// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/images_opencv/images_opencv_plugin.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "core/property/text_mark.h"
#include "plugins/images_opencv/srgb_quantizer.h"
#include "plugins/sdk/output_file.h"

namespace spin {
namespace {

constexpr int kMaxEdge = 32768;

template <class T>
cv::Mat encoded(const ImageFloat& image, int type, int maxCode) {
  const SrgbQuantizer quantize(maxCode);
  cv::Mat out(image.height, image.width, type);
  for (int y = 0; y < image.height; ++y) {
    const float* from = &image.rgba[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) * 4];
    T* to = out.ptr<T>(y);
    for (int x = 0; x < image.width; ++x, from += 4, to += 3)
      for (int c = 0; c < 3; ++c) to[c] = static_cast<T>(quantize(from[2 - c]));
  }
  return out;
}

cv::Mat linear(const ImageFloat& image) {
  cv::Mat out(image.height, image.width, CV_32FC3);
  for (int y = 0; y < image.height; ++y) {
    const float* from = &image.rgba[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) * 4];
    float* to = out.ptr<float>(y);
    for (int x = 0; x < image.width; ++x, from += 4, to += 3)
      for (int c = 0; c < 3; ++c) to[c] = from[2 - c];
  }
  return out;
}

bool encode(const ImageFloat& image, const std::string& formatId, const std::string& path) {
  // Level 3: nearly the size of 9 in a fraction of the time.
  const std::vector<int> png{cv::IMWRITE_PNG_COMPRESSION, 3};
  if (formatId == "png8") return cv::imwrite(path, encoded<std::uint8_t>(image, CV_8UC3, 255), png);
  if (formatId == "png16") return cv::imwrite(path, encoded<std::uint16_t>(image, CV_16UC3, 65535), png);
  return cv::imwrite(path, linear(image), {cv::IMWRITE_EXR_TYPE, cv::IMWRITE_EXR_TYPE_FLOAT});
}

/// A PNG ends with its IEND chunk; OpenCV does not report a disk that fills up at the last moment.
bool endsAsPng(const std::string& path) {
  char tail[8] = {};
  std::ifstream file(path, std::ios::binary);
  file.seekg(-8, std::ios::end);
  return file.read(tail, sizeof tail) && std::string(tail, 4) == "IEND";
}

}  // namespace

ImagesOpencvPlugin::ImagesOpencvPlugin() {
  // OpenCV asks for this before it writes EXR; a value that the user gave stays.
  setenv("OPENCV_IO_ENABLE_OPENEXR", "1", 0);
}

std::vector<ImageFormat> ImagesOpencvPlugin::formats() const {
  return {{"png8", SPIN_TR("PNG, 8 bit"), "png", false},
          {"png16", SPIN_TR("PNG, 16 bit"), "png", false},
          {"exr", SPIN_TR("OpenEXR, linear, 32 bit"), "exr", true}};
}

Status ImagesOpencvPlugin::write(const ImageFloat& image, const std::string& formatId,
                                 const std::string& path) {
  const std::size_t texels = static_cast<std::size_t>(std::max(image.width, 0)) *
                             static_cast<std::size_t>(std::max(image.height, 0));
  if (texels == 0 || image.width > kMaxEdge || image.height > kMaxEdge || image.rgba.size() != 4 * texels)
    return Error{ErrorKind::Usage, "The picture could not be written", path,
                 fmt::format("{} x {} pixels with {} values", image.width, image.height, image.rgba.size()),
                 ""};
  if (formatId != "png8" && formatId != "png16" && formatId != "exr")
    return Error{ErrorKind::Usage, "The picture could not be written", path, "unknown format " + formatId,
                 "Formats are png8, png16 and exr"};
  OutputFile file(path);
  errno = 0;
  try {
    if (!encode(image, formatId, file.temporaryPath()))
      return cannotWrite(path, "the folder or the disk refused it");
  } catch (const cv::Exception& exception) {
    return cannotWrite(path, exception.err);
  }
  if (formatId != "exr" && !endsAsPng(file.temporaryPath())) return cannotWrite(path, "its end is missing");
  return file.commit(64);
}

}  // namespace spin
