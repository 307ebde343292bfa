// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <sys/resource.h>

#include <csignal>

#include "plugins/cache_vdb/openvdb_headers.h"
#include "tests/plugins/air_frames.h"
#include "tests/plugins/particle_frames.h"
#include "tests/plugins/support.h"

namespace spin {
namespace {

using test::TempFolder;

/// A file as OpenVDB itself reads it.
class VdbFile {
 public:
  explicit VdbFile(const std::string& path) : m_file(path) { m_file.open(); }
  std::vector<std::string> names() {
    std::vector<std::string> all;
    for (auto name = m_file.beginName(); name != m_file.endName(); ++name) all.push_back(name.gridName());
    return all;
  }
  openvdb::FloatGrid::Ptr numbers(const std::string& name) {
    return openvdb::gridPtrCast<openvdb::FloatGrid>(m_file.readGrid(name));
  }
  openvdb::Vec3SGrid::Ptr vectors(const std::string& name) {
    return openvdb::gridPtrCast<openvdb::Vec3SGrid>(m_file.readGrid(name));
  }
  openvdb::MetaMap::Ptr about() { return m_file.getMetadata(); }

 private:
  openvdb::io::File m_file;
};

/// The cell's index on the lattice.
openvdb::Coord cellOf(const AirPart& part, std::size_t brick, std::size_t cell) {
  const auto [i, j, k] = std::array<std::size_t, 3>{cell % kBrickX, cell / kBrickX % kBrickY,
                                                    cell / (std::size_t{kBrickX} * kBrickY)};
  const auto& b = part.bricks[brick];
  return {b[0] * kBrickX + static_cast<int>(i), b[1] * kBrickY + static_cast<int>(j),
          b[2] * kBrickZ + static_cast<int>(k)};
}

class VdbExporterTest : public ::testing::Test {
 protected:
  void SetUp() override {
    openvdb::initialize();
    m_exporter = m_host.makeExporter("vdb");
    ASSERT_TRUE(m_exporter);
    ASSERT_TRUE(m_exporter->begin({test::sceneWithTerrain(), m_folder.path(), "fall", 0, 9}).ok());
  }
  VdbFile written(int frame) { return VdbFile(m_folder.file("fall.000" + std::to_string(frame) + ".vdb")); }

  PluginHost m_host;
  TempFolder m_folder;
  std::unique_ptr<CacheExporter> m_exporter;
};

TEST_F(VdbExporterTest, EveryCellComesBack) {
  const auto part = test::airPart();
  ASSERT_TRUE(m_exporter->writeFrame(test::airFrame(3, part)).ok());
  VdbFile file = written(3);
  EXPECT_EQ(file.names(), (std::vector<std::string>{"density", "mist", "snow", "temperature", "velocity"}));
  const auto density = file.numbers("density"), mist = file.numbers("mist"), snow = file.numbers("snow");
  const auto temperature = file.numbers("temperature");
  const auto velocity = file.vectors("velocity");
  ASSERT_TRUE(density && mist && snow && temperature && velocity);
  for (std::size_t brick = 0; brick < 3; ++brick)
    for (std::size_t cell = 0; cell < kBrickCells; ++cell) {
      const openvdb::Coord at = cellOf(*part, brick, cell);
      const float drops = test::mistAt(brick, cell), flakes = brick == 2 && cell == 7 ? 2.0f : 0.0f;
      ASSERT_EQ(mist->tree().getValue(at), drops) << brick << ", " << cell;
      ASSERT_EQ(snow->tree().getValue(at), flakes);
      ASSERT_NEAR(density->tree().getValue(at), drops + flakes, 1e-3f * (drops + flakes));
      ASSERT_EQ(temperature->tree().getValue(at), brick == 0 ? -3.5f : 0.0f);
      const openvdb::Vec3s v = velocity->tree().getValue(at);
      for (int d = 0; d < 3; ++d) ASSERT_EQ(v[d], test::velocityAt(brick, d, cell));
    }
}

TEST_F(VdbExporterTest, OnlyBricksThatHoldSomethingAreActive) {
  ASSERT_TRUE(m_exporter->writeFrame(test::airFrame(0)).ok());
  VdbFile file = written(0);
  EXPECT_EQ(file.numbers("density")->activeVoxelCount(), 2 * kBrickCells);
  EXPECT_EQ(file.numbers("snow")->activeVoxelCount(), kBrickCells);
  EXPECT_EQ(file.numbers("temperature")->activeVoxelCount(), kBrickCells);
  EXPECT_EQ(file.vectors("velocity")->activeVoxelCount(), 2 * kBrickCells);
  EXPECT_EQ(file.numbers("density")->background(), 0.0f);
  EXPECT_EQ(file.numbers("density")->tree().getValue({1000, 0, 0}), 0.0f);
}

TEST_F(VdbExporterTest, VoxelsStandWhereTheCellsAre) {
  ASSERT_TRUE(m_exporter->writeFrame(test::airFrame(0)).ok());
  VdbFile file = written(0);
  for (const openvdb::GridBase::Ptr& grid :
       {openvdb::GridBase::Ptr(file.numbers("density")), openvdb::GridBase::Ptr(file.vectors("velocity"))}) {
    EXPECT_EQ(grid->voxelSize(), openvdb::Vec3d(0.5));
    // Cell (0, 0, 0) of brick (3, -5, 2) begins at origin + 0.5 (48, -20, 8); its centre is 0.25 m on.
    EXPECT_EQ(grid->indexToWorld(openvdb::Coord(48, -20, 8)), openvdb::Vec3d(34.25, -29.75, 34.25));
  }
}

TEST_F(VdbExporterTest, ClassesUnitsAndTimesAreTold) {
  ASSERT_TRUE(m_exporter->writeFrame(test::airFrame(6)).ok());
  VdbFile file = written(6);
  const auto density = file.numbers("density"), temperature = file.numbers("temperature");
  const auto velocity = file.vectors("velocity");
  EXPECT_EQ(density->getGridClass(), openvdb::GRID_FOG_VOLUME);
  EXPECT_EQ(temperature->getGridClass(), openvdb::GRID_UNKNOWN);
  EXPECT_EQ(velocity->getGridClass(), openvdb::GRID_UNKNOWN);  // not staggered
  EXPECT_EQ(velocity->getVectorType(), openvdb::VEC_CONTRAVARIANT_RELATIVE);
  EXPECT_EQ(density->metaValue<std::string>("unit"), "kg/m3");
  EXPECT_EQ(velocity->metaValue<std::string>("unit"), "m/s");
  const auto about = file.about();
  EXPECT_EQ(about->metaValue<std::string>("up_axis"), "z");
  EXPECT_EQ(about->metaValue<int>("frame"), 6);
  EXPECT_EQ(about->metaValue<double>("time_film_s"), 0.25);
  EXPECT_EQ(about->metaValue<double>("ambient_temperature_K"), 268.15);
  EXPECT_EQ(about->metaValue<openvdb::Vec3d>("local_origin"),
            openvdb::Vec3d(176975.9368, 376240.3352, 1000.0));
  EXPECT_EQ(about->metaValue<int>("epsg"), 31287);
  const auto attributes = m_exporter->attributes();
  ASSERT_EQ(attributes.size(), 5u);
  EXPECT_EQ(attributes[4].name + attributes[4].unit, "velocitym/s");
  EXPECT_EQ(attributes[4].components, 3);
}

TEST_F(VdbExporterTest, SixteenBitsAreTakenWhereTheyHoldTheNumbers) {
  auto part = test::airPart();
  AirField thin{"vapour", "kg/m3", 1, 1e-6f, {}}, vast{"divergence", "1/s", 1, 1e4f, {}};
  thin.halves.assign(part->cells(), halfFromFloat(1.5f));
  vast.halves.assign(part->cells(), halfFromFloat(-100.0f));
  part->fields.insert(part->fields.end(), {thin, vast});
  ASSERT_TRUE(m_exporter->writeFrame(test::airFrame(0, part)).ok());
  VdbFile file = written(0);
  EXPECT_TRUE(file.numbers("density")->saveFloatAsHalf());
  EXPECT_TRUE(file.vectors("velocity")->saveFloatAsHalf());
  EXPECT_FALSE(file.numbers("vapour")->saveFloatAsHalf());
  EXPECT_EQ(file.numbers("vapour")->tree().getValue(cellOf(*part, 0, 0)), 1.5e-6f);
  EXPECT_EQ(file.numbers("divergence")->tree().getValue(cellOf(*part, 0, 0)), -1e6f);
}

TEST_F(VdbExporterTest, ClearAirIsAFileOfEmptyGrids) {
  auto part = std::make_shared<AirPart>();
  part->fields = {{"mist", "kg/m3", 1, 1.0f, {}}, {"velocity", "m/s", 3, 1.0f, {}}};
  ASSERT_TRUE(m_exporter->applies(test::airFrame(1, part)));
  ASSERT_TRUE(m_exporter->writeFrame(test::airFrame(1, part)).ok());
  VdbFile file = written(1);
  EXPECT_TRUE(file.numbers("density")->empty());
  EXPECT_TRUE(file.vectors("velocity")->empty());
  EXPECT_EQ(m_exporter->files(), std::vector<std::string>{"fall.0001.vdb"});
  EXPECT_FALSE(m_exporter->applies(test::flakeFrame(0, 3)));
}

TEST_F(VdbExporterTest, CellsBeyondTheIntegersAreRefused) {
  auto part = test::airPart();
  part->bricks[2] = {1 << 27, 0, 2};
  test::expectError(m_exporter->writeFrame(test::airFrame(2, part)), ErrorKind::Failed, "fall.0002.vdb",
                    {"farther", "Choose"});
  part->bricks[2] = {(1 << 27) - 1, 0, 2};
  EXPECT_TRUE(m_exporter->writeFrame(test::airFrame(2, part)).ok());
}

TEST_F(VdbExporterTest, FolderThatIsGoneIsAnError) {
  ASSERT_TRUE(m_exporter->begin({nullptr, m_folder.file("gone"), "fall", 0, 9}).ok());
  test::expectError(m_exporter->writeFrame(test::airFrame(4)), ErrorKind::Failed, "fall.0004.vdb",
                    {"No such file", "Check the folder"});
}

TEST_F(VdbExporterTest, FileThatIsCutShortLeavesNothing) {
  // The limit stands for a full disk: writes beyond it fail while the file is under way.
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit tight{1000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &tight);
  const Status status = m_exporter->writeFrame(test::airFrame(5));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  test::expectError(status, ErrorKind::Failed, "fall.0005.vdb", {"could not be written"});
  EXPECT_TRUE(m_folder.names().empty());
  EXPECT_TRUE(m_exporter->files().empty());
}

}  // namespace
}  // namespace spin
