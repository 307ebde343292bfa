// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/plugins/air_frames.h"
#include "tests/plugins/support.h"

namespace spin {
namespace {

TEST(VdbInterop, BlenderReadsTheSequence) {
  if (test::outputOf("command -v blender").empty())
    GTEST_SKIP() << "blender is not installed (package blender)";
  const test::TempFolder folder;
  const PluginHost host;
  const auto exporter = host.makeExporter("vdb");
  ASSERT_TRUE(exporter);
  ASSERT_TRUE(exporter->begin({nullptr, folder.path(), "fall", 0, 2}).ok());
  for (const int frame : {0, 1, 2}) ASSERT_TRUE(exporter->writeFrame(test::airFrame(frame)).ok());
  const test::ScopedEnvironment home("HOME", folder.path());
  const std::string text = test::outputOf(
      "blender -b --factory-startup --python-exit-code 3 --python '" SPIN_BLENDER_CHECK "' -- '" +
      folder.path() + "'");
  EXPECT_NE(text.find("read 5 grids of 3 frames"), std::string::npos) << text;
}

}  // namespace
}  // namespace spin
