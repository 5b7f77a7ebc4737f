// SPDX-License-Identifier: Apache-2.0
#include "bench/abuse/abuse_bench.h"

#include <algorithm>
#include <array>
#include <ostream>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/abuse/attack.h"
#include "bench/fanout/engine.h"
#include "bench/fanout/load.h"

namespace roomcast::bench {

namespace {

constexpr int kPublishers = 4;
constexpr double kFps = 30;
constexpr std::chrono::milliseconds kLook{20};
constexpr std::array kKinds = {AttackKind::kHalfOpen, AttackKind::kGarbage, AttackKind::kSlowloris,
                               AttackKind::kBadTokens};

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  const auto at = static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

double megabytes(std::size_t bytes) {
  return static_cast<double>(bytes) / 1e6;
}

/// Waits until the attack has begun, and a little longer.
Status wait_for(const Attack& attack, Load& load, const AbuseBenchOptions& options) {
  constexpr int kPatience = 20;  // measurements
  for (int look = 0; look < kPatience; ++look) {
    if (auto some = load.run_paced(kFps, options.duration / 8); !some) return some.error();
    if (look > 0 && attack.counts().tried > 0) return {};
  }
  return Error{ErrorCode::kUnavailable, "the attacker got no time to attack"};
}

struct Phase {
  std::vector<double> latencies_ms;
  std::uint64_t tried = 0;  // connections opened by the attacker
};

/// Connects new viewers for each phase, because these viewers do not answer pings and a hub
/// disconnects them after 15 s.
Result<std::unique_ptr<Load>> warm_load(const RunningEngine& hub, const FanoutRoom& room,
                                        const AbuseBenchOptions& options) {
  auto load = Load::connect(hub, room, kPublishers, options.viewers);
  if (!load) return load.error();
  if (auto status = (*load)->warm_up(); !status) return status.error();
  return load;
}

Result<Phase> run_in_peace(const RunningEngine& hub, const FanoutRoom& room,
                           const AbuseBenchOptions& options) {
  auto load = warm_load(hub, room, options);
  if (!load) return load.error();
  auto paced = (*load)->run_paced(kFps, options.duration);
  if (!paced) return paced.error();
  return Phase{std::move(paced->latencies_ms), 0};
}

Result<Phase> run_under_attack(AttackKind kind, const RunningEngine& attacked,
                               const RunningEngine& hub, const FanoutRoom& room,
                               const AbuseBenchOptions& options) {
  auto load = warm_load(hub, room, options);
  if (!load) return load.error();
  const int connections =
      kind == AttackKind::kBadTokens ? options.bad_tokens / options.rounds : options.connections;
  const Attack attack(kind, attacked.process.port(), connections);
  if (auto status = wait_for(attack, **load, options); !status) return status.error();
  auto paced = (*load)->run_paced(kFps, options.duration);
  if (!paced) return paced.error();
  while (kind == AttackKind::kBadTokens && !attack.is_over()) std::this_thread::sleep_for(kLook);
  return Phase{std::move(paced->latencies_ms), attack.counts().tried};
}

double p99_of(const std::vector<double>& values) {
  return quantile(values, 0.99);
}

void append(const std::vector<double>& values, std::vector<double>& all) {
  all.insert(all.end(), values.begin(), values.end());
}

Result<AbuseRow> measure(AttackKind kind, const AbuseBenchOptions& options) {
  FanoutRoom room;
  room.fps = kFps;
  const auto hub = make_hub(false)->start(room);
  if (!hub) return hub.error();
  const auto other = make_hub(false)->start(room);
  if (!other) return other.error();
  AbuseRow row;
  row.attack = name_of(kind);
  row.rss_before_mb = megabytes(hub->process.resident_bytes());
  std::vector<double> quiet, beside, attacked, ratios, ratios_beside;
  for (int i = 0; i < options.rounds; ++i) {
    const auto peace = run_in_peace(*hub, room, options);
    if (!peace) return peace.error();
    const auto bystander = run_under_attack(kind, *other, *hub, room, options);
    if (!bystander) return bystander.error();
    const auto target = run_under_attack(kind, *hub, *hub, room, options);
    if (!target) return target.error();
    ratios.push_back(p99_of(target->latencies_ms) / p99_of(peace->latencies_ms));
    ratios_beside.push_back(p99_of(target->latencies_ms) / p99_of(bystander->latencies_ms));
    append(peace->latencies_ms, quiet);
    append(bystander->latencies_ms, beside);
    append(target->latencies_ms, attacked);
    row.tried += target->tried;
    row.rss_most_mb = std::max(row.rss_most_mb, megabytes(hub->process.resident_bytes()));
  }
  row.p50_quiet_ms = quantile(quiet, 0.5);
  row.p99_quiet_ms = p99_of(quiet);
  row.p99_beside_ms = p99_of(beside);
  row.p50_ms = quantile(attacked, 0.5);
  row.p99_ms = p99_of(attacked);
  row.p99_ratio = quantile(ratios, 0.5);
  row.p99_ratio_beside = quantile(ratios_beside, 0.5);
  return row;
}

}  // namespace

Result<std::vector<AbuseRow>> run_abuse_bench(
    const AbuseBenchOptions& options, const std::function<void(const std::string&)>& progress) {
  std::vector<AbuseRow> rows;
  for (const AttackKind kind : kKinds) {
    if (progress) progress(std::string(name_of(kind)));
    auto row = measure(kind, options);
    if (!row) return row.error();
    rows.push_back(*std::move(row));
  }
  return rows;
}

void print_table(const std::vector<AbuseRow>& rows, std::ostream& out) {
  out << fmt::format("{:12}{:>8}{:>14}{:>15}{:>14}{:>10}{:>11}{:>12}{:>11}\n", "attack", "tried",
                     "p99 in peace", "other attacked", "p99 attacked", "to peace", "to other",
                     "RSS before", "RSS most");
  for (const AbuseRow& row : rows) {
    out << fmt::format(
        "{:12}{:>8}{:>11.2f} ms{:>12.2f} ms{:>11.2f} ms{:>10.2f}{:>11.2f}{:>9.1f} MB{:>8.1f} MB\n",
        row.attack, row.tried, row.p99_quiet_ms, row.p99_beside_ms, row.p99_ms, row.p99_ratio,
        row.p99_ratio_beside, row.rss_before_mb, row.rss_most_mb);
  }
}

void print_json(const std::vector<AbuseRow>& rows, std::ostream& out) {
  nlohmann::json list = nlohmann::json::array();
  for (const AbuseRow& row : rows) {
    list.push_back({{"attack", row.attack},
                    {"p50_quiet_ms", row.p50_quiet_ms},
                    {"p99_quiet_ms", row.p99_quiet_ms},
                    {"p99_beside_ms", row.p99_beside_ms},
                    {"p50_ms", row.p50_ms},
                    {"p99_ms", row.p99_ms},
                    {"p99_ratio", row.p99_ratio},
                    {"p99_ratio_beside", row.p99_ratio_beside},
                    {"tried", row.tried},
                    {"rss_before_mb", row.rss_before_mb},
                    {"rss_most_mb", row.rss_most_mb}});
  }
  out << nlohmann::json{{"rows", std::move(list)}}.dump(1) << "\n";
}

}  // namespace roomcast::bench
