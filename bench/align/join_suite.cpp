// SPDX-License-Identifier: Apache-2.0
#include "bench/align/join_suite.h"

#include <array>
#include <ctime>
#include <ostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/align/simulated_views.h"
#include "roomcast/alignment/rig/rig_aligner.h"

namespace roomcast::bench {
namespace {

constexpr std::array kScenes = {"livingroom", "office", "meeting", "lab"};

double cpu_s() {
  return double(std::clock()) / CLOCKS_PER_SEC;
}

/// The last view joins the others.
JoinedRoom joined(const std::vector<SimulatedView>& views) {
  alignment::RigAligner aligner;
  for (std::size_t i = 0; i + 1 < views.size(); ++i) {
    if (views[i].view) aligner.add(views[i].view);
  }
  (void)aligner.solve();
  JoinedRoom room;
  const SimulatedView& last = views.back();
  room.look_cpu_s = last.look_cpu_s;
  if (!last.view) return room;
  const double start_s = cpu_s();
  aligner.add(last.view);
  const alignment::AlignmentReport report = aligner.solve();
  room.place_cpu_s = cpu_s() - start_s;
  room.placed = report.sensors.back().placed;
  return room;
}

}  // namespace

Result<std::vector<JoinedRoom>> run_join_suite(const JoinSuiteOptions& options,
                                               const BenchProgress& progress) {
  std::vector<JoinedRoom> rooms;
  for (int i = 0; i < options.rooms; ++i) {
    const std::string scene = kScenes[static_cast<std::size_t>(i) % kScenes.size()];
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(i);
    if (progress) progress(fmt::format("room {} of {}: {} {}", i + 1, options.rooms, scene, seed));
    const auto views =
        simulate_views({scene, seed, options.there + 1, options.frames, options.sensing});
    if (!views) return views.error();
    rooms.push_back(joined(*views));
    rooms.back().scene = scene;
    rooms.back().seed = seed;
  }
  return rooms;
}

void print_table(const std::vector<JoinedRoom>& rooms, std::ostream& out) {
  out << "CPU seconds of one core for a sensor that joins four.\n"
      << fmt::format("{:<12} {:>6} {:>8} {:>10} {:>8} {:>8}\n", "scene", "seed", "placed",
                     "features", "place", "all");
  for (const JoinedRoom& room : rooms) {
    out << fmt::format("{:<12} {:>6} {:>8} {:>8.2f} s {:>6.2f} s {:>6.2f} s\n", room.scene,
                       room.seed, room.placed ? "yes" : "no", room.look_cpu_s, room.place_cpu_s,
                       room.look_cpu_s + room.place_cpu_s);
  }
}

void print_json(const std::vector<JoinedRoom>& rooms, std::ostream& out) {
  nlohmann::json json = {{"rooms", nlohmann::json::array()}};
  for (const JoinedRoom& room : rooms) {
    json["rooms"].push_back({{"scene", room.scene},
                             {"seed", room.seed},
                             {"placed", room.placed},
                             {"features_cpu_s", room.look_cpu_s},
                             {"place_cpu_s", room.place_cpu_s}});
  }
  out << json.dump(1) << "\n";
}

}  // namespace roomcast::bench
