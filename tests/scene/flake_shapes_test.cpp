// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/flake_shapes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace spin {
namespace {

namespace fs = std::filesystem;

class FlakeShapes : public testing::Test {
 protected:
  FlakeShapes() : m_folder((fs::path(testing::TempDir()) / "flake_shapes").string()) {
    fs::remove_all(m_folder);
  }
  ~FlakeShapes() override { fs::remove_all(m_folder); }

  static FlakeNode small() {
    FlakeNode node;
    node.shapes = 2;
    node.largest = 0.5e-3;
    node.detail = FlakeDetail::Coarse;
    return node;
  }
  std::string m_folder;
};

TEST_F(FlakeShapes, AreGrownOnceAndThenReadFromTheCacheFolder) {
  const FlakeAtlasSettings settings = atlasSettingsOf(small());
  int told = 0;
  const auto grown = obtainFlakeAtlas(settings, m_folder, {}, [&](double) { ++told; });
  ASSERT_TRUE(grown.ok());
  EXPECT_EQ((*grown)->flakes(), 2);
  EXPECT_EQ((*grown)->size, 32);
  EXPECT_EQ(told, 2);
  ASSERT_TRUE(fs::exists(flakeAtlasFile(m_folder, flakeAtlasKey(settings))));
  const auto read = obtainFlakeAtlas(settings, m_folder, {}, [&](double) { ++told; });
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(told, 2) << "nothing grew";
  EXPECT_EQ((*read)->levels, (*grown)->levels);
  EXPECT_EQ((*read)->radii, (*grown)->radii);
}

TEST_F(FlakeShapes, ADamagedOrForeignFileIsRefusedAndGrownAgain) {
  const FlakeAtlasSettings settings = atlasSettingsOf(small());
  const Hash128 key = flakeAtlasKey(settings);
  const auto grown = obtainFlakeAtlas(settings, m_folder, {}, {});
  ASSERT_TRUE(grown.ok());
  const std::string path = flakeAtlasFile(m_folder, key);
  const auto size = static_cast<std::streamoff>(fs::file_size(path));
  for (const std::streamoff at : {std::streamoff{3}, std::streamoff{70}, size / 2, size - 1}) {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(at);
    const char byte = static_cast<char>(file.get() ^ 0x20);
    file.seekp(at);
    file.put(byte);
    file.close();
    EXPECT_FALSE(readFlakeAtlas(m_folder, key).ok()) << "byte " << at;
    const auto again = obtainFlakeAtlas(settings, m_folder, {}, {});
    ASSERT_TRUE(again.ok());
    EXPECT_EQ((*again)->levels, (*grown)->levels);
    EXPECT_TRUE(readFlakeAtlas(m_folder, key).ok()) << "it was written anew";
  }
  fs::resize_file(path, static_cast<std::uintmax_t>(size) - 5);
  EXPECT_FALSE(readFlakeAtlas(m_folder, key).ok());
  ASSERT_TRUE(writeFlakeAtlas(**grown, Hash128{1, 2}, m_folder).ok());
  fs::rename(flakeAtlasFile(m_folder, {1, 2}), path);
  EXPECT_FALSE(readFlakeAtlas(m_folder, key).ok()) << "of other settings";
}

TEST_F(FlakeShapes, TheKeyChangesWithWhatGrowsAndWithNothingElse) {
  const Hash128 base = flakeAtlasKey(atlasSettingsOf(small()));
  FlakeNode form = small();
  form.form = CrystalForm::Fern;
  EXPECT_EQ(flakeAtlasKey(atlasSettingsOf(form)), base) << "no crystals grow here";
  form.growth = FlakeGrowth::Crystal;
  const Hash128 fern = flakeAtlasKey(atlasSettingsOf(form));
  EXPECT_NE(fern, base);
  form.form = CrystalForm::Plate;
  EXPECT_NE(flakeAtlasKey(atlasSettingsOf(form)), fern);
  for (const PropertyInfo* property : {kFlakeType.find("seed"), kFlakeType.find("shapes"),
                                       kFlakeType.find("landings"), kFlakeType.find("detail")}) {
    FlakeNode other = small();
    property->set(other, std::get<std::int64_t>(property->get(other)) + 1);
    EXPECT_NE(flakeAtlasKey(atlasSettingsOf(other)), base) << property->id;
  }
}

TEST_F(FlakeShapes, EveryKindGrows) {
  for (const FlakeGrowth growth :
       {FlakeGrowth::Free, FlakeGrowth::SixArms, FlakeGrowth::EightArms, FlakeGrowth::Crystal}) {
    FlakeNode node = small();
    node.growth = growth;
    node.cells = 30;
    const auto grown = obtainFlakeAtlas(atlasSettingsOf(node), {}, {}, {});
    ASSERT_TRUE(grown.ok()) << grown.error().text();
    EXPECT_EQ((*grown)->flakes(), 2);
  }
  EXPECT_FALSE(fs::exists(m_folder)) << "an empty folder keeps nothing";
}

TEST_F(FlakeShapes, CancelAndImpossibleRangesAreErrors) {
  CancelToken cancel;
  cancel.cancel();
  const auto stopped = obtainFlakeAtlas(atlasSettingsOf(small()), m_folder, cancel, {});
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().kind, ErrorKind::Cancelled);
  FlakeNode wrong = small();
  wrong.smallest = 2e-3;
  EXPECT_FALSE(obtainFlakeAtlas(atlasSettingsOf(wrong), m_folder, {}, {}).ok());
}

}  // namespace
}  // namespace spin
