// SPDX-License-Identifier: Apache-2.0
#include "bench/real/page_parts.h"

#include <cmath>

#include <fmt/format.h>

#include "bench/real/noise_chart.h"
#include "roomcast/core/markup_text.h"

namespace roomcast::bench {
namespace {

std::string table(const std::string& title, const std::string& head, const std::string& rows) {
  if (rows.empty()) return {};
  return "<h3>" + title + "</h3><div class=\"wide\"><table><tr>" + head + rows + "</table></div>\n";
}

std::string depth_scale_text(const alignment::SensorReport& sensor) {
  if (sensor.depth_scale_standard_error == 0) return "";
  return fmt::format("{:.4f} &plusmn; {:.4f}", sensor.depth_scale,
                     sensor.depth_scale_standard_error);
}

std::string ball_rows(const std::vector<BallGap>& gaps) {
  std::string rows;
  for (const BallGap& gap : gaps) {
    rows += fmt::format("<tr><td>{} and {}<td>{}<td>{:.0f}<td>{:.0f}\n", markup_text(gap.a),
                        markup_text(gap.b), gap.instants, gap.median_mm, gap.expected_mm);
  }
  return rows;
}

std::string loop_rows(const std::vector<Loop>& loops) {
  std::string rows;
  for (const Loop& loop : loops) {
    rows +=
        fmt::format("<tr><td>{}, {}, {}<td>{:.0f}<td>{:.2f}\n", markup_text(loop.a),
                    markup_text(loop.b), markup_text(loop.c), loop.closure_mm, loop.closure_deg);
  }
  return rows;
}

std::string known_rows(const std::vector<PoseGap>& gaps) {
  std::string rows;
  for (const PoseGap& gap : gaps) {
    rows += fmt::format("<tr><td>{}<td>{:.0f}<td>{:.2f}\n", markup_text(gap.sensor),
                        gap.from_known_mm, gap.from_known_deg);
  }
  return rows;
}

std::string interference_row(const SensorCondition& sensor) {
  if (!sensor.interference.is_known) {
    return "<tr><td>" + markup_text(sensor.sensor) +
           "<td colspan=\"5\" class=\"text\">it sees too little that stands still\n";
  }
  return fmt::format("<tr><td>{}<td>{:.2f} %<td>{:.2f} %<td>{:.2f}<td>{:.2f} %<td>{:.2f} %\n",
                     markup_text(sensor.sensor), 100 * sensor.interference.flickering,
                     100 * sensor.filtered.flickering, sensor.interference.noise_ratio,
                     100 * sensor.held, 100 * sensor.changed);
}

/// Sums of what is a number.
struct Means {
  double psnr_db = 0, ssim = 0, covered = 0, wrong_depth = 0;
  int pictures = 0, judged = 0;

  void add(const LeftOutPicture& picture) {
    ++pictures;
    covered += picture.covered;
    if (std::isnan(picture.psnr_db)) return;
    ++judged;
    psnr_db += picture.psnr_db;
    ssim += picture.ssim;
    wrong_depth += picture.wrong_depth;
  }
};

}  // namespace

std::string placement_html(const alignment::AlignmentReport& alignment) {
  std::string rows;
  for (const alignment::SensorReport& sensor : alignment.sensors) {
    rows += "<tr><td>" + markup_text(sensor.id);
    rows += sensor.placed ? fmt::format("<td>{:.0f}<td>{:.2f}<td>{}", sensor.expected_error_mm,
                                        sensor.expected_error_deg, depth_scale_text(sensor))
                          : std::string("<td>not placed<td><td>");
    rows += "<td class=\"text\">" + markup_text(sensor.reason) + "\n";
  }
  return table("Placement",
               "<th>Sensor<th>Expected error, mm<th>Degrees<th>Depth scale<th "
               "class=\"text\">Alignment says\n",
               rows);
}

std::string judgement_html(const RigJudgement& judgement) {
  return table("The ball, which alignment was not given",
               "<th>Sensors<th>Instants<th>Between its two places, median mm<th>Expected, mm\n",
               ball_rows(judgement.ball)) +
         table("Against the poses of the recording", "<th>Sensor<th>Off, mm at 2.5 m<th>Degrees\n",
               known_rows(judgement.known)) +
         table("Loops of three pairs", "<th>Sensors<th>Open by, mm at 2.5 m<th>Degrees\n",
               loop_rows(judgement.loops));
}

std::string conditions_html(const std::vector<SensorCondition>& conditions) {
  std::string rows;
  for (const SensorCondition& sensor : conditions) rows += interference_row(sensor);
  const std::string chart = noise_chart(conditions);
  return (chart.empty() ? "" : "<h3>Noise, learnt from the frames</h3>" + chart) +
         table("Infrared interference",
               "<th>Sensor<th>Still readings that come and go<th>after the filter<th>Largest noise "
               "of a frame, usual = 1<th>Readings held by the filter<th>changed\n",
               rows);
}

std::string bytes_html(const std::vector<SensorBytes>& bytes) {
  if (bytes.empty()) return {};
  std::string head = "<th class=\"text\">Codec", rows;
  for (const char* what : {"depth, bytes a frame", "MB/s"}) {
    for (const SensorBytes& sensor : bytes)
      head += "<th>" + markup_text(sensor.sensor) + ": " + what;
  }
  for (std::size_t i = 0; i < bytes.front().rows.size(); ++i) {
    rows += "<tr><td class=\"text\">" + markup_text(bytes.front().rows[i].mode);
    for (const SensorBytes& sensor : bytes)
      rows +=
          i < sensor.rows.size() ? fmt::format("<td>{:.0f}", sensor.rows[i].depth_bytes) : "<td>";
    for (const SensorBytes& sensor : bytes)
      rows += i < sensor.rows.size() ? fmt::format("<td>{:.2f}", sensor.rows[i].mb_per_s) : "<td>";
    rows += "\n";
  }
  return table("Bytes at 30 frames/s", head + "\n", rows);
}

std::string left_out_html(const std::vector<LeftOutPicture>& pictures) {
  std::map<std::string, Means> by_sensor;
  for (const LeftOutPicture& picture : pictures) by_sensor[picture.sensor].add(picture);
  std::string rows;
  for (const auto& [sensor, means] : by_sensor) {
    rows += fmt::format("<tr><td>{}<td>{:.0f} %", markup_text(sensor),
                        100 * means.covered / means.pictures);
    rows += means.judged == 0
                ? "<td><td><td>\n"
                : fmt::format("<td>{:.1f}<td>{:.2f}<td>{:.0f} %\n", means.psnr_db / means.judged,
                              means.ssim / means.judged, 100 * means.wrong_depth / means.judged);
  }
  return table("Each sensor drawn from the others",
               "<th>Left out<th>Covered by the others<th>PSNR there, dB<th>SSIM<th>Wrong depth\n",
               rows);
}

}  // namespace roomcast::bench
