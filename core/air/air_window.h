// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/air/velocity_passes.h"
#include "core/base/result.h"

namespace spin {

/// A brick's place in the scene's lattice, in bricks.
using BrickKey = std::array<std::int32_t, 3>;
/// Ascending by z, then y, then x, as frames keep them.
bool brickBefore(const BrickKey& a, const BrickKey& b);
void sortBricks(std::vector<BrickKey>& keys);

/// The arrays' lattice: the box round all active bricks with at least a ring of others, and lists of bricks
/// in it. It follows from the active bricks alone, so that resuming finds the same one.
class AirWindow {
 public:
  /// `active` in order, no two alike. Fails where the arrays would be too large to be numbered.
  static Result<AirWindow> make(std::vector<BrickKey> active);

  const std::vector<BrickKey>& keys() const { return m_active; }
  const std::vector<AirBrick>& active() const { return m_activeBricks; }
  /// Active bricks and those next to them on the upper sides: all whose lower faces touch an active one.
  const std::vector<AirBrick>& faces() const { return m_faces; }
  /// Active bricks and all that touch one, with their keys.
  const std::vector<AirBrick>& near() const { return m_near; }
  const std::vector<BrickKey>& nearKeys() const { return m_nearKeys; }

  AirDims dims() const { return m_dims; }
  AirStrides strides() const { return {m_dims.x, m_dims.x * m_dims.y}; }
  std::size_t cells() const {
    return static_cast<std::size_t>(strides().z) * static_cast<std::size_t>(m_dims.z);
  }
  std::array<std::int32_t, 3> bricksAlong() const { return m_count; }
  /// Key of the window's first brick.
  const BrickKey& low() const { return m_low; }
  /// Place in nearKeys() or -1.
  std::int32_t nearPlace(const BrickKey& key) const;
  /// Place in keys() or -1.
  std::int32_t activePlace(const BrickKey& key) const;

 private:
  std::size_t slot(const BrickKey& key) const;  ///< in m_places; the count of slots where it is outside
  AirBrick brickOf(const BrickKey& key) const;

  BrickKey m_low{}, m_count{};
  AirDims m_dims;
  std::vector<BrickKey> m_active, m_nearKeys;
  std::vector<AirBrick> m_activeBricks, m_faces, m_near;
  std::vector<std::int32_t> m_nearPlaces, m_activePlaces;  ///< by slot
};

/// A coarser level's bricks, of the same number of cells.
struct CoarseBricks {
  AirDims dims;
  std::vector<AirBrick> active;  ///< hold children that are active
  std::vector<AirBrick> faces;   ///< and those next to them on the upper sides
  AirStrides strides() const { return {dims.x, dims.x * dims.y}; }
  std::size_t cells() const {
    return static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y) *
           static_cast<std::size_t>(dims.z);
  }
};
/// From a level's dimensions and active bricks (see CoarseMap).
CoarseBricks coarserBricks(const AirDims& dims, const std::vector<AirBrick>& active);

}  // namespace spin
