// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/plugins/air_frames.h"
#include "tests/plugins/support.h"

namespace spin {
namespace {

TEST(VdbInterop, VdbPrintSeesTheGrids) {
  if (test::outputOf("command -v vdb_print").empty())
    GTEST_SKIP() << "vdb_print is not installed (package libopenvdb-tools)";
  const test::TempFolder folder;
  const PluginHost host;
  const auto exporter = host.makeExporter("vdb");
  ASSERT_TRUE(exporter);
  ASSERT_TRUE(exporter->begin({nullptr, folder.path(), "fall", 0, 9}).ok());
  ASSERT_TRUE(exporter->writeFrame(test::airFrame(7)).ok());
  const std::string text = test::outputOf("vdb_print -l '" + folder.file("fall.0007.vdb") + "'");
  for (const char* part : {"Name: density", "Name: mist", "Name: snow", "Name: temperature", "Name: velocity",
                           "Tree_vec3s_5_4_3", "Tree_float_5_4_3", "fog volume", "contravariant",
                           "voxel size: 0.5", "unit: kg/m3", "up_axis: z"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " not in: " << text;
}

}  // namespace
}  // namespace spin
