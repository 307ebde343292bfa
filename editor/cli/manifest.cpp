// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/cli/manifest.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/sim/runner.h"
#include "editor/cli/job_export.h"

namespace spin {
namespace {

JsonValue number(double value) {
  return JsonValue::of(value);
}

/// Quoted for a shell where that is needed.
std::string shellWord(const std::string& word) {
  const std::string plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:=+,@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

JsonValue framesOf(FrameRange frames) {
  JsonValue value = JsonValue::object();
  value.set("first", number(frames.first));
  value.set("last", number(frames.last));
  value.set("count", number(frames.count()));
  return value;
}

JsonValue placeOf(const SceneSnapshot& scene) {
  JsonValue place = JsonValue::object();
  const GeoReference geo = scene.terrain ? scene.terrain->geo : GeoReference{};
  place.set("epsg", geo.epsg > 0 ? number(geo.epsg) : JsonValue{});
  place.set("origin_m", JsonValue::array({number(geo.origin.x), number(geo.origin.y), number(geo.origin.z)}));
  place.set("note",
            JsonValue::of(
                "world coordinates = file coordinates + origin_m, unless the file itself is georeferenced"));
  return place;
}

}  // namespace

std::string equivalentCommand(const OpenedScene& opened, const JobOptions& options, FrameRange frames) {
  std::string line = fmt::format("spindrift-cli {} {}", options.command,
                                 shellWord(std::filesystem::path(opened.file).filename().string()));
  for (const std::string& assignment : options.scene.assignments) line += " --set " + shellWord(assignment);
  const auto sceneFolder = std::filesystem::path(opened.file).parent_path();
  for (const std::string& folder : options.scene.allowedFolders)
    line += " --allow " +
            shellWord(std::filesystem::absolute(folder).lexically_proximate(sceneFolder).generic_string());
  line += fmt::format(" --frames {}:{}", frames.first, frames.last);
  for (const std::string& format : options.formats) line += " --format " + shellWord(format);
  for (const std::string& part : options.parts) line += " --part " + shellWord(part);
  if (options.device != "auto") line += " --device " + shellWord(options.device);
  if (options.isa != "auto") line += " --isa " + shellWord(options.isa);
  return line;
}

std::string manifestText(const OpenedScene& opened, const JobOptions& options, FrameRange frames,
                         JsonValue outputs, const std::string& renderer) {
  const SceneSnapshot& scene = *opened.snapshot;
  const SimulationNode settings = scene.settings<SimulationNode>(0.0);
  JsonValue root = JsonValue::object();
  root.set("format", JsonValue::of("spindrift-export"));
  root.set("program", JsonValue::of(std::string("spindrift ") + SPIN_VERSION));
  root.set("scene", JsonValue::of(std::filesystem::path(opened.file).filename().string()));
  root.set("command", JsonValue::of(equivalentCommand(opened, options, frames)));
  root.set("frames", framesOf(frames));
  root.set("frame_rate_1_s", number(settings.frameRate));
  root.set("time_scale", number(settings.timeScale));
  root.set("seed", number(static_cast<double>(settings.seed)));
  root.set("solver_version", JsonValue::of(kSolverVersion));
  root.set("backend", JsonValue::of(backendName(options.isa)));
  root.set("units", JsonValue::of("SI: m, s, kg, K"));
  root.set("up_axis", JsonValue::of("z"));
  root.set("place", placeOf(scene));
  std::vector<JsonValue> credits;
  for (const std::string& credit : creditLines(scene)) credits.push_back(JsonValue::of(credit));
  root.set("credits", JsonValue::array(std::move(credits)));
  if (!renderer.empty()) root.set("renderer", JsonValue::of(renderer));
  root.set("outputs", std::move(outputs));
  static constexpr const char* kHead[] = {"format", "program", "scene", "command"};
  return writeJson(root, kHead);
}

}  // namespace spin
