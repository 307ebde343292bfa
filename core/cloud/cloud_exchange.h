// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/air/air_solver.h"
#include "core/cloud/air_contact.h"
#include "core/cloud/cloud_solids.h"
#include "core/cloud/cloud_state.h"
#include "core/cloud/flow_cells.h"
#include "core/cloud/flow_velocities.h"
#include "core/cloud/surrounding_air.h"
#include "core/flow/flow_frame.h"
#include "core/nodes/air_nodes.h"

namespace spin {

/// What one part of a frame is about.
struct CloudPart {
  const AirNode& settings;
  double from = 0.0, to = 0.0;  ///< s of film
  std::int64_t seed = 0;
  AirSolver& air;
  Vec3d airOrigin{};  ///< m, of its cells
  double cell = 1.0;  ///< m, of the air
  const SurroundingAir& surrounding;
  const CloudSolids& solids;
  Box3d box;                                       ///< of the air
  const FlowConfig& config;                        ///< of the flow
  FlowSolver* flow = nullptr;                      ///< null: it stands still
  std::vector<FlowParticle>* rejoining = nullptr;  ///< as flow
  SnowFallout* cover = nullptr;                    ///< null: none takes what settles
  const FlowVelocities* before = nullptr;          ///< when this part began; null: impacts are not seen

  double seconds() const { return to - from; }
};

/// Whether a material is snow for the air: powder, not mist.
bool isSnow(const FlowMaterialConfig& material);

/// Flow, spray and air over one part of a frame, after the flow has gone through it (splitting of first
/// order). What one gives another gets: masses in whole kGivenUnit, impulses as velocities' changes say.
class CloudExchange {
 public:
  CloudExchange(const CloudPart& part, CloudState& state);
  Result<AirStep> run();
  /// Particles that were to flow again and found no place, and snow that found no cover: they stay where they
  /// are.
  void takeBack(const std::vector<FlowParticle>& refused);

 private:
  /// A particle of the flow that the air has to do with.
  struct Touched {
    std::size_t sample = 0;
    Vec3d wind{};          ///< m/s
    Vec3d velocity{};      ///< m/s, as it becomes
    double stopped = 0.0;  ///< m/s that other things than weight changed its velocity by in this part
    std::int64_t given = 0;
    bool taken = false;
    FlowClass kind = FlowClass::Main;
    bool free = false;  ///< alone, and off the ground: drops rather than a lump
  };

  void look();
  double changeOf(const FlowSample& sample) const;
  bool isImpact(double change) const {
    return change > m_part.settings.impactAcceleration * m_part.seconds();
  }
  void giveMist();
  void giveMist(Touched& t);
  void leaveFlow();
  void throwUp();
  void throwUp(Touched& t, double rate);
  double birthRate(const Touched& t, const std::vector<Vec3d>& normals) const;
  Status drag();
  double dragRate(const Touched& t) const;
  void tear(SprayParcel& parcel, double speed) const;
  Status warm();
  void contactsOfFlow(std::vector<WaterContact>& contacts, std::vector<Touched*>& touched);
  void contactsOfSpray(std::vector<WaterContact>& contacts, std::vector<SprayParcel*>& parcels);
  void fray();
  Status handOver();
  void fly();
  void land(const SprayParcel& parcel, Vec3d hit);
  void flowOn(const SprayParcel& parcel, Vec3d velocity, std::int64_t least);
  void rejoin(const SprayParcel& parcel, Vec3d velocity);
  bool absorb(const SprayParcel& parcel);
  void takeDeposits();
  void lie(Vec3d position, double kilograms, bool snow, double density);

  const FlowSample& sampleOf(const Touched& t) const { return m_samples[t.sample]; }
  const FlowMaterialConfig& materialOf(std::size_t k) const { return m_part.config.materials[k]; }
  /// kg of units of a particle of a material.
  double kilograms(std::int64_t units, std::size_t material) const {
    return static_cast<double>(units) * kGivenUnit * m_part.config.particleMass(material);
  }
  double leftOf(const Touched& t) const;
  double massOf(const SprayParcel& p) const { return kilograms(p.units, p.material); }
  /// Drops that the air leaves whole at a speed, m.
  double dropOf(std::size_t material, double speed) const;
  /// What leaves the flow as one, m.
  double lumpOf(std::size_t material) const;
  bool mayMake(std::size_t parcels);
  void makeParcel(Vec3d position, Vec3d velocity, std::int64_t units, std::size_t material, double diameter);
  void addSource(Vec3d position, std::int64_t units, std::size_t material, Vec3d impulse);

  const CloudPart& m_part;
  CloudState& m_state;
  std::vector<FlowSample> m_samples;
  std::optional<FlowCells> m_cells;  ///< of the samples
  std::vector<Touched> m_touched;
  std::vector<std::size_t> m_touchedOf;  ///< by sample; SIZE_MAX where it is not touched
  std::vector<AirSource> m_sources;
  std::vector<WaterContact> m_mixing;  ///< water that goes into the air with its heat
};

}  // namespace spin
