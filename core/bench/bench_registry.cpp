// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/bench_case.h"

namespace spin {

// Each case is one file of this folder that defines its function, such as `BenchCase massCase();`, declared
// here and called once in the list below.
BenchCase terminalSpeedCase();
BenchCase sizeSpectrumCase();
BenchCase flakeDimensionCase();
BenchCase flutterCase();
BenchCase exposureEdgeCase();
BenchCase exposureRaytracedCase();
BenchCase exposureMapCase();
BenchCase slopeCatchCase();
BenchCase massCase();
BenchCase windShadowCase();
BenchCase panCase();
BenchCase reposeCase();
BenchCase driftMassCase();
BenchCase windHillCase();
BenchCase sphSpeedCase();
BenchCase sphParityCase();
BenchCase kernelSumsCase();
BenchCase damBreakCase();
BenchCase filmBinghamCase();
BenchCase filmCrossCase();
BenchCase slumpCase();
BenchCase granularColumnCase();
BenchCase inclineSlipCase();
BenchCase penetrationCase();
BenchCase conservationCase();
BenchCase taylorGreenSphCase();
BenchCase sphWorkPrecisionCase();
BenchCase hydrostaticCase();
BenchCase buoyancyCase();
BenchCase poiseuilleCase();
BenchCase couetteCase();
BenchCase channelPowerCase();
BenchCase channelBinghamCase();
BenchCase channelHerschelCase();
BenchCase channelCrossCase();
BenchCase twoFluidsStepCase();
BenchCase meltFixedFluxCase();
BenchCase conductionStepCase();
BenchCase degreeDayCase();
BenchCase seasonCase();
BenchCase snowSpeedCase();
BenchCase flakeSpeedCase();
BenchCase projectionCase();
BenchCase pressureSolversCase();
BenchCase taylorGreenCase();
BenchCase lidCavityCase();
BenchCase zalesakCase();
BenchCase deformation3dCase();
BenchCase diffusionCase();
BenchCase bubbleCase();
BenchCase plumeCase();
BenchCase mistMassCase();
BenchCase airSpeedCase();
BenchCase airWorkPrecisionCase();

const std::vector<BenchCase>& builtInBenchCases() {
  static const std::vector<BenchCase> cases = {
      terminalSpeedCase(),
      sizeSpectrumCase(),
      flakeDimensionCase(),
      flutterCase(),
      exposureEdgeCase(),
      exposureRaytracedCase(),
      exposureMapCase(),
      slopeCatchCase(),
      massCase(),
      windShadowCase(),
      reposeCase(),
      driftMassCase(),
      panCase(),
      windHillCase(),
      meltFixedFluxCase(),
      conductionStepCase(),
      degreeDayCase(),
      seasonCase(),
      snowSpeedCase(),
      flakeSpeedCase(),
      sphSpeedCase(),
      hydrostaticCase(),
      poiseuilleCase(),
      couetteCase(),
      channelPowerCase(),
      channelBinghamCase(),
      channelHerschelCase(),
      channelCrossCase(),
      kernelSumsCase(),
      damBreakCase(),
      filmBinghamCase(),
      filmCrossCase(),
      slumpCase(),
      granularColumnCase(),
      inclineSlipCase(),
      penetrationCase(),
      conservationCase(),
      taylorGreenSphCase(),
      sphWorkPrecisionCase(),
      buoyancyCase(),
      sphParityCase(),
      twoFluidsStepCase(),
      projectionCase(),
      pressureSolversCase(),
      taylorGreenCase(),
      lidCavityCase(),
      zalesakCase(),
      deformation3dCase(),
      diffusionCase(),
      bubbleCase(),
      plumeCase(),
      mistMassCase(),
      airSpeedCase(),
      airWorkPrecisionCase(),
  };
  return cases;
}

}  // namespace spin
