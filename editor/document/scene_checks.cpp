// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/document/scene_checks.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/nodes/air_nodes.h"
#include "core/nodes/camera_node.h"
#include "core/nodes/flow_nodes.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "core/scene/asset_library.h"
#include "core/sim/scene_time.h"

namespace spin {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("SceneChecks", text);
}

class Checks {
 public:
  explicit Checks(const Scene& scene) : m_scene(scene) {}

  std::vector<DocumentIssue> run() {
    checkNodes();
    checkFlow();
    checkAir();
    checkCopies();
    if (const auto* settings = first<SimulationNode>(kSimulationType)) checkSimulation(*settings);
    if (const auto* picture = first<RenderNode>(kRenderType)) checkPicture(*picture);
    if (const auto* weather = first<WeatherNode>(kWeatherType)) checkWeather(*weather);
    if (const auto* camera = first<CameraNode>(kCameraType); camera && camera->position == camera->target)
      add(Severity::Error, kCameraType, "target_m",
          QT_TRANSLATE_NOOP("SceneChecks", "Camera and target stand on the same spot. Move one of them."));
    return std::move(m_issues);
  }

 private:
  template <class T>
  const T* first(const NodeType& type) const {
    const SceneNode* node = m_scene.firstOf(type);
    return node ? node->as<T>() : nullptr;
  }
  void add(Severity severity, const NodeType& type, const char* property, const char* text) {
    const SceneNode* node = m_scene.firstOf(type);
    m_issues.push_back({severity, node ? node->id : std::string(), node ? property : "", tr(text)});
  }

  void checkNodes() {
    if (!m_scene.firstOf(kCameraType))
      add(Severity::Warning, kCameraType, "",
          QT_TRANSLATE_NOOP("SceneChecks", "There is no camera: pictures use a default view. Add a camera."));
    const bool snows = m_scene.firstOf(kSnowfallType);
    if (snows && !m_scene.firstOf(kWeatherType))
      add(Severity::Warning, kWeatherType, "",
          QT_TRANSLATE_NOOP("SceneChecks",
                            "It snows without weather: default weather is used. Add weather."));
    for (const SceneNode& node : m_scene.nodes()) {
      const auto* model = node.as<ModelNode>();
      const auto* terrain = node.as<TerrainNode>();
      if ((model && model->source.empty()) || (terrain && terrain->source.empty()))
        m_issues.push_back({Severity::Warning, node.id, "source",
                            QCoreApplication::translate("SceneChecks", "No file is chosen for %1.")
                                .arg(QString::fromStdString(node.name))});
    }
  }

  /// Nothing looks more like a mistake of the program than an avalanche that runs through a hut.
  void checkFlow() {
    const bool flows = m_scene.firstOf(kAvalancheReleaseType) || m_scene.firstOf(kWaterSourceType);
    const SceneNode* model = m_scene.firstOf(kModelType);
    if (!flows || !model || m_scene.firstOf(kRigidBodyType)) return;
    m_issues.push_back(
        {Severity::Information, model->id, "",
         QCoreApplication::translate("SceneChecks",
                                     "What flows passes through models. To put %1 in its way, select it and "
                                     "press \"Make rigid body\" at the end of its properties.")
             .arg(QString::fromStdString(model->name))});
  }

  void checkAir() {
    const SceneNode* air = m_scene.firstOf(kAirType);
    const auto flows = [](const SceneNode& node) {
      return node.enabled && (node.type == &kAvalancheReleaseType || node.type == &kWaterSourceType);
    };
    if (!air || !air->enabled || std::any_of(m_scene.nodes().begin(), m_scene.nodes().end(), flows)) return;
    m_issues.push_back(
        {Severity::Information, air->id, "",
         QCoreApplication::translate("SceneChecks",
                                     "Mist and powder come from what flows. Add a water source "
                                     "or an avalanche release.")});
  }

  void checkCopies() {
    constexpr std::size_t kMany = 40;
    for (const SceneNode& node : m_scene.nodes()) {
      const auto* model = node.as<ModelNode>();
      if (!model || model->copies.size() <= kMany || !model->fineCover) continue;
      m_issues.push_back(
          {Severity::Information, node.id, "fine_cover",
           QCoreApplication::translate("SceneChecks",
                                       "The ground round all %1 copies of %2 has small cover cells, which "
                                       "takes much time and memory. Switch that off for what stands in "
                                       "great numbers.")
               .arg(model->copies.size())
               .arg(QString::fromStdString(node.name))});
    }
  }

  void checkSimulation(const SimulationNode& settings) {
    if (settings.lastFrame < settings.firstFrame)
      add(Severity::Error, kSimulationType, "last_frame",
          QT_TRANSLATE_NOOP("SceneChecks", "The last frame comes before the first one."));
    if (settings.shedsAboveDegrees <= settings.holdsBelowDegrees)
      add(Severity::Error, kSimulationType, "sheds_above_deg",
          QT_TRANSLATE_NOOP("SceneChecks",
                            "Slopes must shed their snow at a steeper angle than they hold it."));
  }

  void checkWeather(const WeatherNode& weather) {
    if (!weather.start.empty() && !parseDateTime(weather.start))
      add(Severity::Error, kWeatherType, "start_utc",
          QT_TRANSLATE_NOOP("SceneChecks",
                            "The film's begin is no date. Write it as 2005-10-01 00:00 (UTC)."));
    if ((weather.sun == MeltingSun::ByDate || weather.lightByDate) && weather.start.empty() &&
        weather.source.empty())
      add(Severity::Warning, kWeatherType, "start_utc",
          QT_TRANSLATE_NOOP("SceneChecks",
                            "The sun needs a date: it stands still until the film's begin is set."));
  }

  void checkPicture(const RenderNode& picture) {
    const int n = picture.samples;
    if (n != 1 && n != 2 && n != 4 && n != 8)
      add(Severity::Warning, kRenderType, "samples",
          QT_TRANSLATE_NOOP("SceneChecks", "Samples per pixel should be 1, 2, 4 or 8."));
  }

  const Scene& m_scene;
  std::vector<DocumentIssue> m_issues;
};

}  // namespace

std::vector<DocumentIssue> checkScene(const Scene& scene) {
  return Checks(scene).run();
}

std::vector<DocumentIssue> filesOutside(const Scene& scene, const std::string& sceneFile,
                                        const PathPolicy& policy) {
  std::vector<DocumentIssue> issues;
  if (sceneFile.empty()) return issues;
  for (const SceneNode& node : scene.nodes()) {
    const std::string source = sourceOf(node);
    // A file that is refused here too is an issue of its own.
    if (source.empty() || resolveAssetPath(sceneFile, source, {}) ||
        !resolveAssetPath(sceneFile, source, policy))
      continue;
    issues.push_back({Severity::Warning, node.id, "source",
                      QCoreApplication::translate(
                          "SceneChecks",
                          "The file %1 lies outside the scene's folder: the command line refuses it, and "
                          "it is missing where the scene is moved to. Use File > Collect files beside "
                          "the scene.")
                          .arg(QString::fromStdString(source))});
  }
  return issues;
}

}  // namespace spin
