// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/base/cancel.h"
#include "core/bench/bench_case.h"
#include "core/scene/json.h"
#include "editor/cli/job.h"

namespace spin {

/// One thing that is wrong with a scene.
struct SceneProblem {
  std::string node;  ///< empty: the scene as a whole
  std::string text;
  bool error = false;  ///< otherwise a warning
};
/// Files, ranges and settings that do not fit together.
std::vector<SceneProblem> findProblems(const OpenedScene& opened);

/// What `info` tells: nodes, terrain, models, cache, and of every cached frame budget, figures and timings.
JsonValue sceneInfo(const OpenedScene& opened, FrameStore& store, FrameRange frames);
/// The same as text for people.
std::string infoText(const JsonValue& info);

struct ImportRequest {
  std::string file;
  std::string into;      ///< scene file; empty = only look
  std::string name;      ///< of the new node; empty = from the file's name
  bool copy = false;     ///< copy the file and what it refers to into NAME.assets/ beside the scene
  std::string position;  ///< of a model, "X Y Z" in m; empty = on the ground that the camera looks at
  ImportOptions options;
  std::vector<std::string> allowedFolders;
};
/// Reads the file and prints the summary; adds a node to the scene and saves it where asked.
Status importFile(const ImportRequest& request, const PluginHost& plugins, const CancelToken& cancel);

/// All kinds of nodes with their properties as a Markdown page.
std::string propertyReference();

/// The example scene of the checkout that this program was built in or that the working directory is; empty
/// if there is none.
std::string exampleScene();
/// The built-in cases, those that measure a scene too with one: --scene FILE, else the example.
std::vector<BenchCase> commandLineBenchCases();

/// The whole command line without the program's name; returns the exit code.
int cliMain(const std::vector<std::string>& arguments, const CancelToken& cancel);

}  // namespace spin
