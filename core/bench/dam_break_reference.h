// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Measured dam breaks: figures published in the papers named here (facts, to be used with the citation).
namespace spin {

struct FrontPoint {
  double t, x;
};

/// Koshizuka and Oka 1996: a column 1 m wide and 2 m high; front in m over s.
inline constexpr FrontPoint kKoshizukaOkaFront[] = {
    {0.092, 1.128}, {0.1907, 1.244}, {0.2663, 1.464}, {0.3221, 1.695}, {0.3681, 1.903},
    {0.414, 2.123}, {0.4466, 2.365}, {0.4958, 2.584}, {0.5219, 2.804}, {0.5646, 3.034},
    {0.594, 3.219}, {0.6366, 3.462}, {0.6693, 3.704}, {0.7021, 3.9},   {0.7513, 4.132}};

/// Martin and Moyce 1952: columns twice as high as wide, 2.25 inches wide; front over the width, by
/// t sqrt(2 g / width). Their series with 1.125 inches differs from this one by 4.7 %.
inline constexpr FrontPoint kMartinMoyceFront[] = {
    {0.832, 1.217}, {1.219, 1.474},  {1.997, 2.292},  {2.547, 2.995},  {3.345, 4.134},
    {4.034, 4.944}, {4.418, 5.881},  {5.091, 6.98},   {5.685, 7.945},  {6.306, 8.966},
    {6.822, 9.986}, {7.439, 10.963}, {8.031, 11.977}, {8.633, 13.005}, {9.237, 13.97}};
/// The series with 1.125 inches.
inline constexpr FrontPoint kMartinMoyceNarrowFront[] = {
    {0.849, 1.245}, {1.212, 1.443}, {1.602, 1.884}, {2.283, 2.689}, {2.95, 3.728},
    {3.598, 4.528}, {3.905, 4.999}, {4.592, 5.841}, {4.961, 6.271}, {5.316, 6.717}};

/// A pressure sensor on the far wall: T = t sqrt(g/H), P = p/(rho g H).
struct ImpactSensor {
  const char* id;
  double height;     ///< m above the floor
  double arrival;    ///< T at which the water comes
  double low, high;  ///< P of the plateau
};
/// Lobovsky et al. 2014: 0.3 m of water, 0.6 m long, in a tank of 1.61 m; plateau from T = 4.1 to 5.4.
inline constexpr double kLobovskyDepth = 0.3, kLobovskyLength = 0.6, kLobovskyTank = 1.61;
inline constexpr double kLobovskyPlateau[2] = {4.1, 5.4};
inline constexpr ImpactSensor kLobovskySensors[] = {
    {"P1", 0.003, 2.43, 0.53, 0.61}, {"P3", 0.030, 2.49, 0.55, 0.65}, {"P4", 0.080, 2.73, 0.46, 0.48}};

}  // namespace spin
