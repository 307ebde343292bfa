// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

#include "core/property/text_mark.h"
#include "plugins/sdk/exporter.h"

namespace spin {

/// Particles as VTK XML PolyData (binary appended) with all attributes, and one PVD collection per set with
/// the film times: what ParaView reads.
class VtpExporter final : public CacheExporter {
 public:
  std::string id() const override { return "vtp"; }
  std::string label() const override { return SPIN_TR("Particles, VTP and PVD"); }
  bool applies(const Frame& frame) const override;
  Status begin(const ExportContext& context) override;
  Status writeFrame(const Frame& frame) override;
  Status finish() override;
  std::vector<std::string> files() const override { return m_files; }
  std::vector<ExportedAttribute> attributes() const override { return m_attributes; }

 private:
  struct Entry {
    double time;  ///< s of film
    std::string file;
  };
  Status writeSet(const Frame& frame, const std::string& partName, const ParticleSet& particles);

  ExportContext m_context;
  std::map<std::string, std::vector<Entry>> m_series;  ///< by base name
  std::vector<std::string> m_files;
  std::vector<ExportedAttribute> m_attributes;
};

}  // namespace spin
