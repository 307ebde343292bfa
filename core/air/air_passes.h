// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/air/eddy_passes.h"
#include "core/air/pressure_passes.h"
#include "core/air/scalar_passes.h"
#include "core/air/velocity_passes.h"
#include "core/air/weight_passes.h"

// Every pass over bricks; each instruction set's file makes its loop of each of them.
// The formatter never settles on a form for this list.
// clang-format off
#define SPIN_AIR_AXES(X, Pass) X(Pass<0>) X(Pass<1>) X(Pass<2>)
#define SPIN_AIR_PASSES(X)                                                                       \
  X(CoefficientPass) X(DiagonalPass) X(CoarsenPass) X(AirDivergencePass) X(ResidualPass)         \
  X(FirstSmoothPass) X(SmoothPass) X(ColourPass) X(RestrictPass) X(ProlongPass)                  \
  X(DirectionPass) X(ProductPass) X(AdvancePass) X(CorrectPass) X(ReflectPass)                   \
  X(CopyPass) X(CopyOnePass) X(FastestPass) X(OutflowPass) X(DepositPass)                        \
  X(ContentPass) X(LargestPass) X(ActivityPass) X(LoadPass) X(BuoyancyPass) X(CondensePass)      \
  X(StrainPass) SPIN_AIR_AXES(X, EddyMixPass)                                                    \
  SPIN_AIR_AXES(X, CarryPass) SPIN_AIR_AXES(X, CarryBackPass) SPIN_AIR_AXES(X, CarryCubicPass)   \
  SPIN_AIR_AXES(X, GhostPass) SPIN_AIR_AXES(X, DiffuseProductPass)                               \
  SPIN_AIR_AXES(X, DiffuseResidualPass) SPIN_AIR_AXES(X, NormPass) SPIN_AIR_AXES(X, SweepPass)
// clang-format on
