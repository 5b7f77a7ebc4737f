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

struct Round {
  std::vector<double> quiet_ms, attacked_ms;
  std::uint64_t tried = 0;
};

/// Until the attack is felt, and a little longer.
Status wait_for(const Attack& attack, Load& load, const AbuseBenchOptions& options) {
  constexpr int kPatience = 20;  // looks
  for (int look = 0; look < kPatience; ++look) {
    if (auto some = load.run_paced(kFps, options.duration / 8); !some) return some.error();
    if (look > 0 && attack.counts().tried > 0) return {};
  }
  return Error{ErrorCode::kUnavailable, "the attacker got no time to attack"};
}

/// Peace, then the attack. Viewers of their own each time: they do not answer pings, and a hub
/// gives them up after 15 s.
Result<Round> run_round(AttackKind kind, const RunningEngine& hub, const FanoutRoom& room,
                        const AbuseBenchOptions& options) {
  auto load = Load::connect(hub, room, kPublishers, options.viewers);
  if (!load) return load.error();
  if (auto status = (*load)->warm_up(); !status) return status.error();
  auto quiet = (*load)->run_paced(kFps, options.duration);
  if (!quiet) return quiet.error();
  const int connections =
      kind == AttackKind::kBadTokens ? options.bad_tokens / options.rounds : options.connections;
  const Attack attack(kind, hub.process.port(), connections);
  if (auto status = wait_for(attack, **load, options); !status) return status.error();
  auto attacked = (*load)->run_paced(kFps, options.duration);
  if (!attacked) return attacked.error();
  while (kind == AttackKind::kBadTokens && !attack.is_over()) std::this_thread::sleep_for(kLook);
  return Round{std::move(quiet->latencies_ms), std::move(attacked->latencies_ms),
               attack.counts().tried};
}

Result<AbuseRow> measure(AttackKind kind, const AbuseBenchOptions& options) {
  FanoutRoom room;
  room.fps = kFps;
  const auto hub = make_hub(false)->start(room);
  if (!hub) return hub.error();
  AbuseRow row;
  row.attack = name_of(kind);
  row.rss_before_mb = megabytes(hub->process.resident_bytes());
  std::vector<double> quiet, attacked, ratios;
  for (int i = 0; i < options.rounds; ++i) {
    const auto round = run_round(kind, *hub, room, options);
    if (!round) return round.error();
    ratios.push_back(quantile(round->attacked_ms, 0.99) / quantile(round->quiet_ms, 0.99));
    quiet.insert(quiet.end(), round->quiet_ms.begin(), round->quiet_ms.end());
    attacked.insert(attacked.end(), round->attacked_ms.begin(), round->attacked_ms.end());
    row.tried += round->tried;
    row.rss_most_mb = std::max(row.rss_most_mb, megabytes(hub->process.resident_bytes()));
  }
  row.p50_quiet_ms = quantile(quiet, 0.5);
  row.p99_quiet_ms = quantile(quiet, 0.99);
  row.p50_ms = quantile(attacked, 0.5);
  row.p99_ms = quantile(attacked, 0.99);
  row.p99_ratio = quantile(ratios, 0.5);
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
  out << fmt::format("{:12}{:>9}{:>14}{:>14}{:>8}{:>12}{:>12}\n", "attack", "tried", "p99 in peace",
                     "p99 attacked", "ratio", "RSS before", "RSS most");
  for (const AbuseRow& row : rows) {
    out << fmt::format("{:12}{:>9}{:>11.2f} ms{:>11.2f} ms{:>8.2f}{:>9.1f} MB{:>9.1f} MB\n",
                       row.attack, row.tried, row.p99_quiet_ms, row.p99_ms, row.p99_ratio,
                       row.rss_before_mb, row.rss_most_mb);
  }
}

void print_json(const std::vector<AbuseRow>& rows, std::ostream& out) {
  nlohmann::json list = nlohmann::json::array();
  for (const AbuseRow& row : rows) {
    list.push_back({{"attack", row.attack},
                    {"p50_quiet_ms", row.p50_quiet_ms},
                    {"p99_quiet_ms", row.p99_quiet_ms},
                    {"p50_ms", row.p50_ms},
                    {"p99_ms", row.p99_ms},
                    {"p99_ratio", row.p99_ratio},
                    {"tried", row.tried},
                    {"rss_before_mb", row.rss_before_mb},
                    {"rss_most_mb", row.rss_most_mb}});
  }
  out << nlohmann::json{{"rows", std::move(list)}}.dump(1) << "\n";
}

}  // namespace roomcast::bench
