// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/math/transform.h"
#include "core/sim/frame.h"

namespace spin {

/// Where moved models stand in a frame: they are drawn there instead of where their nodes say.
struct BodiesPart final : FramePart {
  static constexpr const char* kKind = "bodies";
  struct Placement {
    std::string model;    ///< id of the model node
    Transform placement;  ///< model space to local metres
    Vec3d velocity{};     ///< m/s, of the centre of mass
  };
  std::vector<Placement> bodies;

  const Placement* find(const std::string& model) const {
    for (const Placement& body : bodies)
      if (body.model == model) return &body;
    return nullptr;
  }
  const char* kind() const override { return kKind; }
  std::size_t memoryBytes() const override;
  void save(ByteWriter& out) const override;
  std::string firstNonFinite() const override;
  static std::shared_ptr<FramePart> load(ByteReader& in);
};

}  // namespace spin
