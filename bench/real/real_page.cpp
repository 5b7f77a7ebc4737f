// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <sstream>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "bench/real/real_bench.h"
#include "roomcast/io/file_bytes.h"
#include "roomcast/io/image_file.h"

namespace roomcast::bench {
namespace {

constexpr int kPictureQuality = 90;  // of JPEG

constexpr const char* kHead =
    "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\">"
    "<meta name=\"viewport\" content=\"width=device-width\"><title>roomcast: real rigs</title>"
    "<style>body{font:16px/1.5 system-ui,sans-serif;max-width:72rem;margin:2rem auto;padding:0 "
    "1rem;color:#1c1f24}"
    "table{border-collapse:collapse;margin:1rem 0}td,th{padding:.25rem .75rem;border-bottom:1px "
    "solid #d5d9df;text-align:right}"
    "td:first-child,th:first-child,td.text,th.text{text-align:left}"
    "figure{margin:1.5rem 0}figure div{display:grid;grid-template-columns:1fr 1fr;gap:.5rem}"
    "img{width:100%;background:#000}figcaption{margin-top:.25rem}h2{margin-top:3rem}"
    "</style><h1>Real rigs</h1>"
    "<p>Every figure on this page comes from recordings of real or simulated sensors, as each "
    "heading says. Left: what the sensor saw. Right: the same view, drawn from the other sensors "
    "only.</p>\n";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '&':
        out += "&amp;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string alignment_table_html(const alignment::AlignmentReport& report) {
  std::string html =
      "<table><tr><th>Sensor<th>Expected error, mm<th>Degrees<th class=\"text\">Alignment says\n";
  for (const alignment::SensorReport& sensor : report.sensors) {
    html += "<tr><td>" + escaped(sensor.id);
    html += sensor.placed ? fmt::format("<td>{:.0f}<td>{:.2f}", sensor.expected_error_mm,
                                        sensor.expected_error_deg)
                          : std::string("<td>not placed<td>");
    html += "<td class=\"text\">" + escaped(sensor.reason) + "\n";
  }
  return html + "</table>\n";
}

std::string bytes_table_html(const std::vector<SensorBytes>& all) {
  if (all.empty()) return {};
  std::string html =
      "<table><tr><th>Sensor<th class=\"text\">Codec<th>Depth, bytes a frame<th>Colour, bytes a "
      "frame<th>MB/s at 30 frames/s\n";
  for (const SensorBytes& bytes : all) {
    for (const CodecBenchRow& row : bytes.rows) {
      html += fmt::format("<tr><td>{}<td class=\"text\">{} {}<td>{:.0f}<td>{:.0f}<td>{:.2f}\n",
                          escaped(bytes.sensor), escaped(row.codec), escaped(row.mode),
                          row.depth_bytes, row.color_bytes, row.mb_per_s);
    }
  }
  return html + "</table>\n";
}

std::string caption(const LeftOutPicture& picture) {
  const std::string shown =
      fmt::format("{}, frame {}: the others show {:.0f} % of it", escaped(picture.sensor),
                  picture.frame, 100 * picture.covered);
  if (std::isnan(picture.psnr_db)) return shown + ".";
  return shown + fmt::format("; there PSNR {:.1f} dB, SSIM {:.2f}, depth wrong in {:.1f} %.",
                             picture.psnr_db, picture.ssim, 100 * picture.wrong_depth);
}

Status write_figure(const LeftOutPicture& picture, const std::filesystem::path& folder,
                    const std::string& name, std::string& html) {
  for (const auto& [part, image] :
       {std::pair{"own", &picture.own}, std::pair{"drawn", &picture.drawn}}) {
    const auto file = folder / fmt::format("{}-{}.jpg", name, part);
    auto status = io::write_color_jpeg(file, *image, kPictureQuality);
    if (!status) return status;
  }
  html += fmt::format(
      "<figure><div><img src=\"{0}-own.jpg\" alt=\"what the sensor saw\"><img "
      "src=\"{0}-drawn.jpg\" alt=\"drawn from the others\"></div><figcaption>{1}</figcaption>"
      "</figure>\n",
      name, caption(picture));
  return {};
}

}  // namespace

Status write_page(const std::vector<RealReport>& reports, const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return Error{ErrorCode::kUnavailable,
                 "cannot make the folder " + folder.string() + ": " + error.message()};
  }
  std::string html = kHead;
  for (std::size_t rig = 0; rig < reports.size(); ++rig) {
    const RealReport& report = reports[rig];
    html += "<h2>" + escaped(report.rig) + "</h2><p>" + escaped(report.source) + "</p>\n" +
            alignment_table_html(report.alignment) + bytes_table_html(report.bytes);
    if (!report.not_drawn.empty()) {
      html += "<p>Nothing was drawn: " + escaped(report.not_drawn) + "</p>\n";
    }
    for (std::size_t i = 0; i < report.left_out.size(); ++i) {
      // Names of sensors come from a file and may contain anything; numbers cannot leave the
      // folder.
      const std::string name = fmt::format("rig{}-picture{}", rig, i);
      auto status = write_figure(report.left_out[i], folder, name, html);
      if (!status) return status;
    }
  }
  return io::write_file(folder / "index.html", html);
}

}  // namespace roomcast::bench
