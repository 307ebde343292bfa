// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/frame_store.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/sim/checked_file.h"
#include "tests/core/sim/test_processes.h"

namespace spin {
namespace {

namespace fs = std::filesystem;

std::vector<Hash128> keysOf(std::uint64_t scene, int count) {
  std::vector<Hash128> keys;
  for (int frame = 0; frame < count; ++frame) keys.push_back({scene, static_cast<std::uint64_t>(frame)});
  return keys;
}

FramePointer makeFrame(std::uint64_t scene, int number, std::size_t particles = 10) {
  auto frame = std::make_shared<Frame>();
  frame->info.time.frame = number;
  frame->info.key = {scene, static_cast<std::uint64_t>(number)};
  auto part = std::make_shared<ParticlePart>();
  part->particles.positions.assign(particles,
                                   Vec3f{static_cast<float>(scene), static_cast<float>(number), 0});
  frame->parts["p"] = part;
  return frame;
}

FramePointer withCover(const FramePointer& frame, float base, float exposure = 1.0f) {
  auto copy = std::make_shared<Frame>(*frame);
  auto layout = std::make_shared<CoverLayout>();
  layout->grids.push_back(
      {"t", "t", Raster<float>(30, 40, 0, 0, 1, base), Raster<float>(30, 40, 0, 0, 1, 1.0f)});
  auto cover = std::make_shared<CoverPart>();
  cover->layout = layout;
  cover->exposure = std::make_shared<CoverExposure>(CoverExposure{{std::vector<float>(1200, exposure)}});
  cover->values = {{std::vector<float>(1200, 1), std::vector<float>(1200, 2)}};
  copy->parts["cover"] = cover;
  return copy;
}

std::shared_ptr<const CoverExposure> exposureOf(FrameStore& store, int number) {
  const FramePointer frame = store.get(number);
  const auto* cover = frame ? frame->part<CoverPart>("cover") : nullptr;
  SPIN_CHECK(cover && cover->exposure, "the frame has no exposure");
  return cover->exposure;
}

std::vector<std::string> filesIn(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

std::string bytesOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

void overwrite(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

TEST(CheckedFile, EveryTruncationAndEveryFlippedByteIsFound) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("file");
  ASSERT_TRUE(writeCheckedFile(path, {"frame", 12, {1, 2}, {{3, 4}}}, {'d', 'a', 't', 'a'}));
  const std::string whole = bytesOf(path);
  ASSERT_TRUE(readCheckedFile(path));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    overwrite(path, whole.substr(0, size));
    EXPECT_FALSE(readCheckedFile(path)) << size;
    EXPECT_FALSE(readCheckedHeader(path)) << size;
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ 0x10);
    overwrite(path, flipped);
    EXPECT_FALSE(readCheckedFile(path)) << at;
  }
  overwrite(path, whole + "x");
  EXPECT_FALSE(readCheckedFile(path)) << "longer than it claims";
  EXPECT_EQ(filesIn(folder.path()).size(), 1u) << "no temporary file is left";
}

TEST(CheckedFile, AFailedWriteLeavesTheOldFile) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(writeCheckedFile(folder.path("none/file"), {"frame", 0, {}, {}}, {}));
  const std::string path = folder.path("file");
  ASSERT_TRUE(writeCheckedFile(path, {"frame", 1, {1, 1}, {}}, {'a'}));
  // What a process killed while writing leaves behind is only the temporary file.
  overwrite(path + ".1-1.tmp", "half");
  EXPECT_EQ(readCheckedFile(path)->payload, std::vector<char>{'a'});
}

TEST(FrameStore, FramesAreReadyStaleOrMissingByTheirKeys) {
  const test::TemporaryFolder folder;
  FrameStore store({folder.path("cache")});
  store.setKeys(keysOf(1, 4));
  ASSERT_TRUE(store.put(makeFrame(1, 0)));
  ASSERT_TRUE(store.put(makeFrame(1, 2)));
  using S = FrameState;
  EXPECT_EQ(store.states(4), (std::vector<S>{S::Ready, S::Missing, S::Ready, S::Missing}));
  auto keys = keysOf(1, 4);
  keys[2] = {2, 2};
  store.setKeys(keys);
  EXPECT_EQ(store.states(4), (std::vector<S>{S::Ready, S::Missing, S::Stale, S::Missing}));
  EXPECT_FALSE(store.get(2));
  EXPECT_EQ(store.nearest(2)->info.key, (Hash128{1, 2})) << "the stale frame is still shown";
  ASSERT_TRUE(store.put(makeFrame(2, 2)));
  EXPECT_EQ(store.nearest(2)->info.key, (Hash128{2, 2}));
  store.setKeys(keysOf(1, 4));
  EXPECT_TRUE(store.get(2)) << "undo finds the old frame on disk";
}

TEST(FrameStore, NearestPrefersTheCloserThenTheReadyThenTheEarlier) {
  FrameStore store;
  EXPECT_FALSE(store.nearest(5));
  store.setKeys(keysOf(1, 20));
  ASSERT_TRUE(store.put(makeFrame(1, 4)));
  ASSERT_TRUE(store.put(makeFrame(1, 10)));
  ASSERT_TRUE(store.put(makeFrame(9, 6)));
  EXPECT_EQ(store.nearest(4)->info.time.frame, 4);
  EXPECT_EQ(store.nearest(6)->info.time.frame, 6);
  EXPECT_EQ(store.nearest(5)->info.time.frame, 4) << "ready before stale at the same distance";
  EXPECT_EQ(store.nearest(7)->info.time.frame, 6);
  EXPECT_EQ(store.nearest(19)->info.time.frame, 10);
}

TEST(FrameStore, MemoryStaysInItsBudgetAndTheDiskHasTheRest) {
  const test::TemporaryFolder folder;
  const std::size_t one = makeFrame(1, 0, 1000)->memoryBytes();
  FrameStore store({folder.path("cache"), 3 * one + 10});
  store.setKeys(keysOf(1, 6));
  for (int frame = 0; frame < 6; ++frame) {
    ASSERT_TRUE(store.put(makeFrame(1, frame, 1000)));
    EXPECT_LE(store.usage().memoryBytes, 3 * one + 10);
  }
  EXPECT_EQ(store.usage().memoryBytes, 3 * one);
  const FramePointer first = store.get(0);
  ASSERT_TRUE(first) << "read back from disk";
  EXPECT_EQ(first, store.get(0)) << "and kept in RAM";
  EXPECT_LE(store.usage().memoryBytes, 3 * one + 10);
}

TEST(FrameStore, LeastRecentlyUsedFramesLeaveFirst) {
  const std::size_t one = makeFrame(1, 0, 1000)->memoryBytes();
  FrameStore store({"", 2 * one});
  store.setKeys(keysOf(1, 6));
  ASSERT_TRUE(store.put(makeFrame(1, 0, 1000)));
  ASSERT_TRUE(store.put(makeFrame(1, 1, 1000)));
  EXPECT_TRUE(store.get(0));
  ASSERT_TRUE(store.put(makeFrame(1, 2, 1000)));
  EXPECT_TRUE(store.get(0));
  EXPECT_EQ(store.state(1), FrameState::Missing) << "RAM only: what leaves is gone";
  FrameStore tiny({"", 10});
  tiny.setKeys(keysOf(1, 6));
  ASSERT_TRUE(tiny.put(makeFrame(1, 3, 1000)));
  EXPECT_TRUE(tiny.get(3)) << "one frame always fits";
}

TEST(FrameStore, AnotherStoreFindsTheFiles) {
  const test::TemporaryFolder folder;
  FrameStore late({folder.path("cache")});
  {
    FrameStore store({folder.path("cache")});
    store.setKeys(keysOf(1, 3));
    ASSERT_TRUE(store.put(withCover(makeFrame(1, 1), 3.0f)));
    ASSERT_TRUE(store.putCheckpoint(1, {1, 1}, {'s'}));
  }
  FrameStore store({folder.path("cache")});
  store.setKeys(keysOf(1, 3));
  ASSERT_TRUE(store.get(1));
  EXPECT_EQ(test::resultOf(store.get(1)), test::resultOf(withCover(makeFrame(1, 1), 3.0f)));
  EXPECT_EQ(store.latestCheckpoint(2)->state, std::vector<char>{'s'});
  late.setKeys(keysOf(1, 3));
  EXPECT_TRUE(late.get(1)) << "declaring keys takes in what another process wrote";
}

TEST(FrameStore, LayoutsAreWrittenOnceAndSharedAfterLoading) {
  const test::TemporaryFolder folder;
  {
    FrameStore store({folder.path("cache")});
    store.setKeys(keysOf(1, 3));
    for (int frame = 0; frame < 3; ++frame) ASSERT_TRUE(store.put(withCover(makeFrame(1, frame), 3.0f)));
  }
  EXPECT_EQ(filesIn(folder.path("cache/shared")).size(), 2u) << "a layout and an exposure";
  FrameStore store({folder.path("cache")});
  store.setKeys(keysOf(1, 3));
  EXPECT_EQ(test::layoutOf(*store.get(0)), test::layoutOf(*store.get(2)));
  EXPECT_EQ(exposureOf(store, 0), exposureOf(store, 2));
}

TEST(FrameStore, ExposuresThatChangeAreKeptApartAndLeaveRamWithTheirFrames) {
  const test::TemporaryFolder folder;
  {
    FrameStore store({folder.path("cache")});
    store.setKeys(keysOf(1, 3));
    for (int frame = 0; frame < 3; ++frame)
      ASSERT_TRUE(store.put(withCover(makeFrame(1, frame), 3.0f, 0.1f * static_cast<float>(frame))));
  }
  FrameStore store({folder.path("cache"), 1});
  store.setKeys(keysOf(1, 3));
  std::weak_ptr<const CoverExposure> before;
  for (int frame = 0; frame < 3; ++frame) {
    const auto exposure = exposureOf(store, frame);
    EXPECT_EQ(exposure->grids[0][7], 0.1f * static_cast<float>(frame));
    EXPECT_TRUE(before.expired()) << "the budget is one frame";
    before = exposure;
  }
}

TEST(FrameStore, DamageInSharedDataIsFoundWhenItIsReadAndMended) {
  const test::TemporaryFolder folder;
  {
    FrameStore store({folder.path("cache")});
    ASSERT_TRUE(store.put(withCover(makeFrame(1, 0), 3.0f)));
  }
  const std::string shared = filesIn(folder.path("cache/shared"))[0];
  std::string flipped = bytesOf(shared);
  flipped.back() ^= 1;
  overwrite(shared, flipped);
  test::LogCatcher log;
  FrameStore store({folder.path("cache")});
  store.setKeys(keysOf(1, 1));
  EXPECT_FALSE(store.get(0));
  EXPECT_EQ(store.state(0), FrameState::Missing);
  ASSERT_TRUE(store.put(withCover(makeFrame(1, 0), 3.0f)));
  FrameStore again({folder.path("cache")});
  again.setKeys(keysOf(1, 1));
  EXPECT_TRUE(again.get(0));
}

TEST(FrameStore, DamagedFilesCountAsMissingAndAreNamed) {
  const test::TemporaryFolder folder;
  {
    FrameStore store({folder.path("cache")});
    store.setKeys(keysOf(1, 3));
    for (int frame = 0; frame < 3; ++frame) ASSERT_TRUE(store.put(makeFrame(1, frame)));
    ASSERT_TRUE(store.putCheckpoint(1, {1, 1}, {'a'}));
    ASSERT_TRUE(store.putCheckpoint(2, {1, 2}, {'b'}));
  }
  const auto frames = filesIn(folder.path("cache/frames"));
  const std::string whole = bytesOf(frames[0]);
  overwrite(frames[0], whole.substr(0, whole.size() / 2));
  std::string flipped = bytesOf(frames[1]);
  flipped.back() ^= 1;
  overwrite(frames[1], flipped);
  const auto checkpoints = filesIn(folder.path("cache/checkpoints"));
  overwrite(checkpoints[1], "");
  test::LogCatcher log;
  FrameStore store({folder.path("cache")});
  store.setKeys(keysOf(1, 3));
  EXPECT_EQ(store.state(0), FrameState::Missing) << "seen from its length";
  EXPECT_FALSE(store.get(1)) << "seen when it is read";
  EXPECT_EQ(store.state(1), FrameState::Missing);
  EXPECT_TRUE(store.get(2));
  EXPECT_EQ(store.latestCheckpoint(2)->frame, 1);
  EXPECT_NE(log.text().find(frames[0]), std::string::npos);
  EXPECT_NE(log.text().find(frames[1]), std::string::npos);
  EXPECT_NE(log.text().find(checkpoints[1]), std::string::npos);
  ASSERT_TRUE(store.put(makeFrame(1, 0)));
  EXPECT_EQ(bytesOf(frames[0]), whole) << "computing it again mends the file";
}

TEST(FrameStore, AFileUnderTheWrongNameIsRefused) {
  const test::TemporaryFolder folder;
  {
    FrameStore store({folder.path("cache")});
    ASSERT_TRUE(store.put(makeFrame(1, 0)));
  }
  const std::string file = filesIn(folder.path("cache/frames"))[0];
  std::string renamed = file;
  renamed.replace(renamed.rfind("000000"), 6, "000001");
  fs::copy_file(file, renamed);
  overwrite(folder.path("cache/frames/000002-junk.frame"), "junk");
  test::LogCatcher log;
  FrameStore store({folder.path("cache")});
  store.setKeys(keysOf(1, 3));
  EXPECT_EQ(store.state(0), FrameState::Ready);
  EXPECT_EQ(store.state(1), FrameState::Missing);
  EXPECT_EQ(store.state(2), FrameState::Missing);
}

TEST(FrameStore, ADamagedLayoutIsWrittenAgain) {
  const test::TemporaryFolder folder;
  {
    FrameStore store({folder.path("cache")});
    ASSERT_TRUE(store.put(withCover(makeFrame(1, 0), 3.0f)));
  }
  const std::string shared = filesIn(folder.path("cache/shared"))[0];
  overwrite(shared, "damaged");
  test::LogCatcher log;
  FrameStore store({folder.path("cache")});
  store.setKeys(keysOf(1, 1));
  EXPECT_EQ(store.state(0), FrameState::Missing);
  ASSERT_TRUE(store.put(withCover(makeFrame(1, 0), 3.0f)));
  FrameStore again({folder.path("cache")});
  again.setKeys(keysOf(1, 1));
  EXPECT_TRUE(again.get(0));
}

TEST(FrameStore, OnlyPurgeDeletesAndOnlyWhatIsStale) {
  const test::TemporaryFolder folder;
  FrameStore store({folder.path("cache")});
  EXPECT_FALSE(store.purgeStale()) << "without keys nothing is known to be stale";
  store.setKeys(keysOf(1, 2));
  ASSERT_TRUE(store.put(withCover(makeFrame(1, 0), 3.0f)));
  ASSERT_TRUE(store.put(withCover(makeFrame(1, 1), 3.0f)));
  ASSERT_TRUE(store.putCheckpoint(1, {1, 1}, {'a'}));
  auto keys = keysOf(1, 2);
  keys[1] = {2, 1};
  store.setKeys(keys);
  ASSERT_TRUE(store.put(withCover(makeFrame(2, 1), 4.0f)));
  EXPECT_EQ(filesIn(folder.path("cache/frames")).size(), 3u);
  EXPECT_GT(store.usage().staleDiskBytes, 0u);
  const auto before = store.usage().diskBytes;
  store.setKeys(keysOf(1, 2));
  ASSERT_TRUE(store.purgeStale());
  EXPECT_EQ(filesIn(folder.path("cache/frames")).size(), 2u);
  EXPECT_EQ(filesIn(folder.path("cache/checkpoints")).size(), 1u);
  EXPECT_EQ(filesIn(folder.path("cache/shared")).size(), 2u)
      << "a layout and an exposure; the layout nobody needs any more is gone";
  EXPECT_EQ(store.usage().staleDiskBytes, 0u);
  EXPECT_LT(store.usage().diskBytes, before);
  EXPECT_TRUE(store.get(0) && store.get(1));
}

TEST(FrameStore, PurgingLeavesWhatAnotherProcessNeeds) {
  const test::TemporaryFolder folder;
  FrameStore ours({folder.path("cache")});
  ours.setKeys(keysOf(1, 5));
  ASSERT_TRUE(ours.put(withCover(makeFrame(1, 0), 3.0f)));
  // Somebody else writes frames that share data which this store has not seen.
  FrameStore theirs({folder.path("cache")});
  theirs.setKeys(keysOf(1, 5));
  ASSERT_TRUE(theirs.put(withCover(makeFrame(1, 3), 4.0f)));
  ASSERT_TRUE(theirs.put(withCover(makeFrame(1, 4), 4.0f)));
  ASSERT_TRUE(ours.purgeStale());
  FrameStore later({folder.path("cache")});
  later.setKeys(keysOf(1, 5));
  EXPECT_TRUE(later.get(0) && later.get(3) && later.get(4));
}

TEST(FrameStore, SharedDataThatWasTakenAwayIsWrittenAgain) {
  const test::TemporaryFolder folder;
  FrameStore store({folder.path("cache")});
  store.setKeys(keysOf(1, 2));
  ASSERT_TRUE(store.put(withCover(makeFrame(1, 0), 3.0f)));
  for (const std::string& file : filesIn(folder.path("cache/shared"))) fs::remove(file);
  ASSERT_TRUE(store.put(withCover(makeFrame(1, 1), 3.0f)));
  FrameStore later({folder.path("cache")});
  later.setKeys(keysOf(1, 2));
  EXPECT_TRUE(later.get(1));
}

TEST(FrameStore, AFolderThatCannotBeUsedIsAnError) {
  const test::TemporaryFolder folder;
  overwrite(folder.path("file"), "in the way");
  test::LogCatcher log;
  FrameStore store({folder.path("file/cache")});
  EXPECT_NE(log.text().find("cannot be used"), std::string::npos);
  const Status put = store.put(makeFrame(1, 0));
  ASSERT_FALSE(put);
  EXPECT_FALSE(put.error().why.empty());
}

TEST(FrameStore, ThreadsMayUseItTogether) {
  const test::TemporaryFolder folder;
  FrameStore store({folder.path("cache"), 20000});
  store.setKeys(keysOf(1, 40));
  std::thread writer([&] {
    for (int frame = 0; frame < 40; ++frame) EXPECT_TRUE(store.put(makeFrame(1, frame, 100)));
  });
  std::thread reader([&] {
    for (int i = 0; i < 400; ++i) {
      const FramePointer frame = store.nearest(i % 40);
      EXPECT_TRUE(!frame || frame->info.key.high == 1u);
    }
  });
  writer.join();
  reader.join();
  for (int frame = 0; frame < 40; ++frame) EXPECT_TRUE(store.get(frame)) << frame;
}

}  // namespace
}  // namespace spin
