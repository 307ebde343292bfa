// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// What the cells of the cover are coloured with, where that is more than snow's own white.
#include "core/base/units.h"
#include "editor/render/cover_pass.h"

namespace spin {

bool CoverLook::sameAs(const CoverLook& other) const {
  const RenderNode &a = settings, &b = other.settings;
  return look == other.look && a.snowDisplay == b.snowDisplay && a.snowRangeAuto == b.snowRangeAuto &&
         a.snowRangeLow == b.snowRangeLow && a.snowRangeHigh == b.snowRangeHigh &&
         hold.holdsBelow == other.hold.holdsBelow && hold.shedsAbove == other.hold.shedsAbove;
}

CoverLook coverLookOf(const SceneSnapshot& scene, double filmTime) {
  CoverLook look;
  look.settings = scene.settings<RenderNode>(filmTime);
  look.look = snowLook(look.settings);
  const auto simulation = scene.settings<SimulationNode>(filmTime);
  look.hold = {degreesToRadians(simulation.holdsBelowDegrees),
               degreesToRadians(simulation.shedsAboveDegrees)};
  return look;
}

void CoverPass::setLook(const CoverLook& look) {
  // These the bare surface has as well.
  const SnowDisplay shows = look.settings.snowDisplay;
  const bool bare = shows == SnowDisplay::Temperature || shows == SnowDisplay::Exposure;
  if (hasSnow() && (m_indicesStale || bare != m_bareDrawn)) {
    m_bareDrawn = bare;
    updateIndices();
  }
  if (!m_looksStale && look.sameAs(m_look)) return;
  m_look = look;
  // Snow in its own colours needs none; what is on the card waits for its next use.
  m_looksStale = look.look == SnowLook::Physical;
  if (hasSnow() && !m_looksStale) updateLooks();
}

void CoverPass::updateLooks() {
  const bool values = m_look.look == SnowLook::Values;
  const ValueScale scale = values ? coverScale(m_look.settings, *m_cover) : ValueScale();
  const auto texelsOf = [&](std::size_t grid) {
    return values ? coverColours(*m_cover, grid, m_look.settings.snowDisplay, scale)
                  : coverShares(*m_cover, grid, m_look.hold);
  };
  const auto upload = [](GlBuffer& buffer, const std::vector<CoverTexel>& texels) {
    if (!buffer) buffer = GlBuffer::make();
    glNamedBufferData(buffer.id(), static_cast<GLsizeiptr>(texels.size() * sizeof(CoverTexel)), texels.data(),
                      GL_DYNAMIC_DRAW);
  };
  if (!m_looks) {
    m_looks = GlTexture::make(GLenum{GL_TEXTURE_2D});
    glTextureStorage2D(m_looks.id(), 1, GL_RGBA8, m_coarseDepth.width, m_coarseDepth.height);
    setSampling(m_looks, GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE);
  }
  const std::vector<CoverTexel> coarse = m_coarse >= 0
                                             ? texelsOf(static_cast<std::size_t>(m_coarse))
                                             : std::vector<CoverTexel>(m_coarseDepth.size(), CoverTexel{});
  glTextureSubImage2D(m_looks.id(), 0, 0, 0, m_coarseDepth.width, m_coarseDepth.height, GL_RGBA,
                      GL_UNSIGNED_BYTE, coarse.data());
  for (Fine& fine : m_fine) upload(fine.looks, texelsOf(fine.grid));
  for (Patches& patches : m_patches) {
    std::vector<CoverTexel> all;
    all.reserve(patches.vertices);
    for (const PatchPart& part : patches.parts) {
      const std::vector<CoverTexel> cells = texelsOf(part.grid);
      for (const std::int32_t cell : part.mesh.shownCell)
        all.push_back(cells[static_cast<std::size_t>(cell)]);
    }
    upload(patches.looks, all);
  }
}

}  // namespace spin
