// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Steady flow in a square of side 1 whose upper side slides with speed 1: solutions of the stream-function
/// equations by Newton's method on 128^2 and 256^2 cells, extrapolated to none, at the places of Ghia, Ghia
/// and Shin (1982), J. Comput. Phys. 48; they agree with the extrema of Botella and Peyret (1998) to about
/// 1e-5.
namespace spin {

inline constexpr int kCavityReynolds[] = {100, 400, 1000};

struct CavityPoint {
  double at;        ///< share of the side
  double speed[3];  ///< for each of kCavityReynolds
};

/// u along the middle x = 1/2 over the height.
inline constexpr CavityPoint kCavityU[] = {
    {0.9766, {0.84348, 0.76033, 0.66413}},    {0.9688, {0.79161, 0.68682, 0.58055}},
    {0.9609, {0.74071, 0.62027, 0.51729}},    {0.9531, {0.69119, 0.56179, 0.47253}},
    {0.8516, {0.23645, 0.29201, 0.33718}},    {0.7344, {0.00415, 0.16254, 0.18863}},
    {0.6172, {-0.13881, 0.02102, 0.05699}},   {0.5, {-0.20915, -0.11505, -0.06207}},
    {0.4531, {-0.21398, -0.17145, -0.10819}}, {0.2813, {-0.15765, -0.32875, -0.28043}},
    {0.1719, {-0.10173, -0.24376, -0.38864}}, {0.1016, {-0.06441, -0.14615, -0.30033}},
    {0.0703, {-0.04663, -0.10332, -0.22287}}, {0.0625, {-0.04198, -0.0926, -0.20227}},
    {0.0547, {-0.03722, -0.08181, -0.1812}}};
/// The vertical velocity along the middle of the height over x.
inline constexpr CavityPoint kCavityV[] = {
    {0.9688, {-0.06229, -0.12538, -0.22828}}, {0.9609, {-0.0779, -0.16142, -0.29334}},
    {0.9531, {-0.09334, -0.1981, -0.35509}},  {0.9453, {-0.10851, -0.23468, -0.41027}},
    {0.9063, {-0.17716, -0.38986, -0.52647}}, {0.8594, {-0.23371, -0.45386, -0.42642}},
    {0.8047, {-0.25354, -0.38565, -0.3202}},  {0.5, {0.05754, 0.05205, 0.02579}},
    {0.2344, {0.17956, 0.30347, 0.32541}},    {0.2266, {0.17936, 0.30385, 0.33406}},
    {0.1563, {0.16481, 0.28354, 0.37695}},    {0.0938, {0.12639, 0.23168, 0.33298}},
    {0.0781, {0.11178, 0.21102, 0.30995}},    {0.0703, {0.1036, 0.19883, 0.2963}},
    {0.0625, {0.09481, 0.18515, 0.28071}}};

}  // namespace spin
