// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <assimp/DefaultIOSystem.h>

namespace spin {

/// Files that a model names, looked for in the model's own folder only.
class ModelFolder {
 public:
  explicit ModelFolder(const std::string& modelPath);

  /// Path of a file named by the model ("tex/bark.png", also with %20 or back slashes); nothing if the name
  /// is absolute, an address, or leaves the folder by "..".
  std::optional<std::filesystem::path> resolve(const std::string& name) const;
  const std::filesystem::path& path() const { return m_folder; }

 private:
  std::filesystem::path m_folder;
};

/// Opens for Assimp only what lies in the model's folder, and notes what it refused.
class SandboxedFiles final : public Assimp::DefaultIOSystem {
 public:
  explicit SandboxedFiles(const ModelFolder& folder, std::vector<std::string>& refused)
      : m_folder(folder), m_refused(refused) {}

  bool Exists(const char* file) const override;
  Assimp::IOStream* Open(const char* file, const char* mode) override;

 private:
  bool allowed(const char* file) const;

  const ModelFolder& m_folder;
  std::vector<std::string>& m_refused;
};

}  // namespace spin
