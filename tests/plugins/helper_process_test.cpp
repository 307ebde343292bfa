// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// The import helper's misbehaviour, played by shell scripts in its place.
#include <signal.h>

#include <array>
#include <chrono>
#include <thread>

#include "tests/plugins/support.h"
#include "tests/support/time_limit.h"

namespace spin {
namespace {

using test::TempFolder;

class HelperProcess : public ::testing::Test {
 protected:
  /// Reads a file with a script as the helper. Descriptor 4 takes the answer.
  Result<TerrainImport> readWith(const std::string& script, ImportLimits limits = {},
                                 const CancelToken& cancel = {}) {
    const std::string program = test::writeBytes(m_folder.file("helper.sh"), "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const test::ScopedEnvironment helper("SPIN_IMPORT_HELPER", program);
    const auto start = std::chrono::steady_clock::now();
    auto result = makeHelperAssetReader(limits)->readTerrain(m_file, {}, cancel);
    m_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
  }

  TempFolder m_folder;
  std::string m_file = test::writeBytes(m_folder.file("dem.tif"), "anything");
  double m_seconds = 0.0;
};

TEST_F(HelperProcess, CrashIsAnErrorThatNamesTheFile) {
  test::expectError(readWith("kill -SEGV $$"), ErrorKind::BadInput, m_file,
                    {"crashed", "Segmentation", "damaged"});
  test::expectError(readWith("kill -ILL $$"), ErrorKind::BadInput, m_file, {"crashed"});
}

TEST_F(HelperProcess, LastWordsBecomeTheReason) {
  test::expectError(readWith("echo 'bad chunk 17' >&2; kill -ABRT $$"), ErrorKind::BadInput, m_file,
                    {"bad chunk 17"});
  test::expectError(readWith("echo 'std::bad_alloc' >&2; kill -ABRT $$"), ErrorKind::OutOfResources, m_file,
                    {"memory", "Reduce"});
}

TEST_F(HelperProcess, HangEndsAtTheTimeLimit) {
  test::expectError(readWith("exec sleep 60", {std::size_t{1} << 30, 0.3}), ErrorKind::OutOfResources, m_file,
                    {"longer than the 0.3 s"});
  EXPECT_LT(m_seconds, 5.0);
  test::expectError(readWith("while :; do :; done", {std::size_t{1} << 30, 0.3}), ErrorKind::OutOfResources,
                    m_file, {"longer"});
  EXPECT_LT(m_seconds, 5.0);
}

TEST_F(HelperProcess, EndlessTalkIsBoundedInTimeAndMemory) {
  const std::size_t before = test::peakMemory();
  test::expectError(readWith("exec yes 1>&2", {std::size_t{1} << 30, 0.5}), ErrorKind::OutOfResources, m_file,
                    {"longer"});
  EXPECT_LT(m_seconds, 5.0);
  EXPECT_LT(test::peakMemory(), before + (std::size_t{16} << 20));
}

TEST_F(HelperProcess, CancelStopsItAtOnce) {
  const CancelToken cancel;
  std::thread user([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    cancel.cancel();
  });
  const auto result = readWith("exec sleep 60", {}, cancel);
  user.join();
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(static_cast<int>(result.error().kind), static_cast<int>(ErrorKind::Cancelled));
  EXPECT_LT(m_seconds, 1.0 * test::patience());
}

TEST_F(HelperProcess, HungerForMemoryIsStopped) {
  const std::size_t before = test::peakMemory();
  test::expectError(readWith("exec tail /dev/zero", {std::size_t{16} << 20, 30.0}), ErrorKind::OutOfResources,
                    m_file, {"16 MiB of memory"});
  EXPECT_LT(test::peakMemory(), before + (std::size_t{16} << 20));
}

TEST_F(HelperProcess, AnswerLargerThanAllowedIsStopped) {
  const std::size_t before = test::peakMemory();
  test::expectError(readWith("exec head -c 200000000 /dev/zero >&4", {std::size_t{16} << 20, 30.0}),
                    ErrorKind::OutOfResources, m_file, {"memory"});
  EXPECT_LT(test::peakMemory(), before + (std::size_t{32} << 20));
}

TEST_F(HelperProcess, GarbageIsNoAnswer) {
  test::expectError(readWith("exit 0"), ErrorKind::Failed, m_file, {"gave no answer"});
  test::expectError(readWith("echo garbage >&4"), ErrorKind::Failed, m_file, {"unusable answer"});
  test::expectError(readWith("cat <&3 >&4"), ErrorKind::Failed, m_file, {"unusable answer"});
  test::expectError(readWith("echo 'no luck' >&2; exit 3"), ErrorKind::Failed, m_file,
                    {"exit code 3", "no luck"});
}

TEST_F(HelperProcess, WhatItStartedDiesWithIt) {
  const std::string note = m_folder.file("pid");
  EXPECT_FALSE(readWith("sleep 60 & echo $! > '" + note + "'; kill -SEGV $$").ok());
  const pid_t orphan = std::stoi(test::readBytes(note));
  // Gone, or dead and not yet collected by the process that inherited it.
  for (int i = 0; i < 40 && kill(orphan, 0) == 0; ++i) {
    const std::string stat = test::readBytes("/proc/" + std::to_string(orphan) + "/stat");
    if (stat.find(") Z ") != std::string::npos) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_NE(kill(orphan, 0), 0);
}

TEST_F(HelperProcess, MissingHelperIsNamed) {
  const test::ScopedEnvironment helper("SPIN_IMPORT_HELPER", "/nonexistent/helper");
  test::expectError(test::readTerrain(m_file), ErrorKind::Failed, "/nonexistent/helper",
                    {"could not be started"});
}

TEST_F(HelperProcess, FilesThatCannotBeReadAreToldBeforeAnythingStarts) {
  const test::ScopedEnvironment helper("SPIN_IMPORT_HELPER", "/nonexistent/helper");
  const std::string missing = m_folder.file("missing.tif");
  test::expectError(test::readTerrain(missing), ErrorKind::BadInput, missing, {"no such file"});
  test::expectError(test::readTerrain(m_folder.path()), ErrorKind::BadInput, m_folder.path(), {"folder"});
  test::expectError(test::readModel("/dev/zero"), ErrorKind::BadInput, "/dev/zero", {"device"});
  const std::string empty = test::writeBytes(m_folder.file("empty.glb"), "");
  test::expectError(test::readModel(empty), ErrorKind::BadInput, empty, {"empty"});
}

TEST_F(HelperProcess, ReadsFromSeveralThreadsAtOnce) {
  std::vector<std::thread> threads;
  std::array<std::string, 4> texts;
  for (std::size_t t = 0; t < texts.size(); ++t)
    threads.emplace_back([&, t] { texts[t] = test::readTerrain(m_file).error().text(); });
  for (std::thread& thread : threads) thread.join();
  for (const std::string& text : texts) EXPECT_NE(text.find(m_file), std::string::npos) << text;
}

TEST(ImportHelper, StartedByHandSaysSo) {
  std::error_code error;
  const auto program =
      std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / "spindrift-import-helper";
  EXPECT_EQ(std::system((program.string() + " 2>/dev/null 3<&- </dev/null").c_str()), 2 << 8);
}

}  // namespace
}  // namespace spin
