// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "core/base/check.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "core/scene/json.h"
#include "core/scene/scene_file.h"

namespace spin::test {

inline std::string readFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

inline void writeFile(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
}

/// Content of every file below a folder, by relative name.
inline std::map<std::string, std::string> filesBelow(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[std::filesystem::relative(entry.path(), folder).string()] = readFile(entry.path().string());
  return files;
}

/// A folder that goes with the object.
class Folder {
 public:
  Folder() {
    static int counter = 0;
    m_path = std::filesystem::temp_directory_path() /
             ("spindrift-cli-test-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
    std::filesystem::create_directories(m_path);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return (m_path / name).string(); }
  std::string path() const { return m_path.string(); }

 private:
  std::filesystem::path m_path;
};

/// The program under way, its output in files.
class Program {
 public:
  Program(const Folder& folder, std::vector<std::string> arguments) {
    static int counter = 0;
    m_out = folder / ("stdout" + std::to_string(counter));
    m_error = folder / ("stderr" + std::to_string(counter++));
    m_pid = ::fork();
    SPIN_CHECK(m_pid >= 0, "fork");
    if (m_pid == 0) {
      redirect(STDOUT_FILENO, m_out);
      redirect(STDERR_FILENO, m_error);
      std::string program = SPIN_CLI;
      std::vector<char*> words{program.data()};
      for (std::string& word : arguments) words.push_back(word.data());
      words.push_back(nullptr);
      ::execv(SPIN_CLI, words.data());
      ::_exit(127);
    }
  }
  ~Program() {
    if (!m_ended) kill(SIGKILL), wait();
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void kill(int number) const { ::kill(m_pid, number); }
  /// Exit code, or 128 + signal.
  int wait() {
    int status = 0;
    ::waitpid(m_pid, &status, 0);
    m_ended = true;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  /// Waits until stdout has the text; false after 30 s.
  bool waitFor(const std::string& text) const {
    for (int i = 0; i < 3000; ++i) {
      if (out().find(text) != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }
  std::string out() const { return readFile(m_out); }
  std::string error() const { return readFile(m_error); }

 private:
  static void redirect(int descriptor, const std::string& path) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    ::dup2(file, descriptor);
    ::close(file);
  }
  std::string m_out, m_error;
  pid_t m_pid = -1;
  bool m_ended = false;
};

struct Outcome {
  int code = 0;
  std::string out, error;
};

inline Outcome runProgram(const Folder& folder, const std::vector<std::string>& arguments) {
  Program program(folder, arguments);
  const int code = program.wait();
  return {code, program.out(), program.error()};
}

inline void set(Scene& scene, const std::string& path, const std::string& value) {
  const Status done = scene.setFromText(path, value);
  SPIN_CHECK(done.ok(), done.error().text());
}

/// A hill of 10 x 8 cells with a box on it, light snowfall and wind; writes scene, terrain and model.
inline std::string writeTinyScene(const Folder& folder, const std::string& name = "tiny") {
  std::ostringstream grid;
  grid << "ncols 10\nnrows 8\nxllcorner 1000\nyllcorner 2000\ncellsize 5\nNODATA_value -9999\n";
  for (int j = 0; j < 8; ++j) {
    for (int i = 0; i < 10; ++i) grid << 100 + i * 0.5 + j * 0.25 << ' ';
    grid << '\n';
  }
  writeFile(folder / "hill.asc", grid.str());
  writeFile(folder / "box.obj",
            "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1\n"
            "f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n");
  Scene scene = makeDefaultScene();
  for (SceneNode node : {makeNode(kTerrainType, "terrain", "Hill"), makeNode(kModelType, "box", "Box"),
                         makeNode(kSnowfallType, "snowfall", "Snowfall")}) {
    const Status added = scene.append(std::move(node));
    SPIN_CHECK(added.ok(), added.error().text());
  }
  set(scene, "terrain.source", "hill.asc");
  set(scene, "terrain.epsg", "31287");
  set(scene, "terrain.credit", "Measured by nobody");
  set(scene, "terrain.cover_detail_cell_m", "1");
  set(scene, "box.source", "box.obj");
  set(scene, "box.position_m", "22 18 0");
  set(scene, "box.cover_cell_m", "0.5");
  set(scene, "snowfall.flake_count", "200");
  set(scene, "simulation.exposure_rays", "16");
  set(scene, "simulation.time_scale", "1000");
  set(scene, "simulation.last_frame", "5");
  set(scene, "simulation.checkpoint_interval", "2");
  set(scene, "camera.position_m", "22 -20 12");
  set(scene, "camera.target_m", "22 18 3");
  set(scene, "render.width_px", "160");
  set(scene, "render.height_px", "96");
  const std::string path = folder / (name + ".spindrift");
  const Status saved = saveScene(scene, {}, path);
  SPIN_CHECK(saved.ok(), saved.error().text());
  return path;
}

inline std::vector<std::string> dataFormats() {
  return {"--format", "ply", "--format", "vtp", "--format", "cover_tif"};
}

inline std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Every line of JSON progress, parsed.
inline std::vector<JsonValue> progressLines(const std::string& out) {
  std::vector<JsonValue> lines;
  std::istringstream in(out);
  for (std::string line; std::getline(in, line);) {
    Result<JsonValue> value = parseJson(line, "progress");
    SPIN_CHECK(value.ok(), "not a JSON line: " + line);
    lines.push_back(std::move(*value));
  }
  return lines;
}

inline std::string textOf(const JsonValue& value, const char* key) {
  const JsonValue* found = value.find(key);
  return found ? found->text : std::string();
}
inline double numberOf(const JsonValue& value, const char* key) {
  const JsonValue* found = value.find(key);
  return found ? found->number : -1.0;
}

}  // namespace spin::test
