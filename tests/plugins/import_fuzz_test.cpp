// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Real readers on damaged files: whatever the libraries do, the program gets an Error or data that passed all
// checks, in bounded time and memory.
#include <atomic>
#include <chrono>
#include <thread>

#include "core/base/random.h"
#include "plugins/host/import_checks.h"
#include "tests/plugins/model_files.h"
#include "tests/plugins/raster_files.h"
#include "tests/plugins/support.h"

namespace spin {
namespace {

using test::TempFolder;

constexpr int kVariants = 40;
constexpr int kThreads = 2;
/// Some variants make a library loop for ever; the limit then ends it.
constexpr ImportLimits kLimits{std::size_t{256} << 20, 3.0};

std::string damaged(std::string bytes, std::uint64_t variant) {
  const CounterRandom random{11, 0};
  const UInt4 how = random.words(variant);
  const int flips = 1 + static_cast<int>(how.x % 8);
  for (int k = 0; k < flips; ++k) {
    const UInt4 words = random.words(variant, static_cast<std::uint32_t>(k + 1));
    bytes[words.x % bytes.size()] = static_cast<char>(words.y);
  }
  if (how.y % 8 == 0) bytes.resize(1 + how.z % bytes.size());
  return bytes;
}

/// Reads the variants of one file on two threads; `sound` judges what is accepted.
template <class Read, class Sound>
void fuzz(const std::string& extension, const std::string& bytes, Read read, Sound sound) {
  const TempFolder folder;
  std::atomic<int> next{0}, accepted{0}, wrong{0};
  const std::size_t before = test::peakMemory();
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t)
    threads.emplace_back([&] {
      for (int v = next++; v < kVariants; v = next++) {
        const std::string path = folder.file(std::to_string(v) + "." + extension);
        test::writeBytes(path, damaged(bytes, static_cast<std::uint64_t>(v)));
        const auto result = read(path);
        if (result.ok()) {
          ++accepted;
          if (!sound(*result)) ++wrong;
        } else if (result.error().text().find(path) == std::string::npos) {
          ++wrong;
        }
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0) << extension << ": accepted unsound data, or an error that does not name the file";
  EXPECT_LT(accepted, kVariants) << extension << ": no variant was damaged enough";
  EXPECT_LT(test::peakMemory(), before + (std::size_t{96} << 20));
}

void fuzzModel(const std::string& extension, const std::string& bytes) {
  fuzz(
      extension, bytes, [](const std::string& path) { return test::readModel(path, {}, kLimits); },
      [](const ModelImport& import) { return checkModel(*import.model, "m").ok(); });
}

void fuzzTerrain(const std::string& extension, const std::string& bytes) {
  fuzz(
      extension, bytes, [](const std::string& path) { return test::readTerrain(path, {}, kLimits); },
      [](const TerrainImport& import) { return checkTerrain(*import.terrain, "t").ok(); });
}

TEST(ImportFuzz, Glb) {
  fuzzModel("glb", test::boxGlb());
}
TEST(ImportFuzz, Gltf) {
  fuzzModel("gltf", test::boxGltf(""));
}
TEST(ImportFuzz, Obj) {
  fuzzModel("obj", test::boxObj());
}
TEST(ImportFuzz, Ply) {
  fuzzModel("ply", test::boxPly());
}
TEST(ImportFuzz, GeoTiff) {
  const TempFolder folder;
  fuzzTerrain("tif", test::readBytes(test::writeTiff(folder.file("a.tif"), {})));
}
TEST(ImportFuzz, AsciiGrid) {
  fuzzTerrain("asc", test::smallAsc());
}

}  // namespace
}  // namespace spin
