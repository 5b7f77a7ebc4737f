// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/uplink_share.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "roomcast/net/socket_tuning.h"

namespace roomcast::hub {
namespace {

constexpr double kFloor = 0.25;           // weight of a sensor that nobody needs whole
constexpr std::chrono::seconds kKept{2};  // a weight, before it falls
constexpr double kForget_s = 3;           // in which it then falls to a third
constexpr double kMeasured_s = 1;         // over which the rate of others is averaged
constexpr double kWorthTelling = 0.1;     // relative change of a share

}  // namespace

std::vector<double> divide_rate(double mbit, const std::vector<double>& weights, double least,
                                const std::vector<double>& most) {
  std::vector<double> shares(weights.size());
  std::vector<bool> is_settled(weights.size());
  const auto settle_if = [&](auto value_of) {
    bool any = false;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      if (is_settled[i]) continue;
      const double value = value_of(i);
      if (value == shares[i]) continue;
      shares[i] = value;
      is_settled[i] = any = true;
    }
    return any;
  };
  for (;;) {
    double rest = mbit, weight = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      if (is_settled[i]) rest -= shares[i];
      if (!is_settled[i]) weight += weights[i];
    }
    for (std::size_t i = 0; i < shares.size(); ++i) {
      if (!is_settled[i]) shares[i] = std::max(0.0, rest) * weights[i] / weight;
    }
    if (settle_if(
            [&](std::size_t i) { return most[i] > 0 ? std::min(shares[i], most[i]) : shares[i]; }))
      continue;
    if (settle_if([&](std::size_t i) { return std::max(shares[i], least); })) continue;
    return shares;
  }
}

void UplinkShare::update(double uplink_mbit, std::span<const UplinkUser> users, RoomTime now) {
  const double before_mbit = std::exchange(uplink_mbit_, uplink_mbit);
  if (uplink_mbit <= 0) {
    known_.clear();
    updated_.reset();
    return next_.reset();
  }
  const std::size_t known_before = known_.size();
  forget_absent(users);
  bool is_news = uplink_mbit != before_mbit || known_.size() != known_before;
  const double seconds = updated_ ? std::chrono::duration<double>(now - *updated_).count() : 0;
  for (const UplinkUser& user : users) {
    const auto [found, is_new] = known_.try_emplace(user.sensor);
    Known& known = found->second;
    if (is_new) known.sent_bytes = user.sent_bytes;
    is_news |= is_new || known.is_paused != user.is_paused;
    known.is_paused = user.is_paused;
    const double weight = kFloor + (1 - kFloor) * user.importance;
    if (weight >= known.weight) known.reached = now;
    const bool is_kept = now - known.reached < kKept;
    const double fading = is_kept ? known.weight : known.weight * std::exp(-seconds / kForget_s);
    known.weight = std::max(weight, fading);
  }
  measure(users, seconds);
  updated_ = now;
  next_ = now + kInterval;
  const std::vector<double> shares = divide(uplink_mbit, users);
  for (std::size_t i = 0; i < users.size(); ++i) {
    const double told = known_[users[i].sensor].mbit;
    is_news |= std::abs(shares[i] - told) > kWorthTelling * told;
  }
  if (!is_news) return;
  for (std::size_t i = 0; i < users.size(); ++i) known_[users[i].sensor].mbit = shares[i];
}

void UplinkShare::forget_absent(std::span<const UplinkUser> users) {
  std::set<SensorId> present;
  for (const UplinkUser& user : users) present.insert(user.sensor);
  std::erase_if(known_, [&](const auto& entry) { return !present.contains(entry.first); });
}

void UplinkShare::measure(std::span<const UplinkUser> users, double seconds) {
  if (seconds <= 0) return;
  for (const UplinkUser& user : users) {
    Known& known = known_[user.sensor];
    const auto bytes =
        static_cast<double>(user.sent_bytes - std::exchange(known.sent_bytes, user.sent_bytes));
    const double share = 1 - std::exp(-seconds / kMeasured_s);
    known.sends_mbit += share * (net::line_mbit_per_s(bytes / seconds) - known.sends_mbit);
  }
}

/// 0 for those who do not keep to a share, or send nothing.
std::vector<double> UplinkShare::divide(double uplink_mbit,
                                        std::span<const UplinkUser> users) const {
  double rest = uplink_mbit;
  std::vector<double> weights, most;
  for (const UplinkUser& user : users) {
    const Known& known = known_.at(user.sensor);
    if (!user.follows) rest -= known.sends_mbit;
    if (!user.follows || user.is_paused) continue;
    weights.push_back(known.weight);
    most.push_back(user.most_mbit);
  }
  const std::vector<double> shares = divide_rate(rest, weights, kMinShare_mbit, most);
  std::vector<double> all(users.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < users.size(); ++i) {
    if (users[i].follows && !users[i].is_paused) all[i] = shares[next++];
  }
  return all;
}

double UplinkShare::of(SensorId sensor) const {
  const auto known = known_.find(sensor);
  return known == known_.end() ? 0 : known->second.mbit;
}

}  // namespace roomcast::hub
