// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/model_assimp/model_folder.h"

#include <algorithm>
#include <cctype>

namespace spin {

namespace fs = std::filesystem;

namespace {

std::string decodePercent(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto hex = [&](std::size_t at) { return std::isxdigit(static_cast<unsigned char>(text[at])) != 0; };
    if (text[i] == '%' && i + 2 < text.size() && hex(i + 1) && hex(i + 2)) {
      out += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      out += text[i];
    }
  }
  return out;
}

bool leavesFolder(const fs::path& relative) {
  if (relative.empty() || relative.is_absolute()) return true;
  const std::string text = relative.string();
  if (text.find("://") != std::string::npos || (text.size() > 1 && text[1] == ':')) return true;
  return *relative.lexically_normal().begin() == "..";
}

}  // namespace

ModelFolder::ModelFolder(const std::string& modelPath)
    : m_folder(fs::absolute(modelPath).parent_path().lexically_normal()) {}

std::optional<fs::path> ModelFolder::resolve(const std::string& name) const {
  std::string plain = name;
  std::replace(plain.begin(), plain.end(), '\\', '/');
  if (plain.find('\0') != std::string::npos || leavesFolder(plain)) return std::nullopt;
  std::error_code error;
  if (fs::is_regular_file(m_folder / plain, error)) return m_folder / plain;
  const std::string decoded = decodePercent(plain);
  if (decoded.find('\0') != std::string::npos || leavesFolder(decoded)) return std::nullopt;
  return m_folder / decoded;
}

bool SandboxedFiles::allowed(const char* file) const {
  const fs::path wanted = fs::absolute(file).lexically_normal();
  const bool inside = !leavesFolder(wanted.lexically_relative(m_folder.path()));
  if (!inside && m_refused.size() < 10 && !std::count(m_refused.begin(), m_refused.end(), file))
    m_refused.emplace_back(file);
  return inside;
}

bool SandboxedFiles::Exists(const char* file) const {
  return allowed(file) && DefaultIOSystem::Exists(file);
}

Assimp::IOStream* SandboxedFiles::Open(const char* file, const char* mode) {
  return allowed(file) && mode && mode[0] == 'r' ? DefaultIOSystem::Open(file, mode) : nullptr;
}

}  // namespace spin
