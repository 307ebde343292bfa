// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "tests/plugins/support.h"

namespace spin {
namespace {

using test::TempFolder;

ImageFloat gradient(int width, int height) {
  ImageFloat image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float v = static_cast<float>(x) / static_cast<float>(width - 1);
      image.rgba.insert(image.rgba.end(),
                        {v, v * v, static_cast<float>(y) / static_cast<float>(height), 1.0f});
    }
  return image;
}

/// Independent of the writer's tables: the standard's formula, evaluated and rounded.
int srgbCode(float linear, int maxCode) {
  const double v = std::min(1.0, std::max(0.0, static_cast<double>(linear)));
  const double e = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
  return static_cast<int>(std::floor(e * maxCode + 0.5));
}

class ImageWriterTest : public ::testing::Test {
 protected:
  Status write(const ImageFloat& image, const std::string& format, const std::string& path) {
    return m_host.imageWriter(format)->write(image, format, path);
  }

  PluginHost m_host;
  TempFolder m_folder;
};

TEST_F(ImageWriterTest, Png8HoldsRoundedSrgb) {
  const ImageFloat image = gradient(257, 3);
  const std::string path = m_folder.file("a.png");
  ASSERT_TRUE(write(image, "png8", path).ok());
  const cv::Mat back = cv::imread(path, cv::IMREAD_UNCHANGED);
  ASSERT_EQ(back.type(), CV_8UC3);
  ASSERT_EQ(back.size(), cv::Size(257, 3));
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 257; ++x)
      for (int c = 0; c < 3; ++c)
        ASSERT_EQ(back.at<cv::Vec3b>(y, x)[2 - c],
                  srgbCode(image.rgba[static_cast<std::size_t>((y * 257 + x) * 4 + c)], 255))
            << x << " " << y << " " << c;
  EXPECT_EQ(m_folder.names(), std::vector<std::string>{"a.png"}) << "a temporary file is left";
}

TEST_F(ImageWriterTest, Png16HoldsRoundedSrgb) {
  const ImageFloat image = gradient(1000, 2);
  const std::string path = m_folder.file("a.png");
  ASSERT_TRUE(write(image, "png16", path).ok());
  const cv::Mat back = cv::imread(path, cv::IMREAD_UNCHANGED);
  ASSERT_EQ(back.type(), CV_16UC3);
  for (int x = 0; x < 1000; ++x)
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(back.at<cv::Vec3w>(0, x)[2 - c],
                  srgbCode(image.rgba[static_cast<std::size_t>(x * 4 + c)], 65535), 1);
}

TEST_F(ImageWriterTest, ExrKeepsLinearValuesBeyondOne) {
  ImageFloat image = gradient(64, 4);
  image.rgba[0] = 17.5f;
  image.rgba[1] = -0.25f;
  const std::string path = m_folder.file("a.exr");
  const Status status = write(image, "exr", path);
  ASSERT_TRUE(status.ok()) << status.error().text();
  const cv::Mat back = cv::imread(path, cv::IMREAD_UNCHANGED);
  ASSERT_EQ(back.type(), CV_32FC3);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 64; ++x)
      for (int c = 0; c < 3; ++c)
        ASSERT_EQ(back.at<cv::Vec3f>(y, x)[2 - c],
                  image.rgba[static_cast<std::size_t>((y * 64 + x) * 4 + c)]);
}

TEST_F(ImageWriterTest, OddValuesAreClampedAndSameImagesGiveSameBytes) {
  ImageFloat image{2, 2, {-1.0f, 2.0f, std::nanf(""), 1.0f, INFINITY, -INFINITY, 0.5f, 1.0f}};
  image.rgba.resize(16, 0.0f);
  ASSERT_TRUE(write(image, "png8", m_folder.file("a.png")).ok());
  ASSERT_TRUE(write(image, "png8", m_folder.file("b.png")).ok());
  const cv::Mat back = cv::imread(m_folder.file("a.png"), cv::IMREAD_UNCHANGED);
  EXPECT_EQ(back.at<cv::Vec3b>(0, 0), cv::Vec3b(0, 255, 0));
  EXPECT_EQ(back.at<cv::Vec3b>(0, 1), cv::Vec3b(188, 0, 255));
  EXPECT_EQ(test::readBytes(m_folder.file("a.png")), test::readBytes(m_folder.file("b.png")));
}

TEST_F(ImageWriterTest, FailuresAreErrorsAndLeaveNothing) {
  const ImageFloat image = gradient(8, 8);
  const std::string nowhere = m_folder.file("no/such/folder/a.png");
  test::expectError(write(image, "png8", nowhere), ErrorKind::Failed, nowhere, {"could not be written"});
  EXPECT_FALSE(write(image, "exr", m_folder.file("no/such/folder/a.exr")).ok());
  EXPECT_FALSE(write(ImageFloat{8, 8, {}}, "png8", m_folder.file("a.png")).ok());
  EXPECT_FALSE(write(ImageFloat{-8, 8, {}}, "png8", m_folder.file("a.png")).ok());
  EXPECT_TRUE(m_folder.names().empty());
}

}  // namespace
}  // namespace spin
