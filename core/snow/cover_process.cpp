// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/nodes/settings_nodes.h"
#include "core/physics/snow_density.h"
#include "core/snow/exposure_process.h"
#include "core/snow/snow_inputs.h"
#include "core/snow/snow_processes.h"

namespace spin {
namespace {

/// Snow on one grid of the layout.
struct CoverState {
  std::vector<double> swe;    ///< kg/m2
  std::vector<double> depth;  ///< m
};

/// Mass since frame 0, kg; what lies on the cells is summed from them.
struct Account {
  double emitted = 0.0, shed = 0.0, left = 0.0, residual = 0.0, aloft = 0.0;
  double before = 0.0;  ///< fell before frame 0; a part of it is shed, left or residual
};

class CoverProcess final : public Process {
 public:
  const char* id() const override { return "cover"; }

  void hashInputs(const StepInput& input, Hasher& hasher) const override {
    hasher.add("cover");
    hashSnowWeather(input, hasher);
    hashSnowGround(input, hasher);
  }

  Status begin(const SceneSnapshot& scene, ProcessContext& context) override {
    takeInputs(context);
    SPIN_CHECK(m_ground && m_field, "the exposure comes before the cover");
    m_grids.clear();
    for (const CoverGrid& grid : m_ground->layout->grids)
      m_grids.push_back(
          {std::vector<double>(grid.base.size(), 0.0), std::vector<double>(grid.base.size(), 0.0)});
    m_account = {};
    const auto snowfall = scene.settings<SnowfallNode>(0.0);
    const double before = snowfall.oldSnowDepth * snowfall.oldSnowDensity;
    layDown(before, snowfall.oldSnowDensity, context);
    m_account.before = before * m_field->rates.emitted;
    fillAir(scene, 0.0);
    return {};
  }

  Status step(const StepInput& input, ProcessContext& context) override {
    takeInputs(context);
    SPIN_CHECK(m_ground && m_field, "the exposure comes before the cover");
    const SnowWeather weather = snowWeatherAt(input.scene, middleFilm(input));
    const auto settings = input.scene.settings<SimulationNode>(middleFilm(input));
    const double density =
        settings.newSnowDensity > 0.0 ? settings.newSnowDensity : newSnowDensity(weather.airTemperature);
    const double fallen = weather.precipitation * (input.to.weather - input.from.weather);  // kg/m2
    layDown(fallen, density, context);
    m_account.emitted += fallen * m_field->rates.emitted;
    fillAir(input.scene, input.to.film);
    return {};
  }

  void publish(const SceneSnapshot&, const FrameTime&, Frame& frame) const override {
    auto part = std::make_shared<CoverPart>();
    part->layout = m_ground->layout;
    part->exposure = m_exposure;
    part->values.resize(m_grids.size());
    double deposited = 0.0, deepest = 0.0;
    for (std::size_t g = 0; g < m_grids.size(); ++g) {
      const CoverState& state = m_grids[g];
      const std::vector<float>& area = m_ground->layout->grids[g].area.values;
      CoverPart::Values& values = part->values[g];
      values.swe.assign(state.swe.begin(), state.swe.end());
      values.depth.assign(state.depth.begin(), state.depth.end());
      for (std::size_t c = 0; c < area.size(); ++c) {
        deposited += state.swe[c] * static_cast<double>(area[c]);
        deepest = std::max(deepest, state.depth[c]);
      }
    }
    frame.parts["cover"] = std::move(part);
    frame.info.figures["deepest_snow_m"] = deepest;
    publishBudget(deposited, frame.info);
  }

  void saveState(ByteWriter& out) const override {
    out.put(m_account);
    out.put(static_cast<std::uint64_t>(m_grids.size()));
    for (const CoverState& grid : m_grids) {
      out.putArray(grid.swe);
      out.putArray(grid.depth);
    }
  }

  Status loadState(const SceneSnapshot&, ProcessContext& context, ByteReader& in) override {
    takeInputs(context);
    SPIN_CHECK(m_ground, "the exposure comes before the cover");
    const std::vector<CoverGrid>& grids = m_ground->layout->grids;
    m_account = in.get<Account>();
    bool fits = in.get<std::uint64_t>() == grids.size() && in.ok();
    m_grids.clear();
    for (std::size_t g = 0; fits && g < grids.size(); ++g) {
      CoverState state{in.getArray<double>(), in.getArray<double>()};
      fits = in.ok() && state.swe.size() == grids[g].base.size() && state.depth.size() == state.swe.size();
      m_grids.push_back(std::move(state));
    }
    if (!fits) return badInput("The checkpoint could not be used", "cover", "its grids do not fit the scene");
    return {};
  }

  void estimate(const SceneSnapshot& scene, double& stateBytes, double& frameBytes) const override {
    const SnowGroundPointer ground = makeSnowGround(scene);
    double cells = 0.0;
    for (const CoverGrid& grid : ground->layout->grids) cells += static_cast<double>(grid.base.size());
    stateBytes = cells * 2.0 * sizeof(double);
    frameBytes = cells * 3.0 * sizeof(float);
  }

 private:
  /// Books where snow goes of which so much falls on open level ground, kg/m2; who emitted it is the
  /// caller's.
  void layDown(double fallen, double density, ProcessContext& context) {
    for (std::size_t g = 0; g < m_grids.size(); ++g) {
      CoverState& state = m_grids[g];
      const std::vector<float>& held = m_field->grids[g].held;
      context.backend.forEach("cover", held.size(), [&](std::size_t c) {
        const double gain = fallen * static_cast<double>(held[c]);
        state.swe[c] += gain;
        state.depth[c] += gain / density;
      });
    }
    const SnowRates& rates = m_field->rates;
    m_account.shed += fallen * rates.shed;
    m_account.left += fallen * rates.left;
    m_account.residual += fallen * rates.residual();
  }

  void takeInputs(ProcessContext& context) {
    if (const auto* ground = context.exchange.find<SnowGroundPointer>()) m_ground = *ground;
    const auto* field = context.exchange.find<ExposureFieldPointer>();
    if (!field || *field == m_field) return;
    m_field = *field;
    auto exposure = std::make_shared<CoverExposure>();
    for (const ExposureField::Values& grid : m_field->grids) exposure->grids.push_back(grid.exposure);
    m_exposure = std::move(exposure);
  }

  /// The precipitation rate is that at the ground: the air above holds what falls at that rate, and a change
  /// of rate or of the air's volume is emitted into it (or less is) at that time.
  void fillAir(const SceneSnapshot& scene, double filmTime) {
    const double aloft = snowWeatherAt(scene, filmTime).spectrum.massConcentration * m_field->airVolume;
    m_account.emitted += aloft - m_account.aloft;
    m_account.aloft = aloft;
  }

  void publishBudget(double deposited, FrameInfo& info) const {
    info.budget.set("emitted", true, m_account.emitted);
    if (m_account.before > 0.0) info.budget.set("fallen_before", true, m_account.before);
    info.budget.set("deposited", false, deposited);
    info.budget.set("shed", false, m_account.shed);
    info.budget.set("aloft", false, m_account.aloft);
    info.budget.set("left", false, m_account.left);
    info.budget.set("sampling_residual", false, m_account.residual);
    const SnowRates& rates = m_field->rates;
    if (!(rates.emitted > 0.0)) return;
    // The sinks' residuals may cancel in the budget, so each is shown too.
    info.figures["lost_share"] = rates.lost / rates.emitted;
    info.figures["residual_ground_share"] = (rates.forward.ground - rates.gathered.ground) / rates.emitted;
    info.figures["residual_models_share"] = (rates.forward.models - rates.gathered.models) / rates.emitted;
    info.figures["residual_left_share"] = (rates.forward.left - rates.gathered.left) / rates.emitted;
  }

  SnowGroundPointer m_ground;
  ExposureFieldPointer m_field;
  std::shared_ptr<const CoverExposure> m_exposure;  ///< of the field; frames share it
  std::vector<CoverState> m_grids;                  ///< by the layout's grids
  Account m_account;
};

}  // namespace

ProcessType coverProcessType() {
  return {"cover", 400, snowHasGround,
          [] { return std::unique_ptr<Process>(std::make_unique<CoverProcess>()); }};
}

}  // namespace spin
