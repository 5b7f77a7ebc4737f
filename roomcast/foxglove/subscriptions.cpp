// SPDX-License-Identifier: Apache-2.0
#include "roomcast/foxglove/subscriptions.h"

#include <algorithm>
#include <utility>

namespace roomcast::foxglove {

Status Subscriptions::add(const Subscription& subscription) {
  const auto id = std::to_string(subscription.id);
  if (std::ranges::any_of(
          topics_, [&](const auto& topic) { return topic.second.subscription == subscription.id; }))
    return invalid_argument("The subscription " + id + " exists already.");
  if (!topics_.try_emplace(subscription.channel, Topic{subscription.id, nullptr, 0}).second)
    return invalid_argument("The channel " + std::to_string(subscription.channel.value) +
                            " is subscribed to already.");
  return {};
}

bool Subscriptions::remove(std::uint32_t id) {
  return std::erase_if(topics_,
                       [&](const auto& topic) { return topic.second.subscription == id; }) > 0;
}

void Subscriptions::drop(ChannelId channel) {
  topics_.erase(channel);
}

void Subscriptions::offer(ChannelId channel, TopicMessagePtr message) {
  const auto found = topics_.find(channel);
  if (found == topics_.end()) return;
  Topic& topic = found->second;
  if (topic.waiting) {
    ++skipped_;
  } else {
    topic.since = ++turn_;
  }
  topic.waiting = std::move(message);
}

std::optional<Subscriptions::Next> Subscriptions::next() {
  Topic* longest = nullptr;
  for (auto& [channel, topic] : topics_) {
    if (topic.waiting && (longest == nullptr || topic.since < longest->since)) longest = &topic;
  }
  if (longest == nullptr) return std::nullopt;
  return Next{longest->subscription, std::exchange(longest->waiting, nullptr)};
}

std::vector<ChannelId> Subscriptions::channels() const {
  std::vector<ChannelId> channels;
  for (const auto& [channel, topic] : topics_) channels.push_back(channel);
  return channels;
}

}  // namespace roomcast::foxglove
