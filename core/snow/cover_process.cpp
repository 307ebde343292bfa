// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/base/log.h"
#include "core/base/units.h"
#include "core/nodes/settings_nodes.h"
#include "core/physics/snow_density.h"
#include "core/sim/scene_time.h"
#include "core/sim/scene_weather.h"
#include "core/snow/cover_cells.h"
#include "core/snow/exposure_process.h"
#include "core/snow/snow_inputs.h"
#include "core/snow/snow_motion.h"
#include "core/snow/snow_processes.h"

namespace spin {
namespace {

/// Mass since frame 0, kg; what lies on the cells is summed from them.
struct Account {
  double emitted = 0.0, shed = 0.0, left = 0.0, residual = 0.0, aloft = 0.0;
  double before = 0.0;   ///< fell before frame 0 or is painted; a part of it is shed, left or residual
  double gained = 0.0;   ///< by more precipitation higher up
  double cleared = 0.0;  ///< from ground that is kept clear
  double runoff = 0.0, sublimated = 0.0;
  double melted = 0.0, refrozen = 0.0;  ///< within the cover
  double clamped = 0.0;                 ///< growth that the published law asked for and did not get
  double guardedSeconds = 0.0;          ///< m2 s at that law's pole
  double blownIn = 0.0, blownOut = 0.0, slidOut = 0.0;  ///< over the domain's borders along the ground
  double slid = 0.0, roofShed = 0.0, drifted = 0.0;  ///< within the cover: from cells, off models, taken up
  double waited = 0.0;                               ///< s of weather since the snow last moved
  double unsettled = 0.0;                            ///< cells that were still too steep then
};

/// Snow moves along the ground after so much weather, s: what falls in it is less than what a slope notices.
constexpr double kMotionStep = 900.0;

/// A date that cannot be read is an error; a film that outlasts its record is worth a word.
Status checkDates(const SceneSnapshot& scene) {
  const auto weather = scene.settings<WeatherNode>(0.0);
  if (!weather.start.empty())
    if (const Result<std::int64_t> start = parseDateTime(weather.start); !start) return start.error();
  if (!scene.weather) return {};
  const double begin = utcAt(scene, 0.0).value_or(0.0);
  const double last =
      utcAt(scene, scene.timeOf(scene.settings<SimulationNode>(0.0).lastFrame).weather).value_or(begin);
  const auto end =
      scene.weather->start + scene.weather->step * static_cast<std::int64_t>(scene.weather->records.size());
  if (begin < static_cast<double>(scene.weather->start) || last > static_cast<double>(end) + 1.0)
    logWarning(fmt::format(
        "The film goes from {} to {} (UTC), the station record from {} to {}: beyond it nothing "
        "falls and its nearest values hold",
        dateTimeText(static_cast<std::int64_t>(begin)), dateTimeText(static_cast<std::int64_t>(last)),
        dateTimeText(scene.weather->start), dateTimeText(end)));
  return {};
}

class CoverProcess final : public Process {
 public:
  const char* id() const override { return "cover"; }

  void hashInputs(const StepInput& input, Hasher& hasher) const override {
    hasher.add("cover");
    hashSnowWeather(input, hasher);
    hashSnowGround(input, hasher);
    hashSnowCover(input, hasher);
  }

  Status begin(const SceneSnapshot& scene, ProcessContext& context) override {
    takeInputs(context);
    SPIN_CHECK(m_ground && m_field, "the exposure comes before the cover");
    context.exchange.emplace<SnowFallout>();
    if (const Status dated = checkDates(scene); !dated) return dated;
    m_cells = std::make_unique<CoverCells>(scene, *m_ground, context.backend);
    m_account = {};
    const auto snowfall = scene.settings<SnowfallNode>(0.0);
    const double before = snowfall.oldSnowDepth * snowfall.oldSnowDensity;
    const double painted = m_cells->layOld(scene, *m_field, before, snowfall.oldSnowDensity);
    bookFall(before);
    m_account.before = before * m_field->rates.emitted + painted;
    fillAir(scene, 0.0);
    return {};
  }

  Status step(const StepInput& input, ProcessContext& context) override {
    takeInputs(context);
    SPIN_CHECK(m_cells && m_field, "begin() comes before step()");
    if (auto* fallout = context.exchange.find<SnowFallout>(); fallout && !fallout->falling.empty())
      m_cells->settle(*fallout, airAt(input.scene, input.from.film).temperature - kZeroCelsius);
    const TimeSpan whole{input.from, input.to};
    const int parts =
        std::max(static_cast<int>(std::ceil(whole.seconds() / CoverCells::kMostStep - 1e-9)), 1);
    for (int k = 0; k < parts; ++k) {
      if (context.cancel.cancelled()) return cancelledError();
      stepPart(input.scene, whole.part(double(k) / parts, double(k + 1) / parts), context);
      if (context.progress) context.progress(double(k + 1) / parts);
    }
    fillAir(input.scene, input.to.film);
    return {};
  }

  void publish(const SceneSnapshot&, const FrameTime&, Frame& frame) const override {
    auto part = std::make_shared<CoverPart>();
    part->layout = m_ground->layout;
    part->exposure = m_exposure;
    float deepest = 0.0f;
    for (std::size_t g = 0; g < m_ground->layout->grids.size(); ++g) {
      part->values.push_back(m_cells->valuesOf(g));
      for (const float depth : part->values.back().depth) deepest = std::max(deepest, depth);
    }
    frame.parts["cover"] = std::move(part);
    frame.info.figures["deepest_snow_m"] = static_cast<double>(deepest);
    publishBudget(m_cells->deposited(), frame.info);
  }

  void saveState(ByteWriter& out) const override {
    out.put(m_account);
    m_cells->save(out);
  }

  Status loadState(const SceneSnapshot& scene, ProcessContext& context, ByteReader& in) override {
    takeInputs(context);
    SPIN_CHECK(m_ground, "the exposure comes before the cover");
    context.exchange.emplace<SnowFallout>();
    m_cells = std::make_unique<CoverCells>(scene, *m_ground, context.backend);
    m_account = in.get<Account>();
    if (!in.ok() || !m_cells->load(in))
      return badInput("The checkpoint could not be used", "cover", "its grids do not fit the scene");
    return {};
  }

  void estimate(const SceneSnapshot& scene, double& stateBytes, double& frameBytes) const override {
    const SnowGroundPointer ground = makeSnowGround(scene);
    double cells = 0.0;
    for (const CoverGrid& grid : ground->layout->grids) cells += static_cast<double>(grid.base.size());
    const bool ages = scene.settings<SnowCoverNode>(0.0).law != CoverLaw::Lies;
    stateBytes = cells * (2.0 * sizeof(double) + CoverSite::kBytesPerCell);
    frameBytes = cells * (ages ? 5.0 : 3.0) * sizeof(float);
  }

 private:
  void stepPart(const SceneSnapshot& scene, const TimeSpan& span, ProcessContext& context) {
    const CoverWeather weather = coverWeather(scene, span);
    const double density = newSnowDensityOf(scene, weather.step, span.middleFilm());
    const double fallen = weather.precipitation * span.seconds();  // kg/m2
    const CoverCells::Fallen beyond =
        m_cells->fall(scene, span.middleFilm(), *m_field, weather, fallen, density, context.backend);
    bookFall(fallen);
    m_account.emitted += fallen * m_field->rates.emitted;
    m_account.gained += beyond.gained;
    m_account.cleared += beyond.cleared;
    const auto [totals, seconds] = m_cells->advance(scene, span, fallen, context.backend, context.isa);
    m_account.runoff += beyond.runoff + totals[SnowStepTotals::kRunoff];
    m_account.sublimated += totals[SnowStepTotals::kSublimated];
    m_account.melted += totals[SnowStepTotals::kMelted];
    m_account.refrozen += totals[SnowStepTotals::kRefrozen];
    m_account.clamped += totals[SnowStepTotals::kClampedGrowth];
    m_account.guardedSeconds += totals[SnowStepTotals::kGuardedArea] * seconds;
    m_account.waited += span.seconds();
    if (!m_cells->waits() && m_account.waited >= kMotionStep) moveSnow(scene, span.middleFilm(), context);
  }

  /// Slides, smoothing and drift over the time since they were last done.
  void moveSnow(const SceneSnapshot& scene, double filmTime, ProcessContext& context) {
    const auto* motion = context.exchange.find<SnowMotionPointer>();
    const MotionSettings settings = motionSettings(scene, filmTime);
    const double seconds = std::exchange(m_account.waited, 0.0);
    if (!motion || !(*motion)->placed() || !settings.moves()) return;
    const CoverCells::Moving before = m_cells->moving();
    CoverCells::Moving after = before;
    MovingSnow snow;
    snow.carried = {after.depth.data(), after.mass.data(), after.liquid.data(), after.heat.data()};
    snow.liquid = after.liquid.data();
    const MotionTotals totals = (*motion)->step(scene, settings, seconds, snow, context.backend);
    m_cells->move(before, after, context.backend);
    m_account.blownIn += totals.blownIn[snow.mass];
    m_account.blownOut += totals.blownOut[snow.mass];
    m_account.slidOut += totals.slidOut[snow.mass];
    m_account.slid += totals.slid[snow.mass];
    m_account.roofShed += totals.shed[snow.mass];
    m_account.drifted += totals.eroded[snow.mass];
    m_account.unsettled = static_cast<double>(totals.unsettled);
  }

  static double newSnowDensityOf(const SceneSnapshot& scene, const SnowStepWeather& weather, double film) {
    const double set = scene.settings<SimulationNode>(film).newSnowDensity;
    return set > 0.0 ? set : newSnowDensity(celsiusToKelvin(static_cast<double>(weather.airTemperature)));
  }

  /// Books where precipitation goes of which so much falls on open level ground, kg/m2, but for the cells;
  /// who emitted it is the caller's.
  void bookFall(double fallen) {
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
    if (m_account.gained != 0.0) info.budget.set("altitude_gain", true, m_account.gained);
    if (m_account.blownIn > 0.0) info.budget.set("drifted_in", true, m_account.blownIn);
    info.budget.set("deposited", false, deposited);
    if (m_account.blownOut > 0.0) info.budget.set("drifted_out", false, m_account.blownOut);
    if (m_account.slidOut > 0.0) info.budget.set("slid_out", false, m_account.slidOut);
    if (m_account.cleared != 0.0) info.budget.set("cleared", false, m_account.cleared);
    if (m_account.runoff != 0.0) info.budget.set("runoff", false, m_account.runoff);
    if (m_account.sublimated != 0.0) info.budget.set("sublimated", false, m_account.sublimated);
    info.budget.set("shed", false, m_account.shed);
    info.budget.set("aloft", false, m_account.aloft);
    info.budget.set("left", false, m_account.left);
    info.budget.set("sampling_residual", false, m_account.residual);
    if (m_account.melted > 0.0) info.figures["melted_kg"] = m_account.melted;
    if (m_account.refrozen > 0.0) info.figures["refrozen_kg"] = m_account.refrozen;
    if (m_account.slid > 0.0) info.figures["slid_kg"] = m_account.slid;
    if (m_account.roofShed > 0.0) info.figures["slid_off_models_kg"] = m_account.roofShed;
    if (m_account.drifted > 0.0) info.figures["taken_up_by_wind_kg"] = m_account.drifted;
    if (m_account.unsettled > 0.0) info.figures["cells_still_sliding"] = m_account.unsettled;
    if (m_account.clamped > 0.0) info.figures["published_law_growth_refused_kg"] = m_account.clamped;
    if (m_account.guardedSeconds > 0.0)
      info.figures["published_law_guarded_m2_h"] = m_account.guardedSeconds / 3600.0;
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
  std::unique_ptr<CoverCells> m_cells;
  Account m_account;
};

}  // namespace

ProcessType coverProcessType() {
  return {"cover", 400, snowHasGround,
          [] { return std::unique_ptr<Process>(std::make_unique<CoverProcess>()); }};
}

}  // namespace spin
