// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// The example scenes of snow as small pictures: a few coarse frames each, compared with stored ones. Set
// SPIN_UPDATE_BASELINES to store the pictures of now instead, and look at them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/cli/program.h"

namespace spin {
namespace {

class ExamplePictures : public ::testing::Test {
 protected:
  /// Simulates up to `frame` and compares its picture with the baseline of that name.
  void compare(const std::string& scene, int frame, const std::string& name,
               std::vector<std::string> settings) {
    const std::string examples = SPIN_SOURCE_DIR "/resources/scenes/";
    std::vector<std::string> arguments{"render",   examples + scene + ".spindrift",
                                       "--allow",  examples,
                                       "--frames", std::to_string(frame),
                                       "--format", "png8",
                                       "--output", folder / name,
                                       "--cache",  folder / (scene + ".cache")};
    for (const char* common : {"render.width_px=240", "render.height_px=136", "render.samples=2",
                               "render.show_flakes=false", "render.show_caption=false"})
      settings.push_back(common);
    for (const std::string& setting : settings) {
      arguments.push_back("--set");
      arguments.push_back(setting);
    }
    const auto outcome = test::runProgram(folder, arguments);
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const std::string file = scene + (frame < 10 ? ".000" : ".00") + std::to_string(frame) + ".png";
    const cv::Mat now = cv::imread(folder / name + "/images/" + file);
    ASSERT_FALSE(now.empty());
    const std::string stored = SPIN_SOURCE_DIR "/tests/baselines/examples/" + name + ".png";
    if (std::getenv("SPIN_UPDATE_BASELINES")) {
      std::filesystem::create_directories(std::filesystem::path(stored).parent_path());
      ASSERT_TRUE(cv::imwrite(stored, now));
    }
    const cv::Mat before = cv::imread(stored);
    ASSERT_EQ(before.size(), now.size()) << "no baseline at " << stored;
    cv::Mat change;
    cv::absdiff(before, now, change);
    const cv::Scalar mean = cv::mean(change);
    const double steps = (mean[0] + mean[1] + mean[2]) / 3.0;
    if (steps > 4.0) cv::imwrite(name + "_now.png", now);
    EXPECT_LT(steps, 4.0) << "mean difference in 8-bit steps; the new picture is " << name << "_now.png";
  }
  test::Folder folder;
};

/// Four grounds, behind at +1 degC and in front at -1 degC, when the thinnest are nearly bare; then by depth.
TEST_F(ExamplePictures, GroundTypes) {
  const std::vector<std::string> settings{"simulation.frame_rate=1"};
  compare("ground_types", 4, "ground_types", settings);
  std::vector<std::string> depth = settings;
  depth.push_back("render.snow_display=depth");
  compare("ground_types", 4, "ground_types_depth", depth);
}

/// Two months: the first snow on meadow and ledges, steep rock bare.
TEST_F(ExamplePictures, SeasonKontertal) {
  compare("season_kontertal", 28, "season_kontertal",
          {"simulation.frame_rate=1", "simulation.time_scale=172800", "simulation.exposure_rays=8",
           "simulation.snow_slides=false", "weather.cloud_cover=0.5"});
}

/// Two hours of the storm, coarse and without drift: roofs, cars and branches white, dry ground in their lee.
TEST_F(ExamplePictures, VillageStorm) {
  compare("village_storm", 1, "village_storm",
          {"simulation.frame_rate=1", "simulation.time_scale=7200", "simulation.snow_drift=false",
           "terrain.cover_detail_cell_m=1", "simulation.exposure_rays=4", "simulation.exposure_directions=4",
           "simulation.exposure_map_size=512", "house.cover_cell_m=0.5", "hero_spruce.cover_cell_m=0.5",
           "car.cover_cell_m=0.3", "leaving_car.cover_cell_m=0.3", "camera.position_m=1976,2098,53",
           "camera.target_m=1990,2112,45.6"});
}

}  // namespace
}  // namespace spin
