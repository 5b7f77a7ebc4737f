// SPDX-License-Identifier: Apache-2.0
// Subscriptions of one client, and the newest message of each that has not been sent. A newer
// message replaces an older one of its topic, so a client that reads slowly gets fewer and newer
// messages, and takes memory for one message of each topic at most. Single-threaded, pure.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/foxglove/protocol.h"

namespace roomcast::foxglove {

/// A message of a topic, shared by all clients.
struct TopicMessage {
  nanoseconds time{};  // since 1970-01-01 UTC
  std::string bytes;
};
using TopicMessagePtr = std::shared_ptr<const TopicMessage>;

class Subscriptions {
 public:
  /// kInvalidArgument if the ID is in use, or the channel is subscribed to already.
  [[nodiscard]] Status add(const Subscription& subscription);
  /// False: there is none of this ID.
  bool remove(std::uint32_t id);
  /// The channel is no longer there.
  void drop(ChannelId channel);

  void offer(ChannelId channel, TopicMessagePtr message);

  struct Next {
    std::uint32_t subscription = 0;
    TopicMessagePtr message;
  };
  /// The topic that has waited longest; nothing if none has a message.
  [[nodiscard]] std::optional<Next> next();

  [[nodiscard]] std::vector<ChannelId> channels() const;
  /// Messages that were replaced before they could be sent.
  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }

 private:
  struct Topic {
    std::uint32_t subscription = 0;
    TopicMessagePtr waiting;
    std::uint64_t since = 0;  // turn in which it began to wait
  };
  std::map<ChannelId, Topic> topics_;
  std::uint64_t turn_ = 0;
  std::uint64_t skipped_ = 0;
};

}  // namespace roomcast::foxglove
