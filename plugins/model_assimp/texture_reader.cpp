// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/model_assimp/texture_reader.h"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "plugins/sdk/import_limits.h"
#include "plugins/sdk/memory_budget.h"

namespace spin {
namespace {

constexpr std::uintmax_t kMaxFileBytes = std::uintmax_t{256} << 20;
constexpr std::size_t kMaxTextures = 512;
/// All textures of a model together.
constexpr std::size_t kMaxTextureBytes = std::size_t{2} << 30;

cv::Mat toRgba(const cv::Mat& picture) {
  cv::Mat bytes = picture, rgba;
  if (picture.depth() == CV_16U)
    picture.convertTo(bytes, CV_8U, 1.0 / 257.0);
  else if (picture.depth() == CV_32F)
    picture.convertTo(bytes, CV_8U, 255.0);
  if (bytes.depth() != CV_8U) return {};
  if (bytes.channels() == 4)
    cv::cvtColor(bytes, rgba, cv::COLOR_BGRA2RGBA);
  else if (bytes.channels() == 3)
    cv::cvtColor(bytes, rgba, cv::COLOR_BGR2RGBA);
  else if (bytes.channels() == 1)
    cv::cvtColor(bytes, rgba, cv::COLOR_GRAY2RGBA);
  return rgba;
}

Image8 toImage(const cv::Mat& rgba) {
  Image8 image{rgba.cols, rgba.rows, {}};
  const std::size_t row = std::size_t{4} * static_cast<std::size_t>(rgba.cols);
  image.rgba.resize(row * static_cast<std::size_t>(rgba.rows));
  for (int y = 0; y < rgba.rows; ++y)
    std::memcpy(image.rgba.data() + row * static_cast<std::size_t>(y), rgba.ptr(y), row);
  return image;
}

cv::Mat shrunk(const cv::Mat& picture, const std::string& name, std::vector<std::string>& warnings) {
  const int edge = std::max(picture.cols, picture.rows);
  if (edge <= kMaxTextureEdge) return picture;
  const double factor = static_cast<double>(kMaxTextureEdge) / edge;
  const cv::Size size(std::max(1, static_cast<int>(picture.cols * factor)),
                      std::max(1, static_cast<int>(picture.rows * factor)));
  warnings.push_back(fmt::format("The texture {} was reduced from {} x {} to {} x {}", name, picture.cols,
                                 picture.rows, size.width, size.height));
  cv::Mat small;
  cv::resize(picture, small, size, 0, 0, cv::INTER_AREA);
  return small;
}

}  // namespace

int TextureReader::indexOf(const std::string& name) {
  if (name.empty()) return -1;
  if (const auto known = m_known.find(name); known != m_known.end()) return known->second;
  Image8 image =
      m_textures.size() < kMaxTextures ? load(name) : fail(name, "the model has too many textures");
  int index = -1;
  if (!image.empty()) {
    m_bytes += image.rgba.size();
    index = static_cast<int>(m_textures.size());
    m_textures.push_back(std::move(image));
  }
  m_known[name] = index;
  return index;
}

Image8 TextureReader::fail(const std::string& name, const std::string& why) {
  m_warnings.push_back(fmt::format("The texture {} is left out: {}", name, why));
  return {};
}

Image8 TextureReader::load(const std::string& name) {
  if (const aiTexture* embedded = m_scene.GetEmbeddedTexture(name.c_str()))
    return loadEmbedded(*embedded, name);
  return loadFile(name);
}

Image8 TextureReader::loadFile(const std::string& name) {
  const auto path = m_folder.resolve(name);
  if (!path) return fail(name, "it lies outside the model's folder; copy it beside the model");
  std::error_code error;
  if (!std::filesystem::is_regular_file(*path, error))
    return fail(name, "there is no such file beside the model");
  const std::uintmax_t size = std::filesystem::file_size(*path, error);
  if (error || size == 0 || size > kMaxFileBytes)
    return fail(name, fmt::format("its file has {} bytes", size));
  std::vector<unsigned char> bytes(static_cast<std::size_t>(size));
  std::ifstream file(*path, std::ios::binary);
  if (!file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())))
    return fail(name, "it could not be read");
  return decode(bytes, name);
}

Image8 TextureReader::loadEmbedded(const aiTexture& texture, const std::string& name) {
  if (!texture.pcData || texture.mWidth == 0) return fail(name, "it is empty");
  if (texture.mHeight == 0) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(texture.pcData);
    return decode(std::vector<unsigned char>(bytes, bytes + texture.mWidth), name);
  }
  if (texture.mWidth > kMaxTextureEdge || texture.mHeight > kMaxTextureEdge)
    return fail(name, fmt::format("it claims {} x {} texels", texture.mWidth, texture.mHeight));
  Image8 image{static_cast<int>(texture.mWidth), static_cast<int>(texture.mHeight), {}};
  const std::size_t texels = std::size_t{texture.mWidth} * texture.mHeight;
  image.rgba.reserve(4 * texels);
  for (std::size_t i = 0; i < texels; ++i) {
    const aiTexel& t = texture.pcData[i];
    image.rgba.insert(image.rgba.end(), {t.r, t.g, t.b, t.a});
  }
  return image;
}

Image8 TextureReader::decode(const std::vector<unsigned char>& bytes, const std::string& name) {
  try {
    const cv::Mat picture = cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
    if (picture.empty()) return fail(name, "it is no picture, or a damaged one");
    const cv::Mat rgba = toRgba(shrunk(picture, name, m_warnings));
    if (rgba.empty()) return fail(name, "its kind of pixels is not supported");
    if (m_bytes + rgba.total() * 4 > std::min(kMaxTextureBytes, memoryLeft()))
      return fail(name, "the model's textures together are too large");
    return toImage(rgba);
  } catch (const cv::Exception& exception) {
    return fail(name, exception.err);
  }
}

bool hasHoles(const Image8& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] < 128) return true;
  return false;
}

}  // namespace spin
