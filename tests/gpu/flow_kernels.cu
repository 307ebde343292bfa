// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// The solver's kernels as the CUDA backend launches them, without the rest: spills.py compiles this.
#include "core/sph/body_solve.h"
#include "core/sph/flow_kernels.h"
#include "core/sph/implicit_kernels.h"
#include "core/sph/viscous_kernels.h"
#include "gpu/for_each_kernel.cuh"

namespace spin {

template __global__ void forEachKernel(RowExtentKernel, std::size_t);
template __global__ void forEachKernel(KeyKernel, std::size_t);
template __global__ void forEachKernel(GatherKernel, std::size_t);
template __global__ void forEachKernel(TakeVelocityKernel, std::size_t);
template __global__ void forEachKernel(BinStartKernel, std::size_t);
template __global__ void forEachKernel(PairKernel<DensityPass>, std::size_t);
template __global__ void forEachKernel(PressureKernel, std::size_t);
template __global__ void forEachKernel(PairKernel<ShearPass>, std::size_t);
template __global__ void forEachKernel(PairKernel<PlainForcePass>, std::size_t);
template __global__ void forEachKernel(PairKernel<SmoothForcePass>, std::size_t);
template __global__ void forEachKernel(PairKernel<ContinuityForcePass>, std::size_t);
template __global__ void forEachKernel(PairKernel<SmoothContinuityForcePass>, std::size_t);
template __global__ void forEachKernel(IntegrateKernel, std::size_t);
template __global__ void forEachKernel(PlaceBodyKernel, std::size_t);
template __global__ void forEachKernel(NearBodyKernel, std::size_t);
template __global__ void forEachKernel(BodyDensityKernel, std::size_t);
template __global__ void forEachKernel(BodyRateKernel, std::size_t);
template __global__ void forEachKernel(BodyPressureKernel, std::size_t);
template __global__ void forEachKernel(BodyRubKernel, std::size_t);
template __global__ void forEachKernel(BodyReactionKernel, std::size_t);
template __global__ void forEachKernel(BodyConstraintKernel, std::size_t);
template __global__ void forEachKernel(BodyDivergenceKernel, std::size_t);
template __global__ void forEachKernel(BodySolvePushKernel, std::size_t);
template __global__ void forEachKernel(BodySolveLoadKernel, std::size_t);
template __global__ void forEachKernel(PairKernel<ConstraintPass>, std::size_t);
template __global__ void forEachKernel(PairKernel<DivergencePass>, std::size_t);
template __global__ void forEachKernel(PairKernel<PressurePushPass>, std::size_t);
template __global__ void forEachKernel(PairKernel<ViscousProductPass>, std::size_t);
template __global__ void forEachKernel(PairKernel<StressPass>, std::size_t);
template __global__ void forEachKernel(ConstraintKernel, std::size_t);
template __global__ void forEachKernel(PredictKernel, std::size_t);
template __global__ void forEachKernel(WallEndKernel, std::size_t);
template __global__ void forEachKernel(AdvanceKernel, std::size_t);
template __global__ void forEachKernel(ViscousTurnKernel, std::size_t);

}  // namespace spin
