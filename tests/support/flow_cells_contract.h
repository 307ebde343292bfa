// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/flow_contract.h"

/// How particles lie in memory must not change what they do. Instantiate like FlowContract.
namespace spin::contract {

template <class Traits>
class FlowCellsContract : public FlowContract<Traits> {};
TYPED_TEST_SUITE_P(FlowCellsContract);

TYPED_TEST_P(FlowCellsContract, RowsInMortonOrderGiveTheSameSums) {
  // 11 x 13 rows of cells: no whole tiles.
  FlowConfig c = testing::freeConfig(20, 22, 26);
  c.periodic[0] = c.periodic[1] = false;
  auto particles = testing::lattice(c, 20, 22, 22, 0.2);
  testing::stir(particles, 0.5);
  const Solver linear = this->start(c, particles);
  c.cellOrder = CellOrder::Morton;
  const Solver morton = this->start(c, particles);
  this->run(*linear, kNow, 1);
  this->run(*morton, kNow, 1);
  auto a = linear->samples(), b = morton->samples();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].density, b[i].density) << i;
    ASSERT_EQ(a[i].pairAcceleration, b[i].pairAcceleration) << i;
  }
  // Later, what arrives in a bin comes in another order, and sums round otherwise.
  this->runFor(*linear, 0.02);
  this->runFor(*morton, 0.02);
  a = linear->samples(), b = morton->samples();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_LT(length(a[i].particle.position - b[i].particle.position), 1e-3 * c.spacing) << i;
}

REGISTER_TYPED_TEST_SUITE_P(FlowCellsContract, RowsInMortonOrderGiveTheSameSums);

}  // namespace spin::contract
