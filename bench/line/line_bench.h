// SPDX-License-Identifier: Apache-2.0
// `roomcast bench line`: what the sensors of a room cost on their line.
//
//   unwatched  bytes and CPU time of simulated sensors while nobody watches the room, relative to
//              those while somebody does, and how long the first viewer waits for a whole picture
//
//   rate       bytes over seconds and tenths of seconds of sensors with a target rate, and the age
//              of their frames, on an emulated link; needs root
//
//   uplink     the same of sensors that share the uplink of their room, also while a viewer turns
//              round; needs root
//
//   auto       share of an emulated link that sensors use which estimate what it carries, and the
//              age of their frames, while the link becomes slower and faster; needs root
//
//   late       how much of a link a sensor gets that comes while another one uses it; both estimate
//              what it carries; needs root
//
//   loss       how long pictures stand still on a line that loses packets, stands still, or becomes
//              half as fast: the sensors' or the viewer's; needs root
//
//   viewer     what a viewer with a slow line gets, with and without the sensors' small renditions;
//              needs root
//
//   looking    bytes that a viewer gets who walks along a path, relative to one who gets all
//   frames,
//              and what he loses by it: PSNR to the true view, and pictures that come late; and
//              what the sensors send to him when he is alone
//
// The CPU time is that of this process: sensors, hub, and a viewer that does not decode.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "bench/figure.h"
#include "roomcast/core/result.h"

namespace roomcast::bench {

struct LineBenchOptions {
  std::vector<std::string> cases = {"unwatched"};
  std::string scene = "studio";  // of simulated sensors
  int sensors = 3;
  std::chrono::milliseconds duration{10'000};            // of each measurement
  std::vector<double> target_mbit = {0.5, 1, 2, 5, 10};  // of all sensors; of a viewer's line
  std::vector<double> link_mbit = {8, 2, 8};             // rates of the link, one after the other
  std::chrono::milliseconds rate_warm_up{15'000};        // bundles and first key frames are sent
  std::filesystem::path viewer_path = {};  // case looking; empty: a walk round the room
  int first_viewers = 5;                   // viewers who come into an unwatched room
};

struct LineReport {
  std::vector<Figure> figures;
};

/// `progress` is called with a description of the current measurement. Errors: those of the hub
/// and of the sensors.
[[nodiscard]] Result<LineReport> run_line_bench(
    const LineBenchOptions& options, const std::function<void(const std::string&)>& progress);

/// The case `unwatched`; adds its figures.
[[nodiscard]] Status measure_unwatched(const LineBenchOptions& options,
                                       const std::function<void(const std::string&)>& progress,
                                       LineReport& report);

/// The case `rate`; adds its figures. kUnsupported: not root, or no TUN devices.
[[nodiscard]] Status measure_rate(const LineBenchOptions& options,
                                  const std::function<void(const std::string&)>& progress,
                                  LineReport& report);

/// The case `uplink`; adds its figures. kUnsupported: not root, or no TUN devices.
[[nodiscard]] Status measure_uplink(const LineBenchOptions& options,
                                    const std::function<void(const std::string&)>& progress,
                                    LineReport& report);

/// The case `auto`; adds its figures. kUnsupported: not root, or no TUN devices.
[[nodiscard]] Status measure_auto(const LineBenchOptions& options,
                                  const std::function<void(const std::string&)>& progress,
                                  LineReport& report);

/// The case `late`; adds its figures. kUnsupported: not root, or no TUN devices.
[[nodiscard]] Status measure_late(const LineBenchOptions& options,
                                  const std::function<void(const std::string&)>& progress,
                                  LineReport& report);

/// The case `loss`; adds its figures. kUnsupported: not root, or no TUN devices.
[[nodiscard]] Status measure_loss(const LineBenchOptions& options,
                                  const std::function<void(const std::string&)>& progress,
                                  LineReport& report);

/// The case `viewer`; adds its figures. kUnsupported: not root, or no TUN devices.
[[nodiscard]] Status measure_viewer(const LineBenchOptions& options,
                                    const std::function<void(const std::string&)>& progress,
                                    LineReport& report);

/// The case `looking`; adds its figures.
[[nodiscard]] Status measure_looking(const LineBenchOptions& options,
                                     const std::function<void(const std::string&)>& progress,
                                     LineReport& report);

void print_table(const LineReport& report, std::ostream& out);
void print_json(const LineReport& report, std::ostream& out);

}  // namespace roomcast::bench
