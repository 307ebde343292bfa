// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/season_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/units.h"
#include "core/bench/json_value.h"
#include "core/fields/number_table.h"
#include "core/snow/ground_materials.h"

namespace spin {
namespace {

Error badSite(const std::string& where, std::string why) {
  return badInput("The site could not be used", where, std::move(why));
}

/// Reads members of a site, the first problem kept.
class SiteReader {
 public:
  SiteReader(const BenchJson& json, std::string where) : m_json(json), m_where(std::move(where)) {}

  template <class T>
  void number(const char* name, double least, double most, T& value) {
    const BenchJson* found = m_json.find(name);
    if (!found) return;
    if (found->kind != BenchJson::Kind::Number || !(found->number >= least && found->number <= most))
      return fail(fmt::format("{} is no number from {} to {}", name, least, most));
    value = static_cast<T>(found->number);
  }
  void truth(const char* name, bool& value) {
    const BenchJson* found = m_json.find(name);
    if (!found) return;
    if (found->kind != BenchJson::Kind::Bool) return fail(fmt::format("{} is neither true nor false", name));
    value = found->boolean;
  }
  std::vector<double> numbers(const char* name, double least, double most) {
    std::vector<double> values;
    const BenchJson* found = m_json.find(name);
    if (!found) return values;
    for (const BenchJson& item : found->items) {
      if (item.kind != BenchJson::Kind::Number || !(item.number >= least && item.number <= most)) break;
      values.push_back(item.number);
    }
    if (found->kind != BenchJson::Kind::List || values.empty() || values.size() != found->items.size() ||
        values.size() > 100)
      fail(fmt::format("{} is no list of numbers from {} to {}", name, least, most));
    return values;
  }
  void ground(SnowSite& site) {
    const BenchJson* found = m_json.find("ground");
    if (found && found->kind != BenchJson::Kind::String) return fail("ground is no text");
    if (found) site.groundName = found->text;
    for (int type = 0; type < kGroundTypeCount; ++type)
      if (site.groundName == kGroundTypeChoices[static_cast<std::size_t>(type)].id) {
        site.ground = groundMaterial(static_cast<GroundType>(type));
        return;
      }
    fail(fmt::format("there is no ground type '{}'", site.groundName));
  }

  void fail(std::string why) {
    if (m_status) m_status = badSite(m_where, std::move(why));
  }
  const Status& status() const { return m_status; }

 private:
  const BenchJson& m_json;
  std::string m_where;
  Status m_status;
};

/// The profile at a depth: linear between the middles of its layers, held beyond.
double profileAt(const std::vector<double>& temperatures, const std::vector<double>& layers, double depth) {
  double top = 0.0, before = 0.0;
  for (std::size_t i = 0; i < temperatures.size(); ++i) {
    const double middle = top + 0.5 * layers[i];
    if (depth <= middle && i == 0) return temperatures[0];
    if (depth <= middle)
      return temperatures[i - 1] +
             (temperatures[i] - temperatures[i - 1]) * (depth - before) / (middle - before);
    before = middle;
    top += layers[i];
  }
  return temperatures.back();
}

void readSoil(SiteReader& reader, SnowSite& site) {
  const std::vector<double> temperatures = reader.numbers("soil_temperature_K", 200.0, 330.0);
  std::vector<double> layers = reader.numbers("soil_layers_m", 0.001, 100.0);
  if (temperatures.empty()) return;
  // Each of them twice as thick as the one above, where nothing is said.
  const bool given = !layers.empty();
  for (double thickness = 0.1; !given && layers.size() < temperatures.size(); thickness *= 2.0)
    layers.push_back(thickness);
  if (layers.size() != temperatures.size())
    return reader.fail("soil_layers_m is not as long as soil_temperature_K");
  double top = 0.0;
  for (const float thickness : site.ground.thickness) {
    const double middle = top + 0.5 * static_cast<double>(thickness);
    site.soil.push_back(static_cast<float>(kelvinToCelsius(profileAt(temperatures, layers, middle))));
    top += static_cast<double>(thickness);
  }
}

/// Where no soil was measured: the mean air temperature of the first month, as warm as unfrozen ground.
void assumeSoil(SeasonFiles& season) {
  const auto steps = static_cast<std::size_t>(30 * 86400 / season.weather.step);
  const std::size_t count = std::min(std::max<std::size_t>(steps, 1), season.weather.records.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum += season.weather.records[i].airTemperature;
  const double mean = kelvinToCelsius(sum / static_cast<double>(count));
  season.site.soil.assign(kSoilLayers, static_cast<float>(mean));
}

struct SeasonPaths {
  std::string met, obs, site;
};

std::vector<SeasonPaths> seasonsIn(const std::filesystem::path& folder) {
  std::vector<SeasonPaths> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().stem().string();
    if (!name.starts_with("met_")) continue;
    const std::string season = name.substr(4), ending = entry.path().extension().string();
    found.push_back({entry.path().string(), (folder / ("obs_" + season + ending)).string(),
                     (folder / ("site_" + season + ".json")).string()});
  }
  std::sort(found.begin(), found.end(),
            [](const SeasonPaths& a, const SeasonPaths& b) { return a.met < b.met; });
  return found;
}

Result<SeasonFiles> loadSeason(const SeasonPaths& paths) {
  const Result<std::string> met = readTextFile(paths.met), obs = readTextFile(paths.obs),
                            siteText = readTextFile(paths.site);
  for (const Result<std::string>* text : {&met, &obs, &siteText})
    if (!*text) return text->error();
  Result<WeatherSeries> weather = readWeather(*met, paths.met);
  if (!weather) return weather.error();
  Result<std::vector<SnowObservation>> observations = readObservations(*obs, paths.obs);
  if (!observations) return observations.error();
  Result<SnowSite> site = readSnowSite(*siteText, paths.site);
  if (!site) return site.error();
  SeasonFiles season{std::move(*weather), std::move(*observations), std::move(*site),
                     std::filesystem::path(paths.met).stem().string()};
  if (season.site.soil.empty()) assumeSoil(season);
  return season;
}

}  // namespace

Result<SnowSite> readSnowSite(const std::string& text, const std::string& where) {
  const Result<BenchJson> json = parseBenchJson(text);
  if (!json) return badSite(where, json.error().why);
  if (json->kind != BenchJson::Kind::Object) return badSite(where, "it is no JSON object");
  SnowSite site;
  SiteReader reader(*json, where);
  double latitude = 0.0, longitude = 0.0;
  reader.number("latitude_deg", -90.0, 90.0, latitude);
  reader.number("longitude_deg", -360.0, 360.0, longitude);
  site.latitude = degreesToRadians(latitude);
  site.longitude = degreesToRadians(longitude);
  reader.number("elevation_m", -500.0, 9000.0, site.elevation);
  reader.number("temperature_height_m", 0.2, 100.0, site.parameters.airHeight);
  reader.number("wind_height_m", 0.2, 100.0, site.parameters.windHeight);
  reader.truth("temperature_height_above_snow", site.parameters.airAboveSnow);
  reader.truth("wind_height_above_snow", site.parameters.windAboveSnow);
  reader.ground(site);
  reader.number("soil_conductivity_W_mK", 0.01, 20.0, site.ground.conductivity);
  reader.number("soil_heat_capacity_J_m3K", 1e5, 1e7, site.ground.heatCapacity);
  reader.number("soil_water_kg_m3", 0.0, 1000.0, site.ground.frozenWater);
  reader.number("ground_albedo", 0.0, 1.0, site.ground.albedo);
  reader.number("ground_roughness_m", 1e-4, 5.0, site.ground.roughness);
  readSoil(reader, site);
  if (!reader.status()) return reader.status().error();
  return site;
}

Result<std::vector<SeasonFiles>> loadSeasons(const BenchOptions& options) {
  std::vector<SeasonPaths> paths;
  const auto named = [&](const char* name) {
    const auto file = options.files.find(name);
    return file == options.files.end() ? std::string() : file->second;
  };
  const SeasonPaths own{named("met"), named("obs"), named("site")};
  const bool any = !own.met.empty() || !own.obs.empty() || !own.site.empty();
  if (any && (own.met.empty() || own.obs.empty() || own.site.empty()))
    return Error{ErrorKind::Usage, "The season could not be read", "--met, --obs, --site",
                 "one of them is missing", "Name all three"};
  if (any)
    paths.push_back(own);
  else if (!options.dataDirectory.empty())
    paths = seasonsIn(std::filesystem::path(options.dataDirectory) / "snowcover");
  std::vector<SeasonFiles> seasons;
  for (const SeasonPaths& files : paths) {
    Result<SeasonFiles> season = loadSeason(files);
    if (!season) return season.error();
    seasons.push_back(std::move(*season));
  }
  return seasons;
}

}  // namespace spin
