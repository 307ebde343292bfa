// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QtPlugin>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/sim/frame.h"

namespace spin {

/// A picture in linear light, rows from the top, 4 floats per pixel (RGB and coverage).
struct ImageFloat {
  int width = 0;
  int height = 0;
  std::vector<float> rgba;
};

/// A file format for single pictures.
struct ImageFormat {
  std::string id;         ///< "png8", "png16", "exr"
  std::string label;      ///< "PNG, 8 bit"
  std::string extension;  ///< "png"
  bool linear = false;    ///< values are stored as they are; otherwise sRGB-encoded and clamped
};

class ImageWriter {
 public:
  virtual ~ImageWriter() = default;
  virtual std::vector<ImageFormat> formats() const = 0;
  /// Writes through a temporary file; checks the result's existence and size.
  virtual Status write(const ImageFloat& image, const std::string& formatId, const std::string& path) = 0;
};

/// One attribute as the manifest lists it.
struct ExportedAttribute {
  std::string name;
  std::string unit;
  int components = 1;
};

/// What an exporter is told once per job.
struct ExportContext {
  SnapshotPointer scene;
  std::string directory;  ///< existing folder
  std::string baseName;   ///< files are baseName.0000.ext
  int firstFrame = 0;
  int lastFrame = 0;
};

/// Writes simulation data frame by frame. Names: `directory/baseName.%04d.extension`.
class CacheExporter {
 public:
  virtual ~CacheExporter() = default;
  virtual std::string id() const = 0;  ///< "ply", "vtp", "cover_tif"
  virtual std::string label() const = 0;
  /// False if this exporter finds nothing to write in such a frame (no particles, no cover).
  virtual bool applies(const Frame& frame) const = 0;
  virtual Status begin(const ExportContext& context) = 0;
  virtual Status writeFrame(const Frame& frame) = 0;
  /// After the last frame: index files (PVD). Also called after a cancelled job, for what is there.
  virtual Status finish() = 0;
  /// Files written so far, relative to the directory, in order.
  virtual std::vector<std::string> files() const = 0;
  virtual std::vector<ExportedAttribute> attributes() const = 0;
};

/// A plugin that makes exporters.
class ExporterFactory {
 public:
  virtual ~ExporterFactory() = default;
  virtual std::vector<std::string> ids() const = 0;
  virtual std::string labelOf(const std::string& id) const = 0;
  virtual std::unique_ptr<CacheExporter> create(const std::string& id) const = 0;
};

}  // namespace spin

#define SPIN_IMAGE_WRITER_IID "org.spindrift.ImageWriter/1"
#define SPIN_EXPORTER_FACTORY_IID "org.spindrift.ExporterFactory/1"
Q_DECLARE_INTERFACE(spin::ImageWriter, SPIN_IMAGE_WRITER_IID)
Q_DECLARE_INTERFACE(spin::ExporterFactory, SPIN_EXPORTER_FACTORY_IID)
