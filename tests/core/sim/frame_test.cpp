// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/frame.h"

#include <gtest/gtest.h>

#include "tests/core/sim/test_processes.h"

namespace spin {
namespace {

TEST(ByteReader, NeverReadsPastTheEnd) {
  ByteWriter out;
  out.put(std::string("abc"));
  out.putArray(std::vector<double>{1, 2});
  out.put(7);
  const std::vector<char>& bytes = out.bytes();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ByteReader in(bytes.data(), size);
    in.getText();
    in.getArray<double>();
    in.get<int>();
    EXPECT_FALSE(in.ok()) << size;
  }
  ByteReader in(bytes.data(), bytes.size());
  EXPECT_EQ(in.getText(), "abc");
  EXPECT_EQ(in.getArray<double>(), (std::vector<double>{1, 2}));
  EXPECT_EQ(in.get<int>(), 7);
  EXPECT_TRUE(in.ok() && in.atEnd());
}

TEST(ByteReader, RefusesLengthsThatAreNotThere) {
  ByteWriter out;
  out.put(std::uint64_t{1} << 62);
  out.put(1);
  ByteReader text(out.bytes().data(), out.bytes().size());
  EXPECT_TRUE(text.getText().empty());
  EXPECT_FALSE(text.ok());
  ByteReader array(out.bytes().data(), out.bytes().size());
  EXPECT_TRUE(array.getArray<double>().empty());
  EXPECT_FALSE(array.ok());
}

TEST(MassBudget, ImbalanceIsSourcesLessSinks) {
  MassBudget budget;
  EXPECT_EQ(budget.relativeImbalance(), 0.0);
  budget.set("emitted", true, 10.0);
  budget.set("deposited", false, 7.0);
  budget.set("left", false, 2.0);
  EXPECT_DOUBLE_EQ(budget.relativeImbalance(), 0.1);
  budget.set("left", false, 3.0);
  EXPECT_DOUBLE_EQ(budget.relativeImbalance(), 0.0);
  EXPECT_EQ(budget.terms.size(), 3u);
  EXPECT_EQ(budget.get("deposited"), 7.0);
}

std::shared_ptr<CoverPart> smallCover() {
  auto layout = std::make_shared<CoverLayout>();
  layout->grids.push_back(
      {"terrain", "terrain", Raster<float>(2, 2, 0, 0, 5, 1.0f), Raster<float>(2, 2, 0, 0, 5, 25.0f)});
  auto part = std::make_shared<CoverPart>();
  part->layout = internLayout(layout);
  part->exposure = internExposure(std::make_shared<CoverExposure>(CoverExposure{{{1, 0.5f, 0.25f, 1}}}));
  part->values = {{{1, 2, 3, 4}, {.1f, .2f, .3f, .4f}}};
  return part;
}

std::shared_ptr<Frame> smallFrame() {
  auto frame = std::make_shared<Frame>();
  frame->info.time = {3, 0.3, 30.0};
  frame->info.key = {5, 6};
  frame->info.budget.set("emitted", true, 2.0);
  frame->info.figures["sampling_rmse"] = 0.01;
  frame->info.timings.add("cover", 0.25);
  auto flakes = std::make_shared<ParticlePart>();
  flakes->particles.name = "flakes";
  flakes->particles.wrapBox = 8.0;
  flakes->particles.weight = 100.0;
  flakes->particles.ids = {4, 9};
  flakes->particles.positions = {{1, 2, 3}, {4, 5, 6}};
  flakes->particles.attributes = {{"velocity", "m/s", 3, {0, 0, -1, 0, 0, -2}}};
  frame->parts["flakes"] = flakes;
  frame->parts["cover"] = smallCover();
  return frame;
}

TEST(Frame, ComesBackAsItWasSaved) {
  const auto frame = smallFrame();
  ByteWriter out;
  saveFrame(*frame, out);
  ByteReader in(out.bytes().data(), out.bytes().size());
  const auto loaded = loadFrame(in);
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->info.time.frame, 3);
  EXPECT_EQ(loaded->info.key, frame->info.key);
  EXPECT_EQ(loaded->info.timings.seconds("cover"), 0.25);
  const auto* flakes = loaded->part<ParticlePart>("flakes");
  ASSERT_TRUE(flakes);
  EXPECT_EQ(flakes->particles.positions[1], (Vec3f{4, 5, 6}));
  EXPECT_EQ(flakes->particles.find("velocity")->unit, "m/s");
  EXPECT_EQ(test::layoutOf(*loaded), test::layoutOf(*frame)) << "shared again";
  EXPECT_EQ(test::resultOf(loaded), test::resultOf(frame));
}

TEST(Frame, EveryTruncationIsNoticed) {
  const auto frame = smallFrame();
  ByteWriter out;
  saveFrame(*frame, out);
  for (std::size_t size = 0; size < out.bytes().size(); ++size) {
    ByteReader in(out.bytes().data(), size);
    EXPECT_FALSE(loadFrame(in)) << size;
  }
}

TEST(Frame, CoverWithoutItsLayoutIsNoFrame) {
  ByteWriter out;
  saveFrame(*smallFrame(), out);  // the layout dies with the frame
  ByteReader in(out.bytes().data(), out.bytes().size());
  EXPECT_FALSE(loadFrame(in));
}

TEST(Frame, EqualLayoutsAndExposuresAreOneInMemory) {
  const auto first = smallCover(), second = smallCover();
  EXPECT_EQ(first->layout, second->layout);
  EXPECT_EQ(first->exposure, second->exposure);
  const std::vector<Hash128> keys = first->sharedKeys();
  ASSERT_EQ(keys.size(), 2u);
  const std::shared_ptr<const void> expected[] = {first->layout, first->exposure};
  for (std::size_t k = 0; k < keys.size(); ++k) {
    ByteWriter out;
    first->saveShared(keys[k], out);
    ByteReader in(out.bytes().data(), out.bytes().size());
    EXPECT_EQ(loadShared(CoverPart::kKind, in), expected[k]);
  }
}

TEST(Frame, ExposureOfAnotherShapeIsNoFrame) {
  auto cover = smallCover();
  cover->exposure = internExposure(std::make_shared<CoverExposure>(CoverExposure{{{1, 1, 1}}}));
  ByteWriter out;
  cover->save(out);
  ByteReader in(out.bytes().data(), out.bytes().size());
  EXPECT_FALSE(CoverPart::load(in));
}

TEST(FramePart, NonFiniteValuesAreNamed) {
  auto cover = smallCover();
  EXPECT_EQ(cover->firstNonFinite(), "");
  cover->values[0].depth[2] = std::nanf("");
  EXPECT_EQ(cover->firstNonFinite(), "depth of grid terrain, cell 2 is nan");
  cover->values[0].depth[2] = 1.0f;
  cover->exposure = std::make_shared<CoverExposure>(CoverExposure{{{1, NAN, 1, 1}}});
  EXPECT_EQ(cover->firstNonFinite(), "exposure of grid terrain, cell 1 is nan");
  ParticlePart flakes;
  flakes.particles.positions = {{0, 0, 0}, {0, INFINITY, 0}};
  EXPECT_EQ(flakes.firstNonFinite(), "position of particle 1 is (0, inf, 0)");
  flakes.particles.positions[1].y = 0;
  flakes.particles.attributes = {{"velocity", "m/s", 3, {0, 0, 0, 0, NAN, 0}}};
  EXPECT_EQ(flakes.firstNonFinite(), "velocity of particle 1 is nan");
}

TEST(FramePart, ValuesOfCellsWithoutSurfaceMayBeAnything) {
  auto layout = std::make_shared<CoverLayout>();
  layout->grids.push_back({"t", "t", Raster<float>(1, 1, 0, 0, 1, NAN), Raster<float>(1, 1, 0, 0, 1, 0.0f)});
  CoverPart cover;
  cover.layout = layout;
  cover.exposure = std::make_shared<CoverExposure>(CoverExposure{{{NAN}}});
  cover.values = {{{NAN}, {NAN}}};
  EXPECT_EQ(cover.firstNonFinite(), "");
}

}  // namespace
}  // namespace spin
