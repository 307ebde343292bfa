// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/sph/body_solve.h"
#include "core/sph/flow_world.h"

namespace spin {

/// Rigid bodies in the flow: boundary particles placed and sorted each step where the flow is, what they do
/// to flow particles, and what those do to the bodies, which then move. Without bodies nothing is launched
/// and nothing is stored.
template <class Backend>
class FlowBodies {
 public:
  void init(Backend& backend, const FlowConfig& config) {
    if (config.bodies.empty()) return;
    m_world = makeFlowWorld(config).value();
    m_origin = config.domainMin;
    m_volume = config.spacing * config.spacing * config.spacing;
    m_gravity = config.gravity;
    for (const RigidBodyConfig& body : m_world.bodies())
      if (!body.kinematic) m_mobility = std::max(m_mobility, mobilityOf(body));
    const double h = config.support();
    m_view.viscousFactor = static_cast<float>(m_volume * CubicSpline::kNorm / (h * h * h * h * h));
    BodyPoints points = makeBodyPoints(config);
    backend.upload(points.points, m_points);
    backend.upload(points.chunks, m_chunks);
    backend.upload(points.surfaces, m_surfaces);
    m_chunkBodies = points.chunks;
    m_hostPoints = std::move(points.points);
    const std::size_t n = m_hostPoints.size();
    for (auto* array : {&m_placedX, &m_placedY, &m_placedZ, &m_x, &m_y, &m_z})
      array->resize(n + kPairPadding);
    m_extra.resize(n);
    m_key.resize(n);
    m_sortedKey.resize(n + kPairPadding);
    m_record.resize(n);
    m_load.resize(n);
    m_chunkSums.resize(m_chunkBodies.size());
  }
  bool any() const { return m_points.size() > 0; }
  RigidWorld& world() { return m_world; }
  const RigidWorld& world() const { return m_world; }

  /// Where boundary particles are now, world m.
  std::vector<Vec3d> boundary() const {
    std::vector<Vec3d> places;
    for (const BodyPoint& p : m_hostPoints)
      places.push_back(m_world.states()[p.body].toWorld(Vec3f{p.x, p.y, p.z}.to<double>()));
    return places;
  }

  /// Places boundary particles and lists the flow particles near them. The flow is sorted.
  void place(Backend& backend, const FlowView& flow) {
    m_listed = 0;
    m_view.grid.count = 0;
    if (!any()) return;
    backend.upload(bodyPoses(m_world.states(), flow, m_origin), m_poses);
    const BodyPlaces places{m_placedX.data(), m_placedY.data(), m_placedZ.data(), m_extra.data()};
    const std::size_t n = m_points.size();
    backend.forEach("bodies", n, PlaceBodyKernel{flow, m_points.data(), m_poses.data(), places});
    const FlowBounds bounds = backend.reduce("bodies", n, noBounds(), BodyBoundsOf{places}, JoinBounds{});
    if (bounds.alive == 0) return;
    sort(backend, flow, bounds);
    list(backend, flow);
  }
  /// Adds to the bare density sums.
  void density(Backend& backend, const FlowView& flow) {
    if (m_listed > 0) backend.forEach("bodies", m_listed, BodyDensityKernel{flow, m_view});
  }
  /// Adds to the density's rates.
  void rate(Backend& backend, const FlowView& flow) {
    if (m_listed > 0) backend.forEach("bodies", m_listed, BodyRateKernel{flow, m_view});
  }
  /// Adds the pressure's acceleration; pressures are known.
  void pressure(Backend& backend, const FlowView& flow) {
    if (m_listed > 0) backend.forEach("bodies", m_listed, BodyPressureKernel{flow, m_view});
  }
  /// Adds what surfaces do along themselves; the step is known.
  void rub(Backend& backend, const FlowView& flow, double kick) {
    if (m_listed > 0)
      backend.forEach("bodies", m_listed, BodyRubKernel{flow, m_view, static_cast<float>(kick)});
  }
  /// Moves the bodies under what the flow does to them with its pressures and velocities of before the step,
  /// and everything else.
  Status move(double seconds, const std::vector<RigidImpulse>& impulses) {
    return any() ? m_world.step(seconds, impulses) : Status();
  }
  /// Impulses of the flow on the bodies over `kick` seconds; `solved` after an implicit pressure.
  std::vector<RigidImpulse> reaction(Backend& backend, const FlowView& flow, double kick, bool solved) {
    std::vector<RigidImpulse> impulses(m_world.bodies().size());
    if (m_listed == 0) return impulses;
    backend.forEach("bodies", m_points.size(), ClearLoadKernel{m_load.data()});
    backend.forEach("bodies", m_view.grid.count,
                    BodyReactionKernel{flow, m_view, m_load.data(), m_volume, solved});
    return summedLoads(backend, kick);
  }

  /// Adds to the sums that the implicit pressure is solved from.
  void constraint(Backend& backend, const FlowView& flow) {
    if (flow.bodyRate) backend.forEach("bodies", flow.count, ClearBodyRateKernel{flow});
    if (m_listed == 0) return;
    backend.forEach("bodies", m_listed, BodyConstraintKernel{flow, m_view});
    if (m_mobility == 0.0) return;
    const double sum = backend.reduce("bodies", m_listed, 0.0, BodyGradientOf{m_view}, AddNumbers{});
    backend.forEach("bodies", m_listed,
                    BodyMobilityKernel{flow, m_view, static_cast<float>(m_volume * sum * m_mobility)});
  }
  /// Before a solve of `seconds`: free bodies take the velocities that all known forces give them.
  void beginSolve(Backend& backend, const FlowView& flow, double seconds) {
    if (m_listed == 0) return;
    m_guess = m_world.states();
    m_free = m_world.freeBodies(seconds);
    for (std::size_t k = 0; k < m_guess.size(); ++k)
      if (m_free[k]) m_guess[k].velocity += m_gravity * seconds;
    follow(backend, flow, reaction(backend, flow, seconds, false));
  }
  /// Rates of the excess, before each iterate.
  void divergence(Backend& backend, const FlowView& flow) {
    if (m_listed > 0) backend.forEach("bodies", m_listed, BodyDivergenceKernel{flow, m_view});
  }
  /// An iterate's push on flow and bodies.
  void push(Backend& backend, const FlowView& flow) {
    if (m_listed == 0) return;
    backend.forEach("bodies", m_listed, BodySolvePushKernel{flow, m_view});
    if (std::find(m_free.begin(), m_free.end(), true) == m_free.end()) return;
    backend.forEach("bodies", m_points.size(), ClearLoadKernel{m_load.data()});
    backend.forEach("bodies", m_view.grid.count, BodySolveLoadKernel{flow, m_view, m_load.data(), m_volume});
    follow(backend, flow, summedLoads(backend, static_cast<double>(flow.pressureSolve.timeStep)));
  }
  /// Force on the flow by all that bodies gave its particles in this step, N.
  Vec3d given(Backend& backend, const FlowView& flow) {
    if (m_listed == 0) return {};
    const ImpulseSum sum = backend.reduce("impulse", m_listed, ImpulseSum{0, 0, 0},
                                          BodyGiftOf{flow, m_view, m_volume}, AddImpulse{});
    return {sum.x, sum.y, sum.z};
  }

  std::size_t bytes() const {
    const auto of = [](const auto&... array) {
      return (std::size_t{0} + ... + (array.size() * sizeof(*array.data())));
    };
    return of(m_points, m_chunks, m_surfaces, m_poses, m_placedX, m_placedY, m_placedZ, m_x, m_y, m_z) +
           of(m_extra, m_key, m_sortedKey, m_order, m_rowBins, m_binStart, m_rows, m_record) +
           of(m_slot, m_list, m_rub, m_gift, m_load, m_chunkSums);
  }

 private:
  template <class T>
  using Array = typename Backend::template Array<T>;

  /// The most that a unit of force on the surface accelerates the surface by, 1/kg: the trace bounds the
  /// largest moment of the inverse inertia.
  static double mobilityOf(const RigidBodyConfig& body) {
    const SymmetricMatrix& inverse = body.shape->inverseInertia;
    const double radius = body.shape->radius;
    return 1.0 / body.mass() + radius * radius * (inverse.xx + inverse.yy + inverse.zz) / body.density;
  }

  /// Impulses by the loads of boundary particles over `seconds`.
  std::vector<RigidImpulse> summedLoads(Backend& backend, double seconds) {
    std::vector<RigidImpulse> impulses(m_world.bodies().size());
    backend.forEach("bodies", m_chunks.size(),
                    SumLoadKernel{m_load.data(), m_chunks.data(), m_chunkSums.data()});
    std::vector<BodyLoad> sums;
    backend.download(m_chunkSums, sums);
    for (std::size_t c = 0; c < sums.size(); ++c) {
      RigidImpulse& to = impulses[m_chunkBodies[c].body];
      to.linear += Vec3d{sums[c].fx, sums[c].fy, sums[c].fz} * seconds;
      to.angular += Vec3d{sums[c].tx, sums[c].ty, sums[c].tz} * seconds;
    }
    return impulses;
  }

  /// Lets the guessed velocities of free bodies take impulses, and boundary particles those velocities.
  void follow(Backend& backend, const FlowView& flow, const std::vector<RigidImpulse>& impulses) {
    for (std::size_t k = 0; k < m_guess.size(); ++k) {
      if (!m_free[k]) continue;
      const RigidBodyConfig& body = m_world.bodies()[k];
      m_guess[k].velocity += impulses[k].linear / body.mass();
      m_guess[k].angularVelocity += spinOf(body, m_guess[k].orientation, impulses[k].angular);
    }
    backend.upload(bodyPoses(m_guess, flow, m_origin), m_poses);
    backend.forEach("bodies", m_view.grid.count,
                    BodyVelocityKernel{m_record.data(), m_points.data(), m_poses.data()});
  }

  /// Rows and bins of the boundary particles near the flow.
  void sort(Backend& backend, const FlowView& flow, const FlowBounds& bounds) {
    const std::size_t n = m_points.size();
    FlowView& v = m_view.grid;
    v.grid = flow.grid;
    v.grid.morton = false;
    v.grid.lowY = bounds.lowY, v.grid.cellsY = bounds.highY - bounds.lowY + 1;
    v.grid.lowZ = bounds.lowZ, v.grid.cellsZ = bounds.highZ - bounds.lowZ + 1;
    const auto rows = static_cast<std::size_t>(v.grid.rows());
    if (m_rows.size() < rows) m_rows.resize(rows), m_rowBins.resize(rows);
    v.x = m_placedX.data(), v.y = m_placedY.data(), v.z = m_placedZ.data();
    v.extra = m_extra.data();
    v.key = m_key.data();
    v.rows = m_rows.data();
    backend.forEach("bodies", rows, ClearRowKernel{v});
    backend.forEach("bodies", n, RowExtentKernel{v});
    backend.forEach("bodies", rows, RowBinsKernel{v, m_rowBins.data()});
    const std::uint64_t bins = backend.exclusiveScan("bodies", m_rowBins.data(), m_rowBins.data(), rows);
    backend.forEach("bodies", rows, RowStartKernel{v, m_rowBins.data()});
    if (m_binStart.size() < bins + 2) m_binStart.resize(bins + bins / 8 + 2);
    v.binStart = m_binStart.data();
    const auto count = static_cast<std::uint32_t>(bins);
    backend.forEach("bodies", n, KeyKernel{v, count});
    backend.sortByKey("bodies", m_key, count + 1, m_order);
    const BodyPlaces places{m_placedX.data(), m_placedY.data(), m_placedZ.data(), m_extra.data()};
    backend.forEach("bodies", bounds.alive,
                    GatherBodyKernel{places, m_order.data(), m_key.data(), m_points.data(), m_poses.data(),
                                     m_surfaces.data(), m_x.data(), m_y.data(), m_z.data(),
                                     m_sortedKey.data(), m_record.data()});
    v.count = bounds.alive;
    v.x = m_x.data(), v.y = m_y.data(), v.z = m_z.data();
    v.key = m_sortedKey.data();
    backend.forEach("bodies", static_cast<std::size_t>(bounds.alive) + 1, BinStartKernel{v, count});
  }

  void list(Backend& backend, const FlowView& flow) {
    const std::size_t n = flow.count;
    if (m_slot.size() < n) m_slot.resize(n);
    m_view.record = m_record.data();
    backend.forEach("bodies", n, NearBodyKernel{flow, m_view.grid, m_slot.data()});
    m_listed = backend.exclusiveScan("bodies", m_slot.data(), m_slot.data(), n);
    if (m_list.size() < m_listed) {
      m_list.resize(m_listed + m_listed / 8);
      m_rub.resize(m_list.size());
      m_gift.resize(m_list.size());
    }
    backend.forEach("bodies", n,
                    ListNearKernel{m_slot.data(), static_cast<std::uint32_t>(n),
                                   static_cast<std::uint32_t>(m_listed), m_list.data()});
    m_view.list = m_list.data();
    m_view.slot = m_slot.data();
    m_view.rub = m_rub.data();
    m_view.gift = m_gift.data();
  }

  RigidWorld m_world;
  Vec3d m_origin{};
  Vec3d m_gravity{};
  double m_volume = 0.0;
  double m_mobility = 0.0;          ///< of the most mobile body that is not kinematic, 1/kg; 0 without one
  std::vector<RigidState> m_guess;  ///< while pressure is solved for
  std::vector<bool> m_free;         ///< bodies that follow it
  BodyView m_view;
  std::uint64_t m_listed = 0;
  std::vector<BodyChunk> m_chunkBodies;
  std::vector<BodyPoint> m_hostPoints;
  Array<BodyPoint> m_points;
  Array<BodyChunk> m_chunks;
  Array<std::uint8_t> m_surfaces;
  Array<BodyPose> m_poses;
  Array<std::int32_t> m_placedX, m_placedY, m_placedZ, m_x, m_y, m_z;
  Array<ParticleExtra> m_extra;
  Array<std::uint32_t> m_key, m_sortedKey, m_order, m_rowBins, m_binStart, m_slot, m_list;
  Array<FlowRow> m_rows;
  Array<BodyRecord> m_record;
  Array<BodyRub> m_rub;
  Array<BodyGift> m_gift;
  Array<BodyLoad> m_load, m_chunkSums;
};

}  // namespace spin
