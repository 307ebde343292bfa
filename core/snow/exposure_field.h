// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/cancel.h"
#include "core/base/parallel.h"
#include "core/physics/slope_hold.h"
#include "core/sim/process.h"
#include "core/snow/sky_change.h"
#include "core/snow/snow_scene.h"
#include "core/snow/snow_weather.h"

namespace spin {

/// What the exposure depends on besides geometry.
struct ExposureSettings {
  FallCone cone;
  int rays = 64;          ///< per cell, >= 1
  int mapDirections = 0;  ///< occlusion maps for the terrain and each patch; 0 = rays
  int mapSize = 1024;     ///< texels along a map at most
  SlopeHold hold;
  double noise = 0.0;  ///< amplitude of the cover's unevenness, 0..1
  std::uint64_t seed = 1;

  friend bool operator==(const ExposureSettings&, const ExposureSettings&) = default;
};

/// Where the snow of one set of fall directions goes, per precipitation rate: kg/s per kg/(m2 s), that is m2.
struct SinkRates {
  double ground = 0.0;  ///< on the terrain
  double models = 0.0;
  double left = 0.0;  ///< out of the domain: downwind, through holes and past the terrain's edge
  double total() const { return ground + models + left; }
};

/// Two independent estimates of the same flows. Gathered: every surface looks towards the sky; it rules the
/// cover. Forward: packets from the domain's faces, each ends in one sink; it checks.
struct SnowRates {
  double emitted = 0.0;    ///< through the faces where snow comes in, by area and direction, without rays
  double deposited = 0.0;  ///< gathered, stays where it arrives
  double shed = 0.0;       ///< gathered, arrives where it does not stay
  double left = 0.0;       ///< gathered
  SinkRates gathered, forward;
  double lost = 0.0;  ///< forward packets that ended inside the ground: 0 unless the geometry leaks

  /// Forward less gathered, summed over the sinks.
  double residual() const { return forward.total() - gathered.total(); }
};

/// How open the cover's cells lie to snow that falls in one set of directions.
struct ExposureField {
  struct Values {
    std::vector<float> exposure;  ///< share of the rays that see the sky, 0..1
    std::vector<float> held;      ///< deposit per precipitation rate and horizontal area, with noise
  };
  std::vector<Values> grids;  ///< by the layout's grids
  SnowRates rates;
  double airVolume = 0.0;  ///< m3
  std::optional<double>
      samplingRmse;  ///< of the exposure, by the two halves of each cell's rays; none for one ray
  FallCone cone;
};

/// Threads, cancel and progress of a long computation.
struct Workshop {
  CpuBackend& backend;
  const CancelToken& cancel;
  std::function<void(double)> progress;  ///< fraction 0..1, called from the calling thread; may be empty
  MapRasterFactory makeMapRaster = {};
};

/// What the cells of a cover found when they asked the sky, before smoothing and noise.
struct GatheredCover {
  struct Cells {
    std::vector<float> exposure, held;  ///< as in ExposureField::Values
    std::vector<float> shed;            ///< like held: what arrives and does not stay
    std::vector<float> halves;          ///< half the difference of two halves of the rays; NaN: no cell
    bool asked = false;                 ///< some of them, the last time
  };
  std::vector<Cells> grids;  ///< by the layout's grids
};

/// What outlives one exposure field: where a model moves, only cells that see it are asked again.
struct ExposureMemory {
  struct Standing {
    ExposureSettings settings;
    Box3d domain;
    std::vector<StandingModel> models;
  };
  std::optional<Standing> standing;  ///< that `gathered` is of; none: ask all
  GatheredCover gathered;
  std::vector<std::vector<float>> smooth;  ///< deposit of the fine grids without the land's facets, by grid
  std::vector<std::vector<float>> uneven;  ///< 1 + noise, by grid
};

/// Casts the rays. Deterministic whatever the thread count; with a memory of the same run's ground the same
/// as without. Fails only with ErrorKind::Cancelled.
Result<ExposureField> makeExposureField(const SceneSnapshot& snapshot, const SnowGround& ground,
                                        const SnowScene& scene, const ExposureSettings& settings,
                                        const Workshop& workshop, ExposureMemory* memory = nullptr);

/// Asks the cells that the change reaches. Half done when cancelled.
Status gatherCover(const SceneSnapshot& snapshot, const SnowGround& ground, const SnowScene& scene,
                   const ExposureSettings& settings, const SkyChange& change, const Workshop& workshop,
                   GatheredCover& cover);
/// Fills the gathered deposit, shed, ground and models (patches only), and the sampling error.
void sumGathered(const SnowGround& ground, const GatheredCover& cover, int rays, const Workshop& workshop,
                 ExposureField& field);
/// Fills the rest of the rates: emission, forward packets, what leaves, what bare model surfaces shed.
Status estimateRates(const SceneSnapshot& snapshot, const SnowGround& ground, const SnowScene& scene,
                     const ExposureSettings& settings, const Workshop& workshop, SnowRates& rates);

/// Takes the facets of the elevation model out of the fine grids' deposit: at their size a facet of the
/// triangulation is no feature of the ground. The mass on each grid stays. Only grids that were asked the
/// last time.
void smoothFacets(const SceneSnapshot& snapshot, const SnowGround& ground, const ExposureSettings& settings,
                  const Workshop& workshop, ExposureMemory& memory);

/// ErrorKind::Cancelled.
Error cancelledError();

}  // namespace spin
