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
constexpr double kMeasured_s = 0.6;       // over which rates are averaged
constexpr double kWorthTelling = 0.04;    // relative change of a share

// Lending, in shares of what a sensor is given, or sends.
constexpr double kUsesAll = 0.9;
constexpr std::chrono::seconds kLendsAfter{2};  // of using less
constexpr double kExpected = 1.05;  // of what a lender sends: the others do not get that
constexpr double kLeft = 1.25;      // of the same: it is given so much, to show that it wants more

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
    const bool goes_on = !is_new && known.is_paused == user.is_paused;
    is_news |= !goes_on;
    if (!goes_on)
      known = {.weight = known.weight,
               .reached = known.reached,
               .mbit = known.mbit,
               .sent_bytes = user.sent_bytes,
               .used_all = now};
    known.is_paused = user.is_paused;
    const double weight = kFloor + (1 - kFloor) * user.importance;
    if (weight >= known.weight) known.reached = now;
    const bool is_kept = now - known.reached < kKept;
    const double fading = is_kept ? known.weight : known.weight * std::exp(-seconds / kForget_s);
    known.weight = std::max(weight, fading);
  }
  measure(users, seconds);
  find_lenders(users, now);
  updated_ = now;
  next_ = now + kInterval;
  const std::vector<double> shares = divide(uplink_mbit, users);
  for (std::size_t i = 0; i < users.size(); ++i) {
    const double told = known_[users[i].sensor].mbit;
    is_news |= std::abs(shares[i] - told) > kWorthTelling * told;
  }
  if (!is_news) return;
  for (std::size_t i = 0; i < users.size(); ++i) {
    Known& known = known_[users[i].sensor];
    if (shares[i] > (1 + kWorthTelling) * known.mbit) known.used_all = now;  // it has just got more
    known.mbit = shares[i];
  }
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
    const double mbit = net::line_mbit_per_s(bytes / seconds),
                 before = known.sends_mbit.value_or(mbit);
    known.sends_mbit = before + share * (mbit - before);
  }
}

void UplinkShare::find_lenders(std::span<const UplinkUser> users, RoomTime now) {
  for (const UplinkUser& user : users) {
    Known& known = known_[user.sensor];
    const double sends = known.sends_mbit.value_or(known.mbit);
    if (sends >= kUsesAll * known.mbit) {
      known.used_all = now;
      known.lends = false;
    }
    if (now - known.used_all >= kLendsAfter) known.lends = true;
  }
}

/// Lenders are left a little more than they send, up to their even share. What they are not
/// expected to send goes to the others; to themselves if all are lenders.
std::vector<double> UplinkShare::lend(double mbit, const std::vector<const Known*>& sharing,
                                      const std::vector<double>& weights,
                                      const std::vector<double>& most) {
  std::vector<double> shares = divide_rate(mbit, weights, kMinShare_mbit, most);
  const auto lends = [&](std::size_t i) { return sharing[i]->lends && sharing[i]->sends_mbit; };
  bool all_lend = true;
  for (std::size_t i = 0; i < shares.size(); ++i) all_lend = all_lend && lends(i);
  double rest = mbit;
  std::vector<double> expected(shares.size()), rest_weights, rest_most;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (lends(i)) {
      const double sends = *sharing[i]->sends_mbit, even = all_lend ? mbit : shares[i];
      expected[i] = std::min(even, std::max(kMinShare_mbit, kExpected * sends));
      if (!all_lend) shares[i] = std::min(even, std::max(kMinShare_mbit, kLeft * sends));
      rest -= expected[i];
    }
    if (lends(i) && !all_lend) continue;
    rest_weights.push_back(weights[i]);
    rest_most.push_back(most[i] > 0 ? std::max(kMinShare_mbit, most[i] - expected[i]) : 0);
  }
  if (rest < 0) return divide_rate(mbit, weights, kMinShare_mbit, most);
  const std::vector<double> rests = divide_rate(rest, rest_weights, 0, rest_most);
  std::size_t next = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (all_lend || !lends(i)) shares[i] = std::max(kMinShare_mbit, expected[i] + rests[next++]);
  }
  return shares;
}

/// 0 for those who do not keep to a share, or send nothing.
std::vector<double> UplinkShare::divide(double uplink_mbit,
                                        std::span<const UplinkUser> users) const {
  double rest = uplink_mbit;
  std::vector<const Known*> sharing;
  std::vector<double> weights, most;
  for (const UplinkUser& user : users) {
    const Known& known = known_.at(user.sensor);
    if (!user.follows) rest -= known.sends_mbit.value_or(0);
    if (!user.follows || user.is_paused) continue;
    sharing.push_back(&known);
    weights.push_back(known.weight);
    most.push_back(user.most_mbit);
  }
  const std::vector<double> shares = lend(rest, sharing, weights, most);
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
