// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/filters_opencv/filters_opencv_plugin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "core/property/text_mark.h"

namespace spin {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
/// Unpainted cells lie below all others for growing and shrinking.
constexpr float kLowest = -1e30f;

/// 1 where painted, 0 elsewhere.
cv::Mat paintedCells(const cv::Mat& values) {
  cv::Mat painted;
  cv::compare(values, values, painted, cv::CMP_EQ);  // NaN differs from itself
  painted.convertTo(painted, CV_32F, 1.0 / 255.0);
  return painted;
}

void setWhereUnpainted(cv::Mat& values, const cv::Mat& painted, float to) {
  values.setTo(cv::Scalar(static_cast<double>(to)), painted == 0.0);
}

/// Gaussian mean of the painted cells only, so that the blank ones do not pull the edge down.
cv::Mat blurred(const cv::Mat& values, double radius) {
  const cv::Mat painted = paintedCells(values);
  cv::Mat sum = values.clone(), weight;
  setWhereUnpainted(sum, painted, 0.0f);
  const double sigma = std::max(0.3, 0.5 * radius);
  cv::GaussianBlur(sum, sum, cv::Size(), sigma, sigma, cv::BORDER_CONSTANT);
  cv::GaussianBlur(painted, weight, cv::Size(), sigma, sigma, cv::BORDER_CONSTANT);
  cv::Mat mean;
  cv::divide(sum, cv::max(weight, 1e-12), mean);
  setWhereUnpainted(mean, painted, kNan);
  return mean;
}

/// Medians of 5 x 5 cells, the largest that exist for real numbers, one after the other.
cv::Mat medians(const cv::Mat& values, double radius) {
  const cv::Mat painted = paintedCells(values);
  cv::Mat work = values.clone(), around;
  // Blank cells join in with the mean of what is painted near them, then they are blank again.
  cv::Mat sum = values.clone(), weight;
  setWhereUnpainted(sum, painted, 0.0f);
  cv::boxFilter(sum, sum, CV_32F, cv::Size(9, 9), cv::Point(-1, -1), false, cv::BORDER_REPLICATE);
  cv::boxFilter(painted, weight, CV_32F, cv::Size(9, 9), cv::Point(-1, -1), false, cv::BORDER_REPLICATE);
  cv::divide(sum, cv::max(weight, 1.0), around);
  around.copyTo(work, painted == 0.0);
  const int passes = std::max(1, static_cast<int>(std::lround(radius / 2.0)));
  for (int pass = 0; pass < passes; ++pass) cv::medianBlur(work, work, radius < 1.5 ? 3 : 5);
  setWhereUnpainted(work, painted, kNan);
  return work;
}

/// Growing or shrinking by discs of two cells, as many as the radius holds: a large disc in one go would cost
/// its area per cell.
void morph(cv::Mat& values, cv::MorphTypes what, double radius) {
  const int cells = std::max(1, static_cast<int>(std::lround(radius)));
  const auto disc = [](int r) {
    return cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(2 * r + 1, 2 * r + 1));
  };
  const auto pass = [&](const cv::Mat& kernel, int times) {
    if (times == 0) return;
    if (what == cv::MORPH_DILATE)
      cv::dilate(values, values, kernel, cv::Point(-1, -1), times);
    else
      cv::erode(values, values, kernel, cv::Point(-1, -1), times);
  };
  pass(disc(2), cells / 2);
  pass(disc(1), cells % 2);
}

cv::Mat morphed(const cv::Mat& values, std::initializer_list<cv::MorphTypes> steps, double radius) {
  cv::Mat work = values.clone();
  setWhereUnpainted(work, paintedCells(values), kLowest);
  for (const cv::MorphTypes step : steps) morph(work, step, radius);
  work.setTo(cv::Scalar(static_cast<double>(kNan)), work == static_cast<double>(kLowest));
  return work;
}

/// Shares become all or nothing; of measures what is less is taken away.
cv::Mat thresholded(const cv::Mat& values, double threshold, bool shares) {
  cv::Mat work = values.clone();
  const cv::Mat below = values < threshold;
  work.setTo(cv::Scalar(shares ? 0.0 : static_cast<double>(kNan)), below);
  if (shares) work.setTo(cv::Scalar(1.0), values >= threshold);
  return work;
}

Status unusable(const std::string& id, const std::string& why) {
  return Error{ErrorKind::Failed, "The layer could not be filtered", id, why, "Try a smaller radius"};
}

cv::Mat filtered(const std::string& id, const LayerFilterSettings& settings, const cv::Mat& values) {
  const double r = std::clamp(settings.radius, 0.5, 200.0);
  if (id == "blur") return blurred(values, r);
  if (id == "median") return medians(values, r);
  if (id == "dilate") return morphed(values, {cv::MORPH_DILATE}, r);
  if (id == "erode") return morphed(values, {cv::MORPH_ERODE}, r);
  if (id == "open") return morphed(values, {cv::MORPH_ERODE, cv::MORPH_DILATE}, r);
  if (id == "close") return morphed(values, {cv::MORPH_DILATE, cv::MORPH_ERODE}, r);
  if (id == "threshold") return thresholded(values, settings.threshold, settings.shares);
  return cv::Scalar(1.0) - values;
}

}  // namespace

std::vector<LayerFilterInfo> FiltersOpencvPlugin::filters() const {
  return {
      {"blur", SPIN_TR("Blur"), SPIN_TR("Softens edges; what is not painted stays so."), true, false, false},
      {"median", SPIN_TR("Median"), SPIN_TR("Takes specks away and keeps edges."), true, false, false},
      {"dilate", SPIN_TR("Grow"), SPIN_TR("High values and painted areas grow."), true, false, false},
      {"erode", SPIN_TR("Shrink"), SPIN_TR("High values and painted areas shrink."), true, false, false},
      {"open", SPIN_TR("Remove specks"), SPIN_TR("Shrinks, then grows: small areas vanish."), true, false,
       false},
      {"close", SPIN_TR("Fill gaps"), SPIN_TR("Grows, then shrinks: small gaps close."), true, false, false},
      {"threshold", SPIN_TR("Threshold"),
       SPIN_TR("Shares become all or nothing; of other layers what is less is taken away."), false, true,
       false},
      {"invert", SPIN_TR("Invert"), SPIN_TR("What was full becomes empty and the other way round."), false,
       false, true},
  };
}

Status FiltersOpencvPlugin::apply(const std::string& id, const LayerFilterSettings& settings,
                                  Raster<float>& values) const {
  const std::vector<LayerFilterInfo> known = filters();
  if (std::none_of(known.begin(), known.end(), [&](const LayerFilterInfo& f) { return f.id == id; }))
    return unusable(id, "there is no filter of this name");
  if (values.empty()) return {};
  try {
    const cv::Mat before(values.height, values.width, CV_32F, values.values.data());
    const cv::Mat after = filtered(id, settings, before);
    after.copyTo(before);
  } catch (const cv::Exception& exception) {
    return unusable(id, exception.what());
  }
  return {};
}

}  // namespace spin
