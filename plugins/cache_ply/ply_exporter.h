// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/property/text_mark.h"
#include "plugins/sdk/exporter.h"

namespace spin {

/// Particles as binary little-endian PLY: x y z (local m), id, and every attribute as scalar_NAME (vectors as
/// scalar_NAME_x, _y, _z), which CloudCompare shows as scalar fields.
class PlyExporter final : public CacheExporter {
 public:
  std::string id() const override { return "ply"; }
  std::string label() const override { return SPIN_TR("Particles, PLY"); }
  bool applies(const Frame& frame) const override;
  Status begin(const ExportContext& context) override;
  Status writeFrame(const Frame& frame) override;
  Status finish() override { return {}; }
  std::vector<std::string> files() const override { return m_files; }
  std::vector<ExportedAttribute> attributes() const override { return m_attributes; }

 private:
  Status writeSet(const Frame& frame, const std::string& partName, const ParticleSet& particles);

  ExportContext m_context;
  std::vector<std::string> m_files;
  std::vector<ExportedAttribute> m_attributes;
};

}  // namespace spin
