// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "plugins/sdk/exporter.h"

namespace spin {

/// PNG with 8 or 16 bits and OpenEXR by OpenCV; RGB, the coverage channel is not stored.
class ImagesOpencvPlugin final : public QObject, public ImageWriter {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID SPIN_IMAGE_WRITER_IID FILE "images_opencv.json")
  Q_INTERFACES(spin::ImageWriter)

 public:
  ImagesOpencvPlugin();
  std::vector<ImageFormat> formats() const override;
  Status write(const ImageFloat& image, const std::string& formatId, const std::string& path) override;
};

}  // namespace spin
