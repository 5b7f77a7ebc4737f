// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/study_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "roomcast/core/axis_step.h"
#include "roomcast/core/csv_field.h"
#include "roomcast/core/markup_text.h"
#include "roomcast/io/file_bytes.h"
#include "roomcast/io/new_folder.h"

namespace roomcast::study {
namespace {

namespace fs = std::filesystem;

// Of a figure, pixels.
constexpr double kWidth = 640, kNames = 150, kRight = 20, kTop = 14, kRow = 46, kAxis = 40;
constexpr int kTicks = 5;

std::vector<double> values_of(const Measure& measure, const std::string& condition) {
  std::vector<double> values;
  if (const auto found = measure.values.find(condition); found != measure.values.end())
    for (const auto& [participant, value] : found->second) values.push_back(value);
  return values;
}

struct Axis {
  double from = 0, to = 1, step = 1;
  [[nodiscard]] double x(double value) const {
    return kNames + (value - from) / (to - from) * (kWidth - kNames - kRight);
  }
};

/// Includes all values and intervals, and ends at ticks.
Axis axis_of(const Measure& measure, const std::vector<std::string>& conditions) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const std::string& condition : conditions) {
    const std::vector<double> values = values_of(measure, condition);
    if (values.empty()) continue;
    const Summary summary = summary_of(values);
    const auto [low, high] = std::ranges::minmax(values);
    least = std::min({least, low, summary.mean - summary.half_width});
    most = std::max({most, high, summary.mean + summary.half_width});
  }
  if (!(most >= least)) return {};
  if (most - least < 1e-9) {
    if (least != 0) least -= 0.5;
    most += 0.5;
  }
  const double step = axis_step(most - least, kTicks);
  return {std::floor(least / step) * step, std::ceil(most / step) * step, step};
}

std::string ticks_svg(const Axis& axis, double bottom, const std::string& unit) {
  std::string svg;
  const int count = static_cast<int>(std::lround((axis.to - axis.from) / axis.step));
  for (int i = 0; i <= count; ++i) {
    const double value = axis.from + i * axis.step;
    const double x = axis.x(value);
    svg += fmt::format(
        R"(<path d="M{0:.1f} {1:.1f}V{2:.1f}" stroke="#ccc"/><text x="{0:.1f}" y="{3:.1f}" text-anchor="middle">{4:.6g}</text>)",
        x, kTop, bottom, bottom + 16, std::abs(value) < 1e-12 ? 0.0 : value);
  }
  if (!unit.empty())
    svg += fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="end">{}</text>)",
                       kWidth - kRight, bottom + 33, markup_text(unit));
  return svg;
}

std::string row_svg(const std::vector<double>& values, const std::string& name, double y,
                    const Axis& axis) {
  std::string svg = fmt::format(R"(<text x="{:.0f}" y="{:.1f}" text-anchor="end">{}</text>)",
                                kNames - 14, y + 5, markup_text(name));
  if (values.empty()) return svg;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double aside = (static_cast<double>(i * 7 % 5) - 2) * 3;  // so that equal ones are seen
    svg += fmt::format(
        R"(<circle cx="{:.1f}" cy="{:.1f}" r="3.5" fill="#0072b2" fill-opacity="0.45"/>)",
        axis.x(values[i]), y + aside);
  }
  const Summary summary = summary_of(values);
  svg += fmt::format(
      R"(<path d="M{0:.1f} {1:.1f}H{2:.1f}" stroke="#000" stroke-width="2"/><path d="M{3:.1f} {4:.1f}v20" stroke="#000" stroke-width="3"/>)",
      axis.x(summary.mean - summary.half_width), y, axis.x(summary.mean + summary.half_width),
      axis.x(summary.mean), y - 10);
  return svg;
}

constexpr const char* kHead = R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>{0}</title>
<style>
body {{ max-width: 46rem; margin: 2rem auto; padding: 0 1rem; font: 16px/1.5 sans-serif; color: #111; background: #fff; }}
svg {{ max-width: 100%; height: auto; }}
table {{ border-collapse: collapse; font-variant-numeric: tabular-nums; }}
th, td {{ padding: 2px 12px 2px 0; text-align: left; border-bottom: 1px solid #ccc; font-weight: normal; }}
</style>
<h1>{0}</h1>
<p>{1} of whom something is known. A dot is a participant, the thick mark their mean, the line its
95 % confidence interval (Student’s t). Roomcast’s guide of studies
explains the columns and measures.</p>
)";

std::string table_html(const Measure& measure, const std::vector<std::string>& conditions) {
  std::string html =
      "<table><thead><tr><th>condition<th>participants<th>mean<th>standard deviation<th>95 % "
      "interval</thead>\n";
  for (const std::string& condition : conditions) {
    const Summary s = summary_of(values_of(measure, condition));
    html += fmt::format("<tr><th>{}<td>{}", markup_text(condition), s.count);
    if (s.count == 0) {
      html += "<td>–<td>–<td>–\n";
    } else if (s.count == 1) {
      html += fmt::format("<td>{:.4g}<td>–<td>–\n", s.mean);
    } else {
      html += fmt::format("<td>{:.4g}<td>{:.4g}<td>{:.4g} to {:.4g}\n", s.mean, s.deviation,
                          s.mean - s.half_width, s.mean + s.half_width);
    }
  }
  return html + "</table>\n";
}

std::string comparisons_html(const std::vector<ComparisonSummary>& comparisons) {
  if (comparisons.empty()) return "";
  std::string html =
      "<h2>Paired comparisons</h2>\n<p>How often the photograph was chosen. Half of the time: the "
      "pictures cannot be told apart.</p>\n<table><thead><tr><th>comparison<th>answers<th>"
      "photograph chosen<th>share<th>95 % interval (Wilson)</thead>\n";
  for (const auto& [name, answers, correct, low, high] : comparisons)
    html += fmt::format("<tr><th>{}<td>{}<td>{}<td>{:.0f} %<td>{:.0f} to {:.0f} %\n",
                        markup_text(name), answers, correct,
                        100.0 * static_cast<double>(correct) / static_cast<double>(answers),
                        100 * low, 100 * high);
  return html + "</table>\n";
}

std::string report_html(const ConditionSummary& summary) {
  const std::string people =
      fmt::format("{} participant{}", summary.participants, summary.participants == 1 ? "" : "s");
  std::string html = fmt::format(fmt::runtime(kHead), markup_text(summary.title), people);
  for (const Measure& measure : summary.measures) {
    html += fmt::format("<h2>{}{}</h2>\n<p>{}</p>\n", markup_text(measure.title),
                        measure.unit.empty() ? "" : ", " + markup_text(measure.unit),
                        markup_text(measure.name));
    html +=
        figure_svg(measure, summary.conditions) + "\n" + table_html(measure, summary.conditions);
  }
  return html + comparisons_html(summary.comparisons) + "</html>\n";
}

std::string summary_csv(const ConditionSummary& summary) {
  std::string csv = "measure,unit,condition,participants,mean,deviation,low_95,high_95\r\n";
  for (const Measure& measure : summary.measures) {
    for (const std::string& condition : summary.conditions) {
      const Summary s = summary_of(values_of(measure, condition));
      csv += fmt::format("{},{},{},{},{:.10g},{:.10g},{:.10g},{:.10g}\r\n", csv_field(measure.name),
                         csv_field(measure.unit), csv_field(condition), s.count, s.mean,
                         s.deviation, s.mean - s.half_width, s.mean + s.half_width);
    }
  }
  return csv;
}

}  // namespace

std::string figure_svg(const Measure& measure, const std::vector<std::string>& conditions) {
  const Axis axis = axis_of(measure, conditions);
  const double bottom = kTop + kRow * static_cast<double>(conditions.size());
  std::string rows = ticks_svg(axis, bottom, measure.unit);
  for (std::size_t i = 0; i < conditions.size(); ++i)
    rows += row_svg(values_of(measure, conditions[i]), conditions[i],
                    kTop + kRow * (static_cast<double>(i) + 0.5), axis);
  return fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" font-family="sans-serif" font-size="13" role="img" aria-label="{2}">{3}</svg>)",
      kWidth, bottom + kAxis, markup_text(measure.title), rows);
}

Status write_report(const ConditionSummary& summary, const fs::path& out) {
  if (auto status = io::make_new_folder(out); !status) return status.error();
  for (const Measure& measure : summary.measures) {
    const std::string svg = figure_svg(measure, summary.conditions) + "\n";
    if (auto status = io::write_file(out / (measure.name + ".svg"), svg); !status) return status;
  }
  if (auto status = io::write_file(out / "summary.csv", summary_csv(summary)); !status)
    return status;
  return io::write_file(out / "report.html", report_html(summary));
}

}  // namespace roomcast::study
