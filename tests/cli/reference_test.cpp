// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "editor/cli/commands.h"
#include "tests/cli/program.h"

namespace spin {
namespace {

TEST(Reference, TheCommittedPageIsUpToDate) {
  EXPECT_EQ(test::readFile(SPIN_SOURCE_DIR "/resources/docs/properties.md"), propertyReference())
      << "run: spindrift-cli reference resources/docs/properties.md";
}

TEST(Reference, NamesUnitsRangesAndChoices) {
  const std::string page = propertyReference();
  EXPECT_NE(page.find("| `wind_speed_m_s` | **Wind speed.** Mean wind; tilts the fall of the snow. | number, "
                      "0 to 80 | m/s | 2 "
                      "| yes | simulation and picture |"),
            std::string::npos);
  EXPECT_NE(page.find("`dendrite_aggregate`, `rimed_aggregate`, `graupel`"), std::string::npos);
}

}  // namespace
}  // namespace spin
