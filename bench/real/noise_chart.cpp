// SPDX-License-Identifier: Apache-2.0
#include "bench/real/noise_chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "roomcast/core/axis_step.h"
#include "roomcast/core/markup_text.h"

namespace roomcast::bench {
namespace {

constexpr double kWidth = 560, kHeight = 240, kLeft = 48, kRight = 90, kTop = 12, kBottom = 36;
constexpr int kAxisSteps = 4;
constexpr std::array kColors{"#2f6fdb", "#c2571a", "#2c8a4b", "#8a3fb0", "#b02a4c", "#4d5663"};

struct Scale {
  double most_m, most_mm;

  [[nodiscard]] double x(double distance_m) const {
    return kLeft + (kWidth - kLeft - kRight) * distance_m / most_m;
  }
  [[nodiscard]] double y(double sigma_mm) const {
    return kHeight - kBottom - (kHeight - kTop - kBottom) * sigma_mm / most_mm;
  }
};

std::string axes(const Scale& scale) {
  std::string svg;
  for (double m = 0; m <= scale.most_m; m += axis_step(scale.most_m, kAxisSteps)) {
    svg += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\">{:g}</text>",
                       scale.x(m), kHeight - kBottom + 16, m);
  }
  for (double mm = 0; mm <= scale.most_mm; mm += axis_step(scale.most_mm, kAxisSteps)) {
    svg += fmt::format(
        "<path d=\"M{:.0f} {:.1f}H{:.0f}\" stroke=\"#d5d9df\"/><text x=\"{:.0f}\" y=\"{:.1f}\" "
        "text-anchor=\"end\">{:g}</text>",
        kLeft, scale.y(mm), kWidth - kRight, kLeft - 6, scale.y(mm) + 4, mm);
  }
  return svg + fmt::format(
                   "<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\">distance, m</text><text "
                   "x=\"12\" y=\"{:.0f}\" transform=\"rotate(-90 12 {:.0f})\" "
                   "text-anchor=\"middle\">noise, mm</text>",
                   0.5 * (kLeft + kWidth - kRight), kHeight - 4, 0.5 * kHeight, 0.5 * kHeight);
}

std::string line(const SensorCondition& condition, const Scale& scale, const char* color,
                 int number) {
  std::string points;
  for (const NoiseAtDistance& noise : condition.noise)
    points += fmt::format("{:.1f},{:.1f} ", scale.x(noise.distance_m), scale.y(noise.sigma_mm));
  return fmt::format(
      "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/><text x=\"{:.0f}\" "
      "y=\"{:.0f}\" fill=\"{}\">{}</text>",
      points, color, kWidth - kRight + 10, kTop + 16 + 18 * number, color,
      markup_text(condition.sensor));
}

}  // namespace

std::string noise_chart(const std::vector<SensorCondition>& conditions) {
  Scale scale{0, 0};
  for (const SensorCondition& condition : conditions) {
    for (const NoiseAtDistance& noise : condition.noise) {
      scale.most_m = std::max(scale.most_m, 1.05 * noise.distance_m);
      scale.most_mm = std::max(scale.most_mm, 1.1 * noise.sigma_mm);
    }
  }
  if (scale.most_mm <= 0 || scale.most_m <= 0) return {};
  std::string svg = fmt::format(
      "<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"noise of each sensor by "
      "distance\">{}",
      kWidth, kHeight, axes(scale));
  for (std::size_t i = 0; i < conditions.size(); ++i)
    svg += line(conditions[i], scale, kColors[i % kColors.size()], static_cast<int>(i));
  return svg + "</svg>\n";
}

}  // namespace roomcast::bench
