// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/cli/cancel_watch.h"

#include <gtest/gtest.h>

namespace spin {
namespace {

using std::chrono::milliseconds;

TEST(CancelWatch, ActsOnlyOnALongCallAfterACancel) {
  const CancelToken cancel;
  CancelWatch watch(cancel);
  std::atomic<int> acted{0};
  {
    const CancelWatch::Section section(&watch, [&] { ++acted; });
    std::this_thread::sleep_for(milliseconds(900));
    EXPECT_EQ(acted, 0) << "nobody cancelled";
  }
  cancel.cancel();
  {
    const CancelWatch::Section section(&watch, [&] { ++acted; });
  }
  std::this_thread::sleep_for(milliseconds(100));
  EXPECT_EQ(acted, 0) << "a short call ends by itself";
  {
    const CancelWatch::Section section(&watch, [&] { ++acted; });
    for (int i = 0; i < 300 && acted == 0; ++i) std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_EQ(acted, 1);
}

TEST(CancelWatch, LeavingTheCallWaitsForTheAction) {
  const CancelToken cancel;
  CancelWatch watch(cancel);
  cancel.cancel();
  std::atomic<bool> began{false}, ended{false};
  {
    const CancelWatch::Section section(&watch, [&] {
      began = true;
      std::this_thread::sleep_for(milliseconds(200));
      ended = true;
    });
    for (int i = 0; i < 300 && !began; ++i) std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_TRUE(ended);
}

}  // namespace
}  // namespace spin
