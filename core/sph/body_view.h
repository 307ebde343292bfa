// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sph/flow_view.h"

/// Bodies in the flow as kernels see them. Their boundary particles have rows and bins of their own, so the
/// passes over pairs of flow particles know nothing of them.
namespace spin {

/// Where a body is and how it moves, for one step.
struct BodyPose {
  std::int32_t x, y, z;       ///< centre of mass, units
  float restX, restY, restZ;  ///< and what is below one
  float turn[9];              ///< body axes to the solver's, by rows
  float vx, vy, vz;           ///< m/s
  float wx, wy, wz;           ///< rad/s
  std::uint32_t there;        ///< 0 = so far off that nothing of it is in the domain
};

/// A boundary particle in body axes.
struct BodyPoint {
  float x, y, z;       ///< m from the centre of mass
  float volume;        ///< in rest volumes of a flow particle
  std::uint32_t body;  ///< number
};

/// A boundary particle near the flow, sorted as particles are.
struct BodyRecord {
  float vx, vy, vz;        ///< m/s
  float armX, armY, armZ;  ///< from the centre of mass, m
  float volume;            ///< in rest volumes
  std::uint32_t point;     ///< number of its BodyPoint
  std::uint8_t surface;    ///< of its body
};

/// What the surfaces of bodies do to a flow particle besides pressure: its acceleration along them, with the
/// sum of weights that shares it out to the boundary particles, and what one of them holds it off with.
struct BodyRub {
  float x, y, z;  ///< m/s2
  float weight;
  float holdX, holdY, holdZ;  ///< m/s2
  std::uint32_t holder;       ///< sorted boundary particle; UINT32_MAX = none
};

/// All that bodies gave a flow particle in a step, m/s2.
struct BodyGift {
  float x, y, z;
};

/// Force and torque about the body's centre of mass, N and N m.
struct BodyLoad {
  double fx, fy, fz, tx, ty, tz;
};

/// Points of one body that are summed in one go.
struct BodyChunk {
  std::uint32_t begin, end, body;
};

struct BodyView {
  FlowView grid;  ///< x, y, z, extra, key, rows, binStart and count of boundary particles
  const BodyRecord* record = nullptr;   ///< sorted
  const std::uint32_t* list = nullptr;  ///< flow particles that may be near a body
  const std::uint32_t* slot = nullptr;  ///< place in the list, by flow particle
  BodyRub* rub = nullptr;               ///< by place in the list
  BodyGift* gift = nullptr;             ///< by place in the list
  float viscousFactor = 0;              ///< V0 norm / h^5, whatever form viscosity has between particles
};

}  // namespace spin
