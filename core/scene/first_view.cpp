// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/first_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "core/fields/terrain_surface.h"

namespace spin {

std::optional<Vec3d> groundNear(const Raster<float>& heights, double column, double row) {
  std::optional<Vec3d> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (int j = 0; j < heights.height; ++j)
    for (int i = 0; i < heights.width; ++i) {
      const double distance = (i - column) * (i - column) + (j - row) * (j - row);
      if (distance >= least || std::isnan(heights.at(i, j))) continue;
      least = distance;
      nearest = Vec3d{heights.x(i), heights.y(j), static_cast<double>(heights.at(i, j))};
    }
  return nearest;
}

namespace {

constexpr int kSides = 16;
constexpr double kTilt = 0.24;         // height of the eye above the target, share of the distance
constexpr double kEyeClearance = 0.1;  // above the ground below it, likewise
constexpr double kHalfFov = 22.5;      // degrees, half the camera's default field of view
constexpr double kSkyline = 0.75;      // where it stands best: share of the picture's height

/// How high the ground stands against the sky beyond the eye along a direction in plan: tangent of its
/// elevation. The target's own counts at least.
double skyline(const TerrainSurface& surface, Vec3d eye, Vec2d along, double reach, double least) {
  constexpr int kSteps = 96;
  double highest = least;
  for (int step = 1; step <= kSteps; ++step) {
    const double d = reach * step / kSteps;
    if (const auto h = surface.heightAt(eye.x + along.x * d, eye.y + along.y * d))
      highest = std::max(highest, (*h - eye.z) / d);
  }
  return highest;
}

/// How far the skyline stands from its best place, as a mean over the middle of the picture.
double unsuited(const TerrainSurface& surface, const FirstView& view, double reach) {
  const Vec3d way = view.target - view.position;
  const double flat = std::hypot(way.x, way.y), azimuth = std::atan2(way.y, way.x);
  const double tilt = radiansToDegrees(std::atan2(way.z, flat));
  double sum = 0.0;
  for (const double aside : {-20.0, -10.0, 0.0, 10.0, 20.0}) {
    const double a = azimuth + degreesToRadians(aside);
    const double line = skyline(surface, view.position, {std::cos(a), std::sin(a)}, reach, way.z / flat);
    const double place = 0.5 + 0.5 * (radiansToDegrees(std::atan(line)) - tilt) / kHalfFov;
    sum += std::abs(place - kSkyline);
  }
  return sum;
}

/// Which way the terrain falls as a whole: down the plane that fits it best; south where that is level.
Vec2d downhillOf(const Raster<float>& heights, Vec2d middle) {
  double xx = 0.0, xy = 0.0, yy = 0.0, xz = 0.0, yz = 0.0;
  for (int j = 0; j < heights.height; ++j)
    for (int i = 0; i < heights.width; ++i) {
      const double z = static_cast<double>(heights.at(i, j));
      if (std::isnan(z)) continue;
      const double x = i - middle.x, y = j - middle.y;
      xx += x * x;
      xy += x * y;
      yy += y * y;
      xz += x * z;
      yz += y * z;
    }
  const double det = xx * yy - xy * xy;
  if (det <= 1e-9 * xx * yy) return {0.0, -1.0};
  const Vec2d rise{(xz * yy - yz * xy) / det, (yz * xx - xz * xy) / det};
  const double size = std::hypot(rise.x, rise.y);
  return size > 0.01 * heights.cellSize ? rise * (-1.0 / size) : Vec2d{0.0, -1.0};
}

/// Mean column and row of the cells with data; nothing if there are none.
std::optional<Vec2d> middleOf(const Raster<float>& heights) {
  Vec2d sum{};
  std::size_t count = 0;
  for (int j = 0; j < heights.height; ++j)
    for (int i = 0; i < heights.width; ++i) {
      if (std::isnan(heights.at(i, j))) continue;
      sum = sum + Vec2d{static_cast<double>(i), static_cast<double>(j)};
      ++count;
    }
  if (count == 0) return {};
  return sum * (1.0 / static_cast<double>(count));
}

/// Distance of the eye from the middle of a box at which the box just fits into the picture.
double fittingDistance(const Box3d& box, Vec3d back) {
  constexpr double kAspect = 1.5;  // narrower than most views
  constexpr double kMargin = 1.08;
  const Vec3d right = normalized(cross(Vec3d{0, 0, 1}, back)), up = cross(back, right);
  const double high = std::tan(degreesToRadians(kHalfFov)) / kMargin, wide = kAspect * high;
  double distance = 1.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d p = Vec3d{corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                          corner & 4 ? box.max.z : box.min.z} -
                    box.centre();
    const double nearer = dot(p, back);
    distance =
        std::max({distance, nearer + std::abs(dot(p, right)) / wide, nearer + std::abs(dot(p, up)) / high});
  }
  return distance;
}

}  // namespace

std::optional<FirstView> wholeViewOf(const Raster<float>& heights) {
  constexpr double kPitch = 15.0;  // degrees; the horizon then stands in the picture
  const std::optional<Vec2d> middle = middleOf(heights);
  if (!middle) return {};
  const Vec2d down = downhillOf(heights, *middle);
  const double pitch = degreesToRadians(kPitch);
  const Vec3d back{std::cos(pitch) * down.x, std::cos(pitch) * down.y, std::sin(pitch)};
  const Box3d box = boundsOf(heights);
  return FirstView{box.centre() + back * fittingDistance(box, back), box.centre()};
}

std::optional<FirstView> firstViewOf(const Raster<float>& heights) {
  const std::optional<Vec2d> middle = middleOf(heights);
  if (!middle) return {};
  const std::optional<Vec3d> target = groundNear(heights, middle->x, middle->y);
  if (!target) return {};
  const double extent = heights.cellSize * std::min(heights.width, heights.height);
  const double reach = heights.cellSize * (heights.width + heights.height);
  const double distance = std::clamp(0.8 * extent, 10.0, kFarthestFirstView);
  const TerrainSurface surface(heights);
  FirstView best{*target, *target};
  double least = std::numeric_limits<double>::infinity();
  for (int side = 0; side < kSides; ++side) {
    const double turn = 2.0 * kPi * side / kSides;
    Vec3d eye = *target + Vec3d{-std::sin(turn), -std::cos(turn), 0.0} * distance;
    const double ground = surface.heightAt(eye.x, eye.y).value_or(target->z);
    eye.z = std::max(ground + kEyeClearance * distance, target->z + kTilt * distance);
    const FirstView view{eye, *target};
    const double fault = unsuited(surface, view, reach);
    if (fault >= least) continue;
    least = fault;
    best = view;
  }
  return best;
}

}  // namespace spin
