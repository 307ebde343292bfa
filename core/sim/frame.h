// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "core/base/timings.h"
#include "core/fields/particles.h"
#include "core/fields/raster.h"
#include "core/math/transform.h"
#include "core/sim/serialize.h"
#include "core/sim/snapshot.h"

namespace spin {

/// One term of the mass budget, kg since frame 0. Sources are positive on the left side of
///   emitted = deposited + shed + aloft + left + sampling residual (+ later terms).
/// Every term is counted where it happens; none is computed as the remainder.
struct BudgetTerm {
  std::string name;  ///< "emitted", "deposited", "runoff", ...
  bool source = false;
  double kilograms = 0.0;
};

struct MassBudget {
  std::vector<BudgetTerm> terms;

  void set(const std::string& name, bool source, double kilograms);
  double get(const std::string& name) const;
  /// (sources - sinks) / sources; 0 where nothing was emitted.
  double relativeImbalance() const;
};

/// Where a frame comes from. Timings are informative and take no part in comparisons or keys.
struct FrameInfo {
  FrameTime time;
  Hash128 key;  ///< chained content key
  std::string solverVersion;
  std::string backend;  ///< "cpu-avx512", ...
  std::int64_t seed = 0;
  MassBudget budget;
  std::map<std::string, double>
      figures;  ///< error figures and statistics, by name with unit: "sampling_rmse"
  StageTimings timings;
};

/// One piece of a frame's data. Later processes add their own kinds with a reader (registerFramePart).
struct FramePart {
  virtual ~FramePart() = default;
  virtual const char* kind() const = 0;
  virtual std::size_t memoryBytes() const = 0;
  virtual void save(ByteWriter& out) const = 0;
  /// Names the first value that is not finite ("swe of grid terrain, cell 7 is nan"); empty if all are.
  virtual std::string firstNonFinite() const { return {}; }
  /// Content keys of the data that this part shares with other frames (a cover's layout and exposure).
  /// save() leaves that data out and writes only its keys: the frame store keeps it once.
  virtual std::vector<Hash128> sharedKeys() const { return {}; }
  /// Writes the shared data of one of these keys.
  virtual void saveShared(const Hash128&, ByteWriter&) const {}
};

struct ParticlePart final : FramePart {
  static constexpr const char* kKind = "particles";
  ParticleSet particles;

  const char* kind() const override { return kKind; }
  std::size_t memoryBytes() const override;
  void save(ByteWriter& out) const override;
  std::string firstNonFinite() const override;
  static std::shared_ptr<FramePart> load(ByteReader& in);
};

/// One grid of snow cover. The terrain has one coarse grid with the terrain raster's shape and fine grids
/// near models; a model has one patch per connected up-facing part, in the model's own space.
struct CoverGrid {
  std::string id;      ///< "terrain", "terrain/fine0", "hut/0"
  std::string node;    ///< id of the node it lies on
  Raster<float> base;  ///< height of the bare surface at the cell centres, NaN = no surface: local m for the
                       ///< terrain, in the node's scaled, rotated axes relative to its position for patches
  Raster<float>
      area;  ///< m2 of horizontal area that the cell accounts for; 0 where another grid accounts for it
};

/// The grids of a scene; shared by all frames with the same layout.
struct CoverLayout {
  std::vector<CoverGrid> grids;
};

/// How open the cells lie to the falling snow, 0 sheltered .. 1 open: per grid of the layout one value per
/// cell. It changes only with the wind and with what stands in the scene, so frames share it.
struct CoverExposure {
  std::vector<std::vector<float>> grids;
};

/// State of the snow cover: per grid of the layout one value per cell, in the raster's order.
struct CoverPart final : FramePart {
  static constexpr const char* kKind = "cover";
  struct Values {
    std::vector<float> swe;               ///< kg/m2
    std::vector<float> depth;             ///< m, vertical
    std::vector<float> liquid = {};       ///< kg/m2 of water within the snow; empty where nothing melts
    std::vector<float> temperature = {};  ///< K of the surface, snow or bare; empty where nothing melts
  };
  std::shared_ptr<const CoverLayout> layout;
  std::shared_ptr<const CoverExposure> exposure;  ///< null: not known
  std::vector<Values> values;

  const char* kind() const override { return kKind; }
  /// With the exposure, which may be another one in every frame, and without the shared layout.
  std::size_t memoryBytes() const override;
  void save(ByteWriter& out) const override;
  std::string firstNonFinite() const override;  ///< cells without a surface do not count
  std::vector<Hash128> sharedKeys() const override;
  void saveShared(const Hash128& key, ByteWriter& out) const override;
  /// Finds layout and exposure by their keys among those in use; null if they are not there.
  static std::shared_ptr<FramePart> load(ByteReader& in);
};

/// What scrubbing, drawing and exporting need of one frame. Immutable once published.
struct Frame {
  FrameInfo info;
  std::map<std::string, std::shared_ptr<const FramePart>> parts;  ///< "flakes", "cover", ...

  template <class T>
  const T* part(const std::string& name) const {
    const auto it = parts.find(name);
    return it == parts.end() ? nullptr : dynamic_cast<const T*>(it->second.get());
  }
  std::size_t memoryBytes() const;
};
using FramePointer = std::shared_ptr<const Frame>;

/// Returns null if the bytes are no such part.
using FramePartLoader = std::shared_ptr<FramePart> (*)(ByteReader&);
/// Reads shared data and makes it known to the part's loader; whoever holds the result keeps it alive. Null
/// if the bytes are no such data.
using SharedDataLoader = std::shared_ptr<const void> (*)(ByteReader&);
/// Known kinds: particles, cover, bodies; a later process registers its own at start-up.
void registerFramePart(const char* kind, FramePartLoader loader, SharedDataLoader sharedLoader = nullptr);

/// Makes data findable by its content for as long as somebody holds it; returns what is in use already if
/// there is an equal one.
std::shared_ptr<const CoverLayout> internLayout(std::shared_ptr<const CoverLayout> layout);
std::shared_ptr<const CoverExposure> internExposure(std::shared_ptr<const CoverExposure> exposure);
/// The shared data loader of covers.
std::shared_ptr<const void> loadCoverShared(ByteReader& in);

/// Binary form of a frame without its shared data; `withTimings` false gives equal bytes for equal results.
void saveFrame(const Frame& frame, ByteWriter& out, bool withTimings = true);
/// Null if the bytes are damaged or shared data is missing.
std::shared_ptr<Frame> loadFrame(ByteReader& in);
/// Kind and key of the shared data of a frame's parts.
struct SharedReference {
  std::string kind;
  Hash128 key;
};
std::vector<SharedReference> sharedReferences(const Frame& frame);
/// Loads shared data of a kind; null if damaged or of an unknown kind.
std::shared_ptr<const void> loadShared(const std::string& kind, ByteReader& in);

}  // namespace spin
