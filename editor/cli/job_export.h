// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/scene/json.h"
#include "editor/cli/job.h"
#include "plugins/sdk/exporter.h"

namespace spin {

class CancelWatch;
class EglContext;
class Renderer;

/// The frame with its particles where the camera of that moment sees them: flakes become particles round the
/// camera, periodic sets are unwrapped to the copy nearest to it and have no period any more.
FramePointer unwrapAtCamera(const FramePointer& frame, const SceneSnapshot& scene);

/// The frame with these parts alone; all where none is named.
FramePointer onlyParts(const FramePointer& frame, const std::vector<std::string>& parts);

/// Caption and credit lines that the scene asks for on its pictures; empty if it wants none.
std::vector<std::string> captionLines(const SceneSnapshot& scene);
/// Credits of the scene's data, whether or not they are shown.
std::vector<std::string> creditLines(const SceneSnapshot& scene);

/// Writes frames in all formats of a job, each in its folder.
class JobExport {
 public:
  JobExport(const OpenedScene& opened, const JobOptions& options, FrameRange frames,
            const PluginHost& plugins, std::string cacheFolder, const CancelToken& cancel);
  ~JobExport();

  /// Checks the formats, makes the folders, the context for pictures and the exporters.
  Status begin();
  Status writeFrame(const FramePointer& frame);
  /// Index files; also after a cancel, for what is there.
  Status finish();

  std::vector<WrittenFormat> written() const;
  /// What the manifest says about the outputs.
  JsonValue outputsForManifest() const;
  std::string rendererName() const;
  StageTimings& timings() { return m_timings; }

 private:
  struct Pictures;
  struct Cache;

  Status beginRenderer();
  Status beginPictures(const std::string& format);
  Status beginCache(const std::string& format);
  Status writePictures(const FramePointer& frame);
  std::string pathOf(const Pictures& pictures, int frame) const;

  const OpenedScene& m_opened;
  const JobOptions& m_options;
  FrameRange m_frames;
  const PluginHost& m_plugins;
  std::string m_cacheFolder;
  const CancelToken& m_cancel;
  std::string m_baseName;
  std::unique_ptr<EglContext> m_context;
  std::unique_ptr<Renderer> m_renderer;  ///< after the context: it dies first
  std::vector<Pictures> m_pictures;
  std::vector<Cache> m_caches;
  StageTimings m_timings;
  std::unique_ptr<CancelWatch> m_watch;  ///< last: its thread uses the others
};

/// Whether there are plugins for the formats.
Status checkFormats(const JobOptions& options, const PluginHost& plugins);
Status makeOutputFolders(const JobOptions& options);
/// Folder of a format below the output folder: "images", "particles", "cover", ...
std::string folderOfFormat(const std::string& format);

}  // namespace spin
