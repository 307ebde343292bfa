// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/fields/mesh.h"
#include "plugins/model_assimp/model_folder.h"

struct aiScene;
struct aiTexture;

namespace spin {

/// Decodes the textures that materials name, each once: embedded in the model or files beside it. What cannot
/// be had becomes a warning; the model is imported without it.
class TextureReader {
 public:
  TextureReader(const aiScene& scene, const ModelFolder& folder, std::vector<std::string>& warnings)
      : m_scene(scene), m_folder(folder), m_warnings(warnings) {}

  /// Index into textures(); -1 if there is no picture.
  int indexOf(const std::string& name);
  std::vector<Image8> take() { return std::move(m_textures); }
  const std::vector<Image8>& textures() const { return m_textures; }

 private:
  Image8 load(const std::string& name);
  Image8 loadFile(const std::string& name);
  Image8 loadEmbedded(const aiTexture& texture, const std::string& name);
  Image8 decode(const std::vector<unsigned char>& bytes, const std::string& name);
  Image8 fail(const std::string& name, const std::string& why);

  const aiScene& m_scene;
  const ModelFolder& m_folder;
  std::vector<std::string>& m_warnings;
  std::map<std::string, int> m_known;
  std::vector<Image8> m_textures;
  std::size_t m_bytes = 0;
};

/// True if any texel is nearly transparent, so that the material needs cutting out.
bool hasHoles(const Image8& image);

}  // namespace spin
