// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/lossless/predictor_fitting.h"

#include <cmath>
#include <optional>

namespace roomcast::codec {
namespace {

constexpr int kRowStep = 8;
constexpr int kMinSamples = 64;  // of a class; with fewer, the median suffices
constexpr int kLargestError =
    60;  // of the median; a larger one is at an edge, which says nothing about surfaces
constexpr double kRidge = 0.05;  // per sample; keeps weights small where neighbours hardly differ
constexpr double kLargestWeight = 1.9;

/// Normal equations of one class.
struct Fit {
  std::array<std::array<std::int64_t, kWeightCount>, kWeightCount> squares{};
  std::array<std::int64_t, kWeightCount> products{};
  std::int64_t samples = 0;
};
using Fits = std::array<Fit, kLinearClassCount>;

/// Calls `visit(neighbours, value)` for readings with readings all around.
template <class Visit>
void for_each_sample(ImageView<const std::uint16_t> plane, Visit visit) {
  for (int y = 2; y < plane.height; y += kRowStep) {
    const std::uint16_t* row = plane.row(y);
    const std::uint16_t* above = plane.row(y - 1);
    const std::uint16_t* above2 = plane.row(y - 2);
    for (int x = 2; x + 1 < plane.width; ++x) {
      const Neighbours at{row[x - 1], above[x - 1], above[x],    above[x + 1],
                          row[x - 2], above2[x],    above[x - 2]};
      if (row[x] && at.w && at.nw && at.n && at.ne && at.ww && at.nn && at.nww) visit(at, row[x]);
    }
  }
}

Fits gather(ImageView<const std::uint16_t> plane) {
  Fits fits{};
  for_each_sample(plane, [&](const Neighbours& at, int value) {
    const int c = class_of(at);
    if (c >= kLinearClassCount || std::abs(value - median_prediction(at)) > kLargestError) return;
    const std::array<int, kWeightCount> d{at.w - at.n,  at.nw - at.n, at.ne - at.n,
                                          at.ww - at.n, at.nn - at.n, at.nww - at.n};
    Fit& fit = fits[static_cast<std::size_t>(c)];
    ++fit.samples;
    for (int i = 0; i < kWeightCount; ++i) {
      fit.products[i] += d[i] * (value - at.n);
      for (int j = 0; j <= i; ++j) fit.squares[i][j] += d[i] * d[j];
    }
  });
  return fits;
}

/// Solves the normal equations by Cholesky decomposition; the ridge makes them positive definite.
std::array<double, kWeightCount> solve(const Fit& fit) {
  double lower[kWeightCount][kWeightCount] = {};
  std::array<double, kWeightCount> x{};
  for (int i = 0; i < kWeightCount; ++i) {
    for (int j = 0; j <= i; ++j) {
      double sum = static_cast<double>(fit.squares[i][j]);
      if (i == j) sum += 1 + kRidge * static_cast<double>(fit.samples);
      for (int k = 0; k < j; ++k) sum -= lower[i][k] * lower[j][k];
      lower[i][j] = i == j ? std::sqrt(sum) : sum / lower[j][j];
    }
    double sum = static_cast<double>(fit.products[i]);
    for (int k = 0; k < i; ++k) sum -= lower[i][k] * x[k];
    x[i] = sum / lower[i][i];
  }
  for (int i = kWeightCount - 1; i >= 0; --i) {
    for (int k = i + 1; k < kWeightCount; ++k) x[i] -= lower[k][i] * x[k];
    x[i] /= lower[i][i];
  }
  return x;
}

Predictor rounded(const std::array<double, kWeightCount>& weights) {
  Predictor predictor{true, {}};
  for (int i = 0; i < kWeightCount; ++i) {
    const double bounded = std::clamp(weights[i], -kLargestWeight, kLargestWeight);
    predictor.weights[i] = static_cast<std::int8_t>(std::lround(bounded * (1 << kWeightShift)));
  }
  return predictor;
}

/// Approximate bits of an error, doubled.
int cost(int error) {
  return quantise(static_cast<std::uint32_t>(std::abs(error)));
}

/// Removes the weights of classes where the median does as well.
void drop_useless_weights(ImageView<const std::uint16_t> plane, Predictors& predictors) {
  std::array<std::int64_t, kClassCount> gain{};
  for_each_sample(plane, [&](const Neighbours& at, int value) {
    const auto c = static_cast<std::size_t>(class_of(at));
    if (!predictors[c].linear) return;
    gain[c] += cost(value - median_prediction(at)) -
               cost(value - linear_prediction(at, predictors[c].weights));
  });
  for (int c = 0; c < kLinearClassCount; ++c) {
    constexpr int kPrice = 2 * 8 * kWeightCount / kRowStep;
    if (gain[c] <= kPrice) predictors[c] = {};
  }
}

}  // namespace

Predictors fit_predictors(ImageView<const std::uint16_t> plane) {
  const Fits fits = gather(plane);
  Predictors predictors{};
  for (int c = 0; c < kLinearClassCount; ++c) {
    if (fits[c].samples >= kMinSamples) predictors[c] = rounded(solve(fits[c]));
  }
  drop_useless_weights(plane, predictors);
  return predictors;
}

}  // namespace roomcast::codec
