// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/nodes/weather_nodes.h"

#include "core/base/units.h"

namespace spin {
namespace {

constexpr Choice kPhases[] = {
    {"snow", SPIN_TR("Always snow")},
    {"by_temperature", SPIN_TR("Snow or rain by temperature")},
};

constexpr Choice kSuns[] = {
    {"none", SPIN_TR("None")},
    {"pictured", SPIN_TR("As in pictures")},
    {"by_date", SPIN_TR("By date")},
};

constexpr PropertyRow kWeatherRows[] = {
    property<&WeatherNode::airTemperature>("air_temperature_k", SPIN_TR("Air temperature"),
                                           SPIN_TR("Temperature of the air; sets the density of new snow."))
        .in(Unit::Kelvin)
        .range(213.15, 333.15, 0.5)
        .animated(),
    property<&WeatherNode::windSpeed>("wind_speed_m_s", SPIN_TR("Wind speed"),
                                      SPIN_TR("Mean wind; tilts the fall of the snow."))
        .in(Unit::MetrePerSecond)
        .range(0, 80, 0.5)
        .animated(),
    property<&WeatherNode::windFromDegrees>("wind_from_deg", SPIN_TR("Wind from"),
                                            SPIN_TR("Direction the wind comes from: 0 north, 90 east."))
        .in(Unit::Degree)
        .range(-720, 720, 5)
        .animated(),
    property<&WeatherNode::precipitationRate>(
        "precipitation_rate_kg_m2_s", SPIN_TR("Precipitation"),
        SPIN_TR("Water that falls on level ground; it rules picture and cover alike."))
        .in(Unit::PrecipitationRate)
        .range(0, 500.0 / 3600.0, 0.5 / 3600.0)
        .animated(),
    property<&WeatherNode::phase>(
        "precipitation_phase", SPIN_TR("Falls as"),
        SPIN_TR("Snow whatever the air's temperature, or at every place what its air and humidity make of "
                "it."))
        .oneOf(kPhases),
    property<&WeatherNode::sunAzimuthDegrees>("sun_azimuth_deg", SPIN_TR("Sun azimuth"),
                                              SPIN_TR("Direction of the sun from north through east."))
        .in(Unit::Degree)
        .range(-720, 720, 5)
        .animated()
        .affecting(Affects::Picture),
    property<&WeatherNode::sunElevationDegrees>("sun_elevation_deg", SPIN_TR("Sun elevation"),
                                                SPIN_TR("Height of the sun above the horizon."))
        .in(Unit::Degree)
        .range(-20, 90, 1)
        .animated()
        .affecting(Affects::Picture),
    property<&WeatherNode::cloudCover>("cloud_cover", SPIN_TR("Cloud cover"),
                                       SPIN_TR("0 is a clear sky, 1 an overcast one; clouds soften the sun."))
        .in(Unit::Factor)
        .range(0, 1, 0.05)
        .animated(),
    property<&WeatherNode::relativeHumidity>(
        "relative_humidity", SPIN_TR("Humidity"),
        SPIN_TR("Relative humidity of the air; dry air lets snow vanish without melting."))
        .in(Unit::Factor)
        .range(0, 1, 0.05)
        .animated(),
    property<&WeatherNode::source>(
        "source", SPIN_TR("Station record"),
        SPIN_TR("Text file of a weather station, a row per step: year, month, day, hour (UTC), shortwave and "
                "longwave W/m2, snowfall and rainfall kg/(m2 s), air temperature K, humidity %, wind m/s, "
                "pressure Pa. It replaces the values above but the wind's direction and the speed that tilts "
                "the fall."))
        .path(),
    property<&WeatherNode::start>(
        "start_utc", SPIN_TR("Film begins"),
        SPIN_TR("Date and time (UTC) at which the film begins, as 2005-10-01 00:00. Empty: at the begin of "
                "the station record.")),
    property<&WeatherNode::sun>(
        "melting_sun", SPIN_TR("Sun that melts"),
        SPIN_TR("None: as at night or under the thickest cloud. As in pictures: the sun that azimuth and "
                "elevation set. By date: where date and place put it, with day, season and the shadow of "
                "mountains."))
        .oneOf(kSuns),
    property<&WeatherNode::lightByDate>(
        "light_by_date", SPIN_TR("Sun of the date lights"),
        SPIN_TR("Pictures have the sun of date and place, nights too; off: azimuth and elevation."))
        .affecting(Affects::Picture),
    property<&WeatherNode::latitudeDegrees>("latitude_deg", SPIN_TR("Latitude"),
                                            SPIN_TR("Of the scene, north positive; for the sun."))
        .in(Unit::Degree)
        .range(-90, 90, 1),
    property<&WeatherNode::longitudeDegrees>("longitude_deg", SPIN_TR("Longitude"),
                                             SPIN_TR("Of the scene, east positive; for the sun."))
        .in(Unit::Degree)
        .range(-180, 180, 1),
    property<&WeatherNode::altitudeKnown>(
        "altitude_known", SPIN_TR("Weather of an altitude"),
        SPIN_TR("The weather was measured at the altitude below; off: at the terrain's lowest point.")),
    property<&WeatherNode::altitude>("altitude_m", SPIN_TR("Altitude"),
                                     SPIN_TR("Height above sea level at which the weather was measured."))
        .in(Unit::Metre)
        .range(-500, 9000, 50),
    property<&WeatherNode::lapseRate>(
        "lapse_rate_k_m", SPIN_TR("Cooling upwards"),
        SPIN_TR("How much colder the air is higher up; 6.5 K/km is usual, 0 gives one temperature."))
        .in(Unit::KelvinPerMetre)
        .range(-0.02, 0.02, 0.0005),
    property<&WeatherNode::precipitationGradient>(
        "precipitation_gradient_m", SPIN_TR("More precipitation upwards"),
        SPIN_TR("How much more falls higher up, as a share of what falls where the weather was measured."))
        .in(Unit::PercentPerHundredMetres)
        .range(-0.002, 0.005, 0.0001),
};

constexpr Choice kFlakeTypes[] = {
    {"dendrite_aggregate", SPIN_TR("Dendrite aggregates, unrimed")},
    {"rimed_aggregate", SPIN_TR("Dendrite aggregates, densely rimed")},
    {"graupel", SPIN_TR("Hexagonal graupel")},
};

constexpr Choice kFlakePaths[] = {
    {"drag_and_flutter", SPIN_TR("Drag and flutter")},
    {"decaying_sine", SPIN_TR("Decaying sine")},
};

constexpr PropertyRow kSnowfallRows[] = {
    property<&SnowfallNode::type>(
        "type", SPIN_TR("Type of snow"),
        SPIN_TR("Sets mass and fall speed of the flakes (Locatelli and Hobbs 1974)."))
        .oneOf(kFlakeTypes),
    property<&SnowfallNode::rateFactor>("rate_factor", SPIN_TR("Rate factor"),
                                        SPIN_TR("Factor on the weather's precipitation."))
        .in(Unit::Factor)
        .range(0, 10, 0.1)
        .animated(),
    property<&SnowfallNode::oldSnowDepth>(
        "old_snow_depth_m", SPIN_TR("Old snow"),
        SPIN_TR(
            "Depth of the snow that lies on open level ground when the film begins. It fell with the wind "
            "of the first frame: steep slopes shed it, and sheltered places have less."))
        .in(Unit::Metre)
        .range(0, 20, 0.1),
    property<&SnowfallNode::oldSnowDensity>("old_snow_density_kg_m3", SPIN_TR("Density of old snow"),
                                            SPIN_TR("Density of the snow that lies when the film begins."))
        .in(Unit::KilogramPerCubicMetre)
        .range(10, 917, 10),
    property<&SnowfallNode::fallSpreadDegrees>(
        "fall_spread_deg", SPIN_TR("Fall spread"),
        SPIN_TR("Half-angle of the cone of fall directions; softens the edge of shelter."))
        .in(Unit::Degree)
        .range(0, 60, 1),
    property<&SnowfallNode::path>(
        "path", SPIN_TR("Path"),
        SPIN_TR("Drag and flutter: flakes follow the wind and swing steadily. Decaying sine: they fall at "
                "their terminal speed and swing in bursts that die away, wider and faster in wind."))
        .oneOf(kFlakePaths),
    property<&SnowfallNode::flutterAmplitude>("flutter_amplitude_m", SPIN_TR("Flutter amplitude"),
                                              SPIN_TR("Sideways swing of a flake about its path."))
        .in(Unit::Metre)
        .range(0, 2, 0.05),
    property<&SnowfallNode::flutterRate>("flutter_rate_rad_s", SPIN_TR("Flutter rate"),
                                         SPIN_TR("Angular rate of the swing, rad/s."))
        .in(Unit::PerSecond)
        .range(0, 50, 0.5),
    property<&SnowfallNode::gustIntensity>(
        "gust_intensity", SPIN_TR("Gustiness"),
        SPIN_TR("Strength of the gusts as a share of the mean wind: 0.1 over water, 0.2 in the open, 0.3 and "
                "more among houses and trees."))
        .in(Unit::Factor)
        .range(0, 1, 0.05)
        .animated(),
    property<&SnowfallNode::gustLength>("gust_length_m", SPIN_TR("Size of gusts"),
                                        SPIN_TR("Wavelength of the largest eddies in the wind."))
        .in(Unit::Metre)
        .range(2, 500, 1),
    property<&SnowfallNode::boxSize>(
        "box_m", SPIN_TR("Flake box"),
        SPIN_TR("Edge of the box round the camera in which flakes are drawn; beyond it snow is haze."))
        .in(Unit::Metre)
        .range(2, 500, 1)
        .affecting(Affects::Picture),
    property<&SnowfallNode::groups>(
        "groups", SPIN_TR("Distance groups"),
        SPIN_TR("Shells round the camera: the farther one is, the fewer and larger its flakes, so that each "
                "hides as much of what is behind it as the precipitation asks for."))
        .range(3, 10, 1)
        .affecting(Affects::Picture),
    property<&SnowfallNode::flakeCount>(
        "flake_count", SPIN_TR("Flakes drawn"),
        SPIN_TR("Number of flakes in the box; each stands for as many real ones as the precipitation asks "
                "for. The more, the finer the snow."))
        .range(0, 2000000, 1000)
        .affecting(Affects::Picture),
    property<&SnowfallNode::sizeLawA>(
        "size_law_a_m2", SPIN_TR("Near size limit"),
        SPIN_TR("Constant A of the size on screen, h S / sqrt(A + B D + C D^2), C being the lens: keeps near "
                "flakes small. 0 is perspective as it is."))
        .range(0, 100, 0.01)
        .affecting(Affects::Picture),
    property<&SnowfallNode::sizeLawB>(
        "size_law_b_m", SPIN_TR("Size falloff"),
        SPIN_TR(
            "Linear term B of the size on screen: flakes shrink faster with the distance D at first. 0 is "
            "perspective as it is."))
        .range(0, 100, 0.01)
        .affecting(Affects::Picture),
};

}  // namespace

constinit const NodeType kWeatherType = nodeType<WeatherNode>(
    "weather", SPIN_TR("Weather"), SPIN_TR("Air, wind, precipitation and sun."), true, kWeatherRows);
constinit const NodeType kSnowfallType = nodeType<SnowfallNode>(
    "snowfall", SPIN_TR("Snowfall"), SPIN_TR("Falling snow and the cover it lays."), true, kSnowfallRows);

Vec3d windVector(double speed, double fromDegrees) {
  const double a = degreesToRadians(fromDegrees);
  return {-speed * std::sin(a), -speed * std::cos(a), 0.0};
}

Vec3d sunDirection(double azimuthDegrees, double elevationDegrees) {
  const double a = degreesToRadians(azimuthDegrees), e = degreesToRadians(elevationDegrees);
  return {std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e)};
}

}  // namespace spin
