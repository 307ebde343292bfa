// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <mutex>

#include "core/sim/air_part.h"
#include "core/sim/bodies_part.h"
#include "core/sim/flakes_part.h"
#include "core/sim/frame.h"

namespace spin {

namespace {

struct Loaders {
  FramePartLoader part = nullptr;
  SharedDataLoader shared = nullptr;
};

struct PartRegistry {
  std::mutex mutex;
  std::map<std::string, Loaders> kinds{{ParticlePart::kKind, {&ParticlePart::load, nullptr}},
                                       {CoverPart::kKind, {&CoverPart::load, &loadCoverShared}},
                                       {BodiesPart::kKind, {&BodiesPart::load, nullptr}},
                                       {AirPart::kKind, {&AirPart::load, nullptr}},
                                       {FlakesPart::kKind, {&FlakesPart::load, &loadWindTable}}};
};

PartRegistry& partRegistry() {
  static PartRegistry registry;
  return registry;
}

Loaders loadersOf(const std::string& kind) {
  PartRegistry& registry = partRegistry();
  std::lock_guard lock(registry.mutex);
  const auto found = registry.kinds.find(kind);
  return found == registry.kinds.end() ? Loaders{} : found->second;
}

void saveInfo(const FrameInfo& info, ByteWriter& out, bool withTimings) {
  out.put(info.time.frame);
  out.put(info.time.film);
  out.put(info.time.weather);
  out.put(info.key);
  out.put(info.solverVersion);
  out.put(info.backend);
  out.put(info.seed);
  out.put(static_cast<std::uint64_t>(info.budget.terms.size()));
  for (const BudgetTerm& term : info.budget.terms) {
    out.put(term.name);
    out.put(static_cast<std::uint8_t>(term.source));
    out.put(term.kilograms);
  }
  out.put(static_cast<std::uint64_t>(info.figures.size()));
  for (const auto& [name, value] : info.figures) {
    out.put(name);
    out.put(value);
  }
  const std::vector<StageTime> stages = withTimings ? info.timings.table() : std::vector<StageTime>{};
  out.put(static_cast<std::uint64_t>(stages.size()));
  for (const StageTime& stage : stages) {
    out.put(stage.name);
    out.put(stage.seconds);
  }
}

void loadInfo(ByteReader& in, FrameInfo& info) {
  info.time.frame = in.get<int>();
  info.time.film = in.get<double>();
  info.time.weather = in.get<double>();
  info.key = in.get<Hash128>();
  info.solverVersion = in.getText();
  info.backend = in.getText();
  info.seed = in.get<std::int64_t>();
  const auto terms = in.get<std::uint64_t>();
  for (std::uint64_t t = 0; t < terms && in.ok(); ++t) {
    const std::string name = in.getText();
    const bool source = in.get<std::uint8_t>() != 0;
    info.budget.set(name, source, in.get<double>());
  }
  const auto figures = in.get<std::uint64_t>();
  for (std::uint64_t f = 0; f < figures && in.ok(); ++f) {
    const std::string name = in.getText();
    info.figures[name] = in.get<double>();
  }
  const auto stages = in.get<std::uint64_t>();
  for (std::uint64_t s = 0; s < stages && in.ok(); ++s) {
    const std::string name = in.getText();
    info.timings.add(name, in.get<double>());
  }
}

}  // namespace

void registerFramePart(const char* kind, FramePartLoader loader, SharedDataLoader sharedLoader) {
  PartRegistry& registry = partRegistry();
  std::lock_guard lock(registry.mutex);
  registry.kinds[kind] = {loader, sharedLoader};
}

void saveFrame(const Frame& frame, ByteWriter& out, bool withTimings) {
  saveInfo(frame.info, out, withTimings);
  out.put(static_cast<std::uint64_t>(frame.parts.size()));
  for (const auto& [name, part] : frame.parts) {
    ByteWriter body;
    part->save(body);
    out.put(name);
    out.put(std::string(part->kind()));
    out.putArray(body.bytes());
  }
}

std::shared_ptr<Frame> loadFrame(ByteReader& in) {
  auto frame = std::make_shared<Frame>();
  loadInfo(in, frame->info);
  const auto parts = in.get<std::uint64_t>();
  for (std::uint64_t p = 0; p < parts && in.ok(); ++p) {
    const std::string name = in.getText();
    const Loaders loaders = loadersOf(in.getText());
    const std::vector<char> body = in.getArray<char>();
    if (!in.ok() || !loaders.part) return nullptr;
    ByteReader bodyReader(body.data(), body.size());
    std::shared_ptr<FramePart> part = loaders.part(bodyReader);
    if (!part || !bodyReader.atEnd()) return nullptr;
    frame->parts[name] = std::move(part);
  }
  return in.ok() && in.atEnd() ? frame : nullptr;
}

std::vector<SharedReference> sharedReferences(const Frame& frame) {
  std::vector<SharedReference> references;
  for (const auto& [name, part] : frame.parts) {
    for (const Hash128& key : part->sharedKeys()) references.push_back({part->kind(), key});
  }
  return references;
}

std::shared_ptr<const void> loadShared(const std::string& kind, ByteReader& in) {
  const Loaders loaders = loadersOf(kind);
  return loaders.shared ? loaders.shared(in) : nullptr;
}

}  // namespace spin
