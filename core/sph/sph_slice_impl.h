// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/sph/slice_kernels.h"
#include "core/sph/slice_setup.h"
#include "core/sph/sph_slice.h"

namespace spin {

/// How a backend arranges the two pair passes. The general form gives every particle a thread; the processor
/// has its own in sph_slice_cpu.cpp.
template <class Backend>
struct PairStages {
  void density(Backend& backend, const SliceView& view) {
    backend.forEach("density", view.count, DensityPairKernel{view});
  }
  void force(Backend& backend, const SliceView& view) {
    backend.forEach("force", view.count, ForcePairKernel{view});
  }
};

template <class Backend>
class SphSlice final : public SphSliceSolver {
 public:
  SphSlice(const SphSliceConfig& config, Backend backend, PairStages<Backend> pairs)
      : m_config(config), m_backend(std::move(backend)), m_pairs(pairs) {
    m_view.grid = sliceGrid(config);
    m_view.constants = sliceConstants(config);
  }

  Status setParticles(const std::vector<Vec3d>& positions, const std::vector<Vec3d>& velocities) override {
    return guarded([&]() -> Status {
      const Result<SliceHostState> state = sliceHostState(m_config, positions, velocities);
      if (!state) return state.error();
      m_view.count = 0;
      allocate(positions.size());
      m_backend.upload(state->x, m_x);
      m_backend.upload(state->y, m_y);
      m_backend.upload(state->z, m_z);
      m_backend.upload(state->records, m_record);
      m_backend.upload(state->ids, m_id);
      m_view.count = static_cast<std::uint32_t>(positions.size());
      point();
      return {};
    });
  }

  Status step(double timeStep) override {
    if (m_view.count == 0) return {};
    return guarded([&]() -> Status {
      m_view.constants.timeStep = static_cast<float>(timeStep);
      sortIntoCells();
      m_pairs.density(m_backend, m_view);
      m_backend.forEach("pressure", m_view.count, PressureKernel{m_view});
      m_pairs.force(m_backend, m_view);
      m_backend.forEach("integrate", m_view.count, IntegrateKernel{m_view});
      return {};
    });
  }

  std::vector<SphParticle> particles() const override {
    SliceHostState state;
    std::vector<float> excess, ax, ay, az;
    m_backend.download(m_x, state.x);
    m_backend.download(m_y, state.y);
    m_backend.download(m_z, state.z);
    m_backend.download(m_record, state.records);
    m_backend.download(m_id, state.ids);
    m_backend.download(m_excess, excess);
    m_backend.download(m_ax, ax);
    m_backend.download(m_ay, ay);
    m_backend.download(m_az, az);
    std::vector<SphParticle> result(m_view.count);
    for (std::size_t i = 0; i < result.size(); ++i) {
      SphParticle& p = result[state.ids[i]];
      p = sliceParticle(m_config, state, i, excess[i]);
      p.pairAcceleration = Vec3f{ax[i], ay[i], az[i]}.template to<double>();
    }
    return result;
  }

  StageTimings& timings() override { return m_backend.timings(); }
  const char* device() const override { return Backend::kDevice; }
  std::size_t bytes() const override {
    const auto of = [](const auto& array) { return array.size() * sizeof(*array.data()); };
    return of(m_x) + of(m_y) + of(m_z) + of(m_otherX) + of(m_otherY) + of(m_otherZ) + of(m_record) +
           of(m_excess) + of(m_ax) + of(m_ay) + of(m_az) + of(m_id) + of(m_otherId) + of(m_key) +
           of(m_otherKey) + of(m_order) + of(m_binStart) + m_backend.scratchBytes();
  }

 private:
  template <class T>
  using Array = typename Backend::template Array<T>;

  /// Memory that is not there and a device that fails are the world's fault, not a bug.
  template <class Body>
  static Status guarded(const Body& body) {
    constexpr const char* kWhat = "The particle solver stopped";
    try {
      return body();
    } catch (const std::bad_alloc&) {
      return Error{ErrorKind::OutOfResources, kWhat, Backend::kDevice, "there is not enough memory",
                   "Use fewer particles"};
    } catch (const std::runtime_error& error) {
      return Error{ErrorKind::Failed, kWhat, Backend::kDevice, error.what(), "Use --device cpu"};
    }
  }

  void allocate(std::size_t n) {
    // Vector loads may start at the last particle.
    const std::size_t padded = n + kPairPadding;
    for (Array<std::int32_t>* array : {&m_x, &m_y, &m_z, &m_otherX, &m_otherY, &m_otherZ})
      array->resize(padded);
    for (Array<float>* array : {&m_excess, &m_ax, &m_ay, &m_az}) array->resize(padded);
    m_record.resize(padded);
    for (Array<std::uint32_t>* array : {&m_id, &m_otherId, &m_otherKey}) array->resize(padded);
    m_key.resize(n);
    m_binStart.resize(sliceBinCount(m_view.grid) + 1);
  }

  /// Swapping moves arrays between the sorted and the other set; the view follows.
  void point() {
    m_view.x = m_x.data();
    m_view.y = m_y.data();
    m_view.z = m_z.data();
    m_view.record = m_record.data();
    m_view.excess = m_excess.data();
    m_view.ax = m_ax.data();
    m_view.ay = m_ay.data();
    m_view.az = m_az.data();
    m_view.id = m_id.data();
    m_view.key = m_key.data();
    m_view.binStart = m_binStart.data();
  }

  void sortIntoCells() {
    const std::size_t n = m_view.count;
    const std::uint32_t bins = static_cast<std::uint32_t>(sliceBinCount(m_view.grid));
    m_backend.forEach("key", n, KeyKernel{m_view});
    m_backend.sortByKey("sort", m_key, bins, m_order);
    m_backend.forEach("gather", n,
                      GatherKernel{m_view, m_order.data(), m_otherX.data(), m_otherY.data(), m_otherZ.data(),
                                   m_otherId.data(), m_otherKey.data()});
    m_backend.forEach("gather", n, TakeVelocityKernel{m_view});
    std::swap(m_x, m_otherX);
    std::swap(m_y, m_otherY);
    std::swap(m_z, m_otherZ);
    std::swap(m_id, m_otherId);
    point();
    SliceView sorted = m_view;
    sorted.key = m_otherKey.data();
    m_backend.forEach("cells", n + 1, BinStartKernel{sorted, bins});
  }

  SphSliceConfig m_config;
  mutable Backend m_backend;
  PairStages<Backend> m_pairs;
  SliceView m_view;
  Array<std::int32_t> m_x, m_y, m_z, m_otherX, m_otherY, m_otherZ;
  Array<PairRecord> m_record;
  Array<float> m_excess, m_ax, m_ay, m_az;
  Array<std::uint32_t> m_id, m_otherId, m_key, m_otherKey, m_order, m_binStart;
};

}  // namespace spin
