// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/curves/rate_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "roomcast/core/axis_step.h"
#include "roomcast/core/markup_text.h"

namespace roomcast::bench {
namespace {

constexpr double kPanelWidth = 420, kPanelHeight = 330, kPanelLeft = 46, kPanelTop = 62;
constexpr int kValueSteps = 5;
constexpr double kPanelBottom = 44, kPanelGap = 26, kLegendRow = 20;
// Dark enough on white, and told apart by people who see colours differently (Okabe & Ito 2008).
constexpr std::array kCurveColors{"#0072b2", "#56b4e9", "#d55e00", "#009e73", "#cc79a7",
                                  "#8a6d00", "#222222", "#9467bd", "#7f7f7f"};

struct Range {
  double low = 0, high = 0;
};

/// From what the curves have, with a twentieth to spare.
Range values_of(const RatePanel& panel) {
  Range range{1e300, -1e300};
  for (const RateCurve& curve : panel.curves) {
    for (const RatePoint& point : curve.points) {
      range.low = std::min(range.low, point.value);
      range.high = std::max(range.high, point.value);
    }
  }
  const double spare = std::max(0.05 * (range.high - range.low), 0.01);
  return {range.low - spare, range.high + spare};
}

/// Of all panels, so that they can be compared; whole steps of 1, 2 or 5 are drawn.
Range rates_of(const std::vector<RatePanel>& panels) {
  Range range{1e300, 0};
  for (const RatePanel& panel : panels) {
    for (const RateCurve& curve : panel.curves) {
      for (const RatePoint& point : curve.points) {
        range.low = std::min(range.low, point.mbit_per_s);
        range.high = std::max(range.high, point.mbit_per_s);
      }
    }
  }
  return {range.low / 1.15, range.high * 1.15};
}

std::vector<double> steps_of_ten(const Range& range) {
  std::vector<double> steps;
  for (double power = std::pow(10, std::floor(std::log10(range.low))); power <= range.high;
       power *= 10) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double step = factor * power;
      if (step >= range.low && step <= range.high) steps.push_back(step);
    }
  }
  return steps;
}

std::vector<double> even_steps(const Range& range) {
  const double step = axis_step(range.high - range.low, kValueSteps);
  std::vector<double> steps;
  for (double at = std::ceil(range.low / step) * step; at <= range.high; at += step)
    steps.push_back(std::abs(at) < 1e-9 * step ? 0 : at);
  return steps;
}

/// Where a rate and a value are in the drawing.
struct PanelPlace {
  double left;
  Range rates, values;
  [[nodiscard]] double x(double mbit_per_s) const {
    return left + kPanelWidth * std::log(mbit_per_s / rates.low) / std::log(rates.high / rates.low);
  }
  [[nodiscard]] double y(double value) const {
    return kPanelTop + kPanelHeight * (values.high - value) / (values.high - values.low);
  }
};

std::string panel_axes(const RatePanel& panel, const PanelPlace& at) {
  std::string svg =
      fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" font-weight=\"600\">{}, {}</text>", at.left,
                  kPanelTop - 12, markup_text(panel.title), markup_text(panel.unit));
  const double bottom = kPanelTop + kPanelHeight;
  for (const double mbit : steps_of_ten(at.rates)) {
    svg += fmt::format(
        "<path d=\"M{0:.1f} {1:.0f}V{2:.0f}\" stroke=\"#e3e6ea\"/><text x=\"{0:.1f}\" "
        "y=\"{3:.0f}\" text-anchor=\"middle\">{4:g}</text>",
        at.x(mbit), kPanelTop, bottom, bottom + 17, mbit);
  }
  for (const double value : even_steps(at.values)) {
    svg += fmt::format(
        "<path d=\"M{0:.0f} {1:.1f}H{2:.0f}\" stroke=\"#e3e6ea\"/><text x=\"{3:.0f}\" "
        "y=\"{4:.1f}\" text-anchor=\"end\">{5:g}</text>",
        at.left, at.y(value), at.left + kPanelWidth, at.left - 6, at.y(value) + 4, value);
  }
  return svg + fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\">Mbit/s</text>",
                           at.left + 0.5 * kPanelWidth, bottom + 36);
}

std::string curve_line(const RateCurve& curve, const PanelPlace& at, const char* color) {
  std::string points, dots;
  for (const RatePoint& point : curve.points) {
    const double x = at.x(point.mbit_per_s), y = at.y(point.value);
    points += fmt::format("{:.1f},{:.1f} ", x, y);
    dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"/>", x, y, color);
  }
  return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>",
                     points, color) +
         dots;
}

std::vector<std::string> names_of(const std::vector<RatePanel>& panels) {
  std::vector<std::string> names;
  for (const RatePanel& panel : panels) {
    for (const RateCurve& curve : panel.curves) {
      if (std::ranges::find(names, curve.name) == names.end()) names.push_back(curve.name);
    }
  }
  return names;
}

const char* color_of(const std::vector<std::string>& names, const std::string& name) {
  const auto number = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  return kCurveColors[number % kCurveColors.size()];
}

std::string legend(const std::vector<std::string>& names) {
  std::string svg;
  double x = kPanelLeft;
  for (const std::string& name : names) {
    const char* color = color_of(names, name);
    svg += fmt::format(
        "<circle cx=\"{0:.0f}\" cy=\"{1:.0f}\" r=\"4.5\" fill=\"{2}\"/><text x=\"{3:.0f}\" "
        "y=\"{4:.0f}\">{5}</text>",
        x, kLegendRow - 4, color, x + 10, kLegendRow, markup_text(name));
    x += 30 + 7.2 * static_cast<double>(name.size());
  }
  return svg;
}

using ValueOf = std::function<std::optional<double>(const CodecBenchRow&)>;

RatePanel panel_of(const CodecBenchReport& report, std::string title, std::string unit,
                   double CodecBenchRow::*bytes, const ValueOf& value) {
  RatePanel panel{std::move(title), std::move(unit), {}};
  for (const CodecBenchRow& row : report.rows) {
    const std::optional<double> here = value(row);
    const double mbit_per_s = 8e-6 * row.*bytes * report.fps;
    if (row.curve.empty() || !here || mbit_per_s <= 0) continue;
    auto curve = std::ranges::find(panel.curves, row.curve, &RateCurve::name);
    if (curve == panel.curves.end())
      curve = panel.curves.insert(panel.curves.end(), RateCurve{row.curve, {}});
    curve->points.push_back({mbit_per_s, *here});
  }
  for (RateCurve& curve : panel.curves) std::ranges::sort(curve.points, {}, &RatePoint::mbit_per_s);
  return panel;
}

ValueOf depth_figure(std::optional<double> DepthQuality::*figure) {
  return
      [figure](const CodecBenchRow& row) { return row.depth ? *row.depth.*figure : std::nullopt; };
}

std::optional<double> color_figure(const CodecBenchRow& row) {
  return row.color_psnr_surface_y ? row.color_psnr_surface_y : row.color_psnr_y;
}

}  // namespace

std::vector<RatePanel> rate_panels(const CodecBenchReport& report) {
  std::vector<RatePanel> panels = {
      panel_of(report, "Depth that stands still: error", "mm RMS", &CodecBenchRow::depth_bytes,
               depth_figure(&DepthQuality::rms_noise_free_static_mm)),
      panel_of(report, "Depth that moves: error", "mm RMS", &CodecBenchRow::depth_bytes,
               depth_figure(&DepthQuality::rms_noise_free_moving_mm)),
      panel_of(report, "Colour: PSNR", "dB", &CodecBenchRow::color_bytes, color_figure)};
  std::erase_if(panels, [](const RatePanel& panel) { return panel.curves.empty(); });
  return panels;
}

std::string rate_chart(const std::vector<RatePanel>& panels, const std::string& caption) {
  const double across = kPanelLeft + kPanelWidth + kPanelGap;
  const double width = std::max(across * static_cast<double>(panels.size()), across);
  const double height = kPanelTop + kPanelHeight + kPanelBottom + 30;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"13\" fill=\"#222\" role=\"img\" "
      "aria-label=\"{2}\">\n<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#fff\"/>\n",
      width, height, markup_text(caption));
  const std::vector<std::string> names = names_of(panels);
  svg += legend(names);
  const Range rates = rates_of(panels);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const PanelPlace at{kPanelLeft + across * static_cast<double>(i), rates, values_of(panels[i])};
    svg += panel_axes(panels[i], at);
    for (const RateCurve& curve : panels[i].curves)
      svg += curve_line(curve, at, color_of(names, curve.name)) + "\n";
  }
  return svg + fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" fill=\"#555\">{}</text>\n</svg>\n",
                           kPanelLeft, height - 14, markup_text(caption));
}

}  // namespace roomcast::bench
