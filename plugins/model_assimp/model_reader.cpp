// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <cmath>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include "core/property/text_mark.h"
#include "plugins/model_assimp/model_assimp_plugin.h"
#include "plugins/model_assimp/ply_check.h"
#include "plugins/model_assimp/scene_converter.h"
#include "plugins/sdk/file_name.h"

namespace spin {
namespace {

constexpr const char* kWhat = "The model could not be read";

/// Keeps what Assimp warns of while it reads.
class WarningStream final : public Assimp::LogStream {
 public:
  explicit WarningStream(std::vector<std::string>& lines) : m_lines(lines) {}
  void write(const char* message) override {
    std::string line = message;
    while (!line.empty() && (line.back() == '\n' || line.back() == ' ')) line.pop_back();
    if (m_lines.size() < 10 && !std::count(m_lines.begin(), m_lines.end(), line)) m_lines.push_back(line);
  }

 private:
  std::vector<std::string>& m_lines;
};

/// Assimp's logger is one for the process; the import helper reads one file at a time.
class AssimpLog {
 public:
  explicit AssimpLog(std::vector<std::string>& lines) : m_stream(lines) {
    Assimp::DefaultLogger::create(nullptr, Assimp::Logger::NORMAL, 0);
    Assimp::DefaultLogger::get()->attachStream(&m_stream, Assimp::Logger::Warn | Assimp::Logger::Err);
  }
  ~AssimpLog() {
    Assimp::DefaultLogger::get()->detachStream(&m_stream, Assimp::Logger::Warn | Assimp::Logger::Err);
    Assimp::DefaultLogger::kill();
  }
  AssimpLog(const AssimpLog&) = delete;
  AssimpLog& operator=(const AssimpLog&) = delete;

 private:
  WarningStream m_stream;
};

const aiScene* readScene(Assimp::Importer& importer, const std::string& path) {
  // Points and lines have no surface for snow to lie on.
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  return importer.ReadFile(path, aiProcess_ValidateDataStructure | aiProcess_Triangulate |
                                     aiProcess_SortByPType | aiProcess_JoinIdenticalVertices);
}

void addRepairs(const MeshRepairs& repairs, std::vector<std::string>& warnings) {
  if (repairs.degenerate > 0)
    warnings.push_back(fmt::format("{} triangles without area are left out", repairs.degenerate));
  if (repairs.turned > 0)
    warnings.push_back(
        fmt::format("{} triangles were wound against their normals and are turned", repairs.turned));
  if (repairs.normalsMade > 0)
    warnings.push_back(fmt::format("{} meshes came without normals: computed", repairs.normalsMade));
  if (repairs.normalsMended > 0)
    warnings.push_back(fmt::format("{} normals were no direction: computed", repairs.normalsMended));
}

std::vector<SummaryLine> summaryLines(const ModelData& model, const ModelFrame& frame,
                                      const std::string& extension) {
  std::size_t faces = 0;
  for (const Mesh& mesh : model.meshes) faces += mesh.indices.size() / 3;
  const Box3d box = model.bounds();
  const Vec3d size = box.size();
  return {
      {SPIN_TR("Format"), extension},
      {SPIN_TR("Meshes"), fmt::format("{}", model.meshes.size())},
      {SPIN_TR("Triangles"), fmt::format("{}", faces)},
      {SPIN_TR("Instances"), fmt::format("{} ({} triangles)", model.instances.size(), model.triangleCount())},
      {SPIN_TR("Materials"), fmt::format("{}", model.materials.size())},
      {SPIN_TR("Textures"), fmt::format("{}", model.textures.size())},
      {SPIN_TR("Size"), fmt::format("{:.3f} x {:.3f} x {:.3f} m", size.x, size.y, size.z)},
      {SPIN_TR("Lowest point"), fmt::format("{:.3f} m", box.min.z)},
      {SPIN_TR("Up axis"), fmt::format("{}, {}", frame.yUp ? "y" : "z", frame.reason)},
      {SPIN_TR("Unit"), fmt::format("{:g} m", frame.scale)}};
}

Status checkOptions(const ImportOptions& options, const std::string& path) {
  if (options.upAxis < 0 || options.upAxis > 2)
    return Error{ErrorKind::Usage, kWhat, path, fmt::format("an up axis of {}", options.upAxis),
                 "1 is y, 2 is z"};
  if (!std::isfinite(options.unitScale) || options.unitScale < 0.0)
    return Error{ErrorKind::Usage, kWhat, path, fmt::format("a unit of {} m", options.unitScale),
                 "Give a positive number of metres per unit"};
  return {};
}

}  // namespace

Result<ModelImport> ModelAssimpPlugin::read(const std::string& path, const ImportOptions& options) {
  if (Status status = checkOptions(options, path); !status) return status.error();
  const std::string extension = lowerCaseExtension(path);
  if (extension == "ply")
    if (Status status = checkPlyFile(path); !status) return status.error();
  const ModelFolder folder(path);
  std::vector<std::string> refused, said;
  const AssimpLog log(said);
  Assimp::Importer importer;
  importer.SetIOHandler(new SandboxedFiles(folder, refused));  // owned by the importer
  const aiScene* scene = readScene(importer, path);
  if (!scene) {
    std::string why = importer.GetErrorString();
    if (!refused.empty()) why += "; it names " + refused.front() + ", which lies outside its folder";
    return badInput(kWhat, path, why.empty() ? "it is not what its ending says" : why,
                    "Check that the file and those it names are complete, and export it again");
  }
  const ModelFrame frame = modelFrameOf(*scene, extension, options);
  Result<ConvertedModel> converted = convertScene(*scene, frame, folder, path);
  if (!converted) return converted.error();
  std::vector<std::string>& warnings = converted->warnings;
  for (const std::string& name : refused)
    warnings.push_back("The file " + name + " is not read: it lies outside the model's folder");
  addRepairs(converted->repairs, warnings);
  if (scene->mNumAnimations > 0) warnings.push_back("Animations in the file are not used");
  const Vec3d size = converted->model.bounds().size();
  if (std::max({size.x, size.y, size.z}) < 0.01)
    warnings.push_back("The model is smaller than a centimetre: check its unit");
  warnings.insert(warnings.end(), said.begin(), said.end());
  auto model = std::make_shared<ModelData>(std::move(converted->model));
  model->warnings = warnings;
  return ModelImport{model, {summaryLines(*model, frame, extension), warnings}};
}

}  // namespace spin
