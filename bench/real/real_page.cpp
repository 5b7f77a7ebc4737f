// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "bench/real/page_parts.h"
#include "bench/real/real_bench.h"
#include "roomcast/core/markup_text.h"
#include "roomcast/io/file_bytes.h"
#include "roomcast/io/image_file.h"
#include "roomcast/io/new_folder.h"

namespace roomcast::bench {
namespace {

constexpr int kPictureQuality = 90;  // of JPEG

constexpr const char* kHead =
    "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\">"
    "<meta name=\"viewport\" content=\"width=device-width\"><title>roomcast: rigs</title>"
    "<style>body{font:16px/1.5 system-ui,sans-serif;max-width:72rem;margin:2rem auto;padding:0 "
    "1rem;color:#1c1f24;background:#fff}"
    "table{border-collapse:collapse;margin:.5rem 0}td,th{padding:.25rem .75rem;border-bottom:1px "
    "solid #d5d9df;text-align:right;vertical-align:top}th{font-weight:600;font-size:.875rem}"
    "td:first-child,th:first-child,td.text,th.text{text-align:left}.wide{overflow-x:auto}"
    "figure{margin:1.5rem 0}figure div{display:grid;grid-template-columns:1fr 1fr;gap:.5rem}"
    "img{width:100%;background:#000}figcaption{margin-top:.25rem}h2{margin-top:3rem}"
    "h3{margin:1.75rem 0 .25rem}svg{max-width:36rem;width:100%;font:12px system-ui,sans-serif}"
    ".quiet{color:#5a626d}"
    "</style><h1>Rigs without truth</h1>"
    "<p>Every figure comes from the recordings named in the headings, real or simulated as their "
    "source says. Errors that alignment expects are one standard deviation, 2.5 m ahead of a "
    "sensor.</p>\n";

std::string caption(const LeftOutPicture& picture) {
  const std::string shown =
      fmt::format("{}, frame {}: the others show {:.0f} % of it", markup_text(picture.sensor),
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

Status write_figures(const RealReport& report, std::size_t rig, const std::filesystem::path& folder,
                     std::string& html) {
  if (!report.left_out.empty())
    html +=
        "<p class=\"quiet\">Left: what the sensor saw. Right: the same view, drawn from the "
        "other sensors only.</p>\n";
  for (std::size_t i = 0; i < report.left_out.size(); ++i) {
    // Names of sensors come from a file and may contain anything; numbers cannot leave the folder.
    auto status =
        write_figure(report.left_out[i], folder, fmt::format("rig{}-picture{}", rig, i), html);
    if (!status) return status;
  }
  return {};
}

}  // namespace

Status write_page(const std::vector<RealReport>& reports, const std::filesystem::path& folder) {
  if (auto status = io::make_folder(folder); !status) return status;
  std::string html = kHead;
  for (std::size_t rig = 0; rig < reports.size(); ++rig) {
    const RealReport& report = reports[rig];
    html += "<h2>" + markup_text(report.rig) + "</h2><p class=\"quiet\">" +
            markup_text(report.source) + "</p>\n" + placement_html(report.alignment) +
            judgement_html(report.judgement) + conditions_html(report.conditions) +
            bytes_html(report.bytes) + left_out_html(report.left_out);
    if (!report.not_drawn.empty())
      html += "<p>Nothing was drawn: " + markup_text(report.not_drawn) + "</p>\n";
    auto status = write_figures(report, rig, folder, html);
    if (!status) return status;
  }
  return io::write_file(folder / "index.html", html);
}

}  // namespace roomcast::bench
