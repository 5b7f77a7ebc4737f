// SPDX-License-Identifier: Apache-2.0
#include "bench/fanout/fanout_bench.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "bench/fanout/engine.h"
#include "bench/fanout/load.h"

namespace roomcast::bench {

namespace {

constexpr double kRoomFps = 30;
constexpr double kHeadFps = 10;  // also how often viewers tell of their heads
constexpr int kHeadViewers = 500;
constexpr int kRoomSensors = 4, kRoomViewers = 50, kWindow = 2;
/// Announced rate of publishers that are faster than cameras; the highest rate that a hub accepts.
constexpr double kMaxFps = 240;

struct LoadCase {
  std::string name;
  int publishers, viewers, stalled;
  double fps;  // 0: as fast as all viewers read
  Heads heads = Heads::kNotTold;
};

std::vector<LoadCase> load_cases(const FanoutBenchOptions& options) {
  std::vector<LoadCase> cases;
  for (const int viewers : options.viewers) cases.push_back({"max", 1, viewers, 0, 0});
  cases.push_back({"room", kRoomSensors, kRoomViewers, 0, kRoomFps});
  cases.push_back({"stall", kRoomSensors, kRoomViewers, kRoomViewers / 10, kRoomFps});
  cases.push_back({"heads", kRoomSensors, kHeadViewers, 0, kHeadFps, Heads::kTold});
  cases.push_back({"elsewhere", kRoomSensors, kHeadViewers, 0, kHeadFps, Heads::kElsewhere});
  std::erase_if(cases, [&](const LoadCase& load_case) {
    return std::ranges::find(options.loads, load_case.name) == options.loads.end();
  });
  return cases;
}

std::vector<std::unique_ptr<Engine>> all_engines() {
  std::vector<std::unique_ptr<Engine>> engines;
  engines.push_back(make_socket_loop(false));
  engines.push_back(make_hub(false));
  engines.push_back(make_beast());
  engines.push_back(make_nats());
  engines.push_back(make_redis());
  engines.push_back(make_mosquitto());
  engines.push_back(make_socket_loop(true));
  engines.push_back(make_hub(true));
  return engines;
}

bool is_wanted(const Engine& engine, const std::vector<std::string>& only) {
  return only.empty() || std::ranges::any_of(only, [&](const std::string& part) {
           return engine.name().find(part) != std::string::npos;
         });
}

/// Heads are the hub's alone.
bool takes(const Engine& engine, const LoadCase& load_case) {
  return load_case.heads == Heads::kNotTold || engine.name().starts_with("roomcast");
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  const auto at = static_cast<std::size_t>(q * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

double kb(std::size_t bytes) {
  return static_cast<double>(bytes) / 1024;
}

/// Measures one engine under one load, once.
Result<FanoutRow> measure(const Engine& engine, const LoadCase& load_case,
                          const FanoutBenchOptions& options) {
  FanoutRoom room;
  room.frame_bytes = options.frame_bytes;
  const bool is_paced = load_case.fps > 0;
  room.fps = is_paced ? load_case.fps : kMaxFps;
  room.real_time = is_paced;
  room.heads = load_case.heads;
  const auto running = engine.start(room);
  if (!running) return running.error();
  const ChildProcess& process = running->process;
  const std::size_t rss_empty = process.resident_bytes();
  auto load =
      Load::connect(*running, room, load_case.publishers, load_case.viewers, load_case.stalled);
  if (!load) return load.error();
  if (auto status = (*load)->warm_up(); !status) return status.error();

  const auto cpu_before = process.cpu_time();
  const std::size_t rss_before = process.resident_bytes();
  const auto begin = Load::Clock::now();
  const auto traffic = is_paced ? (*load)->run_paced(room.fps, 2 * options.duration)
                                : (*load)->run_closed(kWindow, options.duration);
  if (!traffic) return traffic.error();
  const std::chrono::duration<double> cpu = process.cpu_time() - cpu_before;
  const std::chrono::duration<double> wall = Load::Clock::now() - begin;

  FanoutRow row;
  row.engine = engine.name();
  row.load = load_case.name;
  row.viewers = load_case.viewers;
  row.tls = engine.encrypts();
  row.deliveries_per_cpu_s = static_cast<double>(traffic->deliveries) / cpu.count();
  row.cores = cpu / wall;
  row.p50_ms = quantile(traffic->latencies_ms, 0.5);
  row.p99_ms = quantile(traffic->latencies_ms, 0.99);
  const double rss_after = kb(process.resident_bytes());
  row.rss_per_viewer_kb = std::max(0.0, rss_after - kb(rss_empty)) / load_case.viewers;
  row.rss_growth_kb_per_s = std::max(0.0, rss_after - kb(rss_before)) / wall.count();
  return row;
}

double median_of(const std::vector<FanoutRow>& rounds, double FanoutRow::*field) {
  std::vector<double> values;
  for (const FanoutRow& row : rounds) values.push_back(row.*field);
  return quantile(std::move(values), 0.5);
}

FanoutRow median(const std::vector<FanoutRow>& rounds) {
  FanoutRow row = rounds.front();
  for (double FanoutRow::*field :
       {&FanoutRow::deliveries_per_cpu_s, &FanoutRow::cores, &FanoutRow::ratio_to_limit,
        &FanoutRow::p50_ms, &FanoutRow::p99_ms, &FanoutRow::rss_per_viewer_kb,
        &FanoutRow::rss_growth_kb_per_s}) {
    row.*field = median_of(rounds, field);
  }
  return row;
}

/// Lets the engines of one load take turns, so that a busy moment affects all of them.
class Rounds {
 public:
  explicit Rounds(const FanoutBenchOptions& options) : options_(options) {}

  Status run(const LoadCase& load_case, std::vector<std::unique_ptr<Engine>>& engines,
             FanoutReport& report, const std::function<void(const std::string&)>& progress) {
    std::map<const Engine*, std::vector<FanoutRow>> measured;
    for (int round = 0; round < options_.rounds; ++round) {
      std::map<bool, double> limit;  // by encryption
      for (const auto& engine : engines) {
        if (!takes(*engine, load_case)) continue;
        if (progress) {
          progress(fmt::format("{}, {} viewers, round {} of {}: {}", load_case.name,
                               load_case.viewers, round + 1, options_.rounds, engine->name()));
        }
        auto row = measure(*engine, load_case, options_);
        if (!row) {
          if (auto status = leave_out(*engine, load_case, row.error(), report); !status)
            return status;
          continue;
        }
        limit.try_emplace(row->tls, row->deliveries_per_cpu_s);
        row->ratio_to_limit = row->deliveries_per_cpu_s / limit[row->tls];
        measured[engine.get()].push_back(*row);
      }
    }
    for (const auto& engine : engines) {
      if (!measured[engine.get()].empty()) report.rows.push_back(median(measured[engine.get()]));
    }
    return {};
  }

 private:
  /// Skips an engine that is missing or failed. Fails if the engine is the hub or the limit.
  static Status leave_out(const Engine& engine, const LoadCase& load_case, const Error& why,
                          FanoutReport& report) {
    const bool ours = engine.name().starts_with("roomcast") || engine.name().starts_with("epoll");
    if (ours) return Error{why.code, engine.name() + " (" + load_case.name + "): " + why.message};
    std::string sentence = engine.name() + ": " + why.message;
    if (why.code != ErrorCode::kNotFound) sentence += " (" + load_case.name + ")";
    if (std::ranges::find(report.left_out, sentence) == report.left_out.end()) {
      report.left_out.push_back(std::move(sentence));
    }
    return {};
  }

  const FanoutBenchOptions& options_;
};

}  // namespace

Result<FanoutReport> run_fanout_bench(const FanoutBenchOptions& options,
                                      const std::function<void(const std::string&)>& progress) {
  auto engines = all_engines();
  for (const std::string& wanted : options.only) {
    if (std::ranges::any_of(engines, [&](const auto& e) { return is_wanted(*e, {wanted}); })) {
      continue;
    }
    return Error{ErrorCode::kInvalidArgument, "no engine's name contains '" + wanted + "'"};
  }
  std::erase_if(engines, [&](const auto& engine) { return !is_wanted(*engine, options.only); });
  FanoutReport report;
  Rounds rounds(options);
  for (const LoadCase& load_case : load_cases(options)) {
    if (auto status = rounds.run(load_case, engines, report, progress); !status) {
      return status.error();
    }
  }
  return report;
}

}  // namespace roomcast::bench
