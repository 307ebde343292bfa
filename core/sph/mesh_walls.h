// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/sph/flow_solver.h"
#include "core/sph/wall_view.h"

namespace spin {

/// The static meshes of a solver in a backend's memory.
template <class Backend>
class MeshWalls {
 public:
  /// Every mesh has its field.
  void upload(Backend& backend, const FlowConfig& config) {
    std::vector<std::uint32_t> blocks;
    std::vector<float> values;
    std::vector<WallMesh> meshes;
    std::vector<std::size_t> firstBlock, firstValue;
    for (const auto& mesh : config.walls.meshes) {
      firstBlock.push_back(blocks.size());
      firstValue.push_back(values.size());
      blocks.insert(blocks.end(), mesh.field->blocks().begin(), mesh.field->blocks().end());
      values.insert(values.end(), mesh.field->values().begin(), mesh.field->values().end());
      meshes.push_back({mesh.field->view(config.domainMin), mesh.surface});
    }
    if (meshes.empty()) return;
    backend.upload(blocks, m_blocks);
    backend.upload(values, m_values);
    for (std::size_t k = 0; k < meshes.size(); ++k) {
      meshes[k].field.blocks = m_blocks.data() + firstBlock[k];
      meshes[k].field.values = m_values.data() + firstValue[k];
    }
    backend.upload(meshes, m_meshes);
  }
  void point(WallView& walls) const {
    walls.meshes = m_meshes.data();
    walls.meshCount = static_cast<std::int32_t>(m_meshes.size());
  }
  std::size_t bytes() const {
    return m_blocks.size() * sizeof(std::uint32_t) + m_values.size() * sizeof(float) +
           m_meshes.size() * sizeof(WallMesh);
  }

 private:
  typename Backend::template Array<std::uint32_t> m_blocks;
  typename Backend::template Array<float> m_values;
  typename Backend::template Array<WallMesh> m_meshes;
};

}  // namespace spin
