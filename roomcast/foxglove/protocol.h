// SPDX-License-Identifier: Apache-2.0
// The messages of foxglove.websocket.v1 that a server of live topics needs: text messages are JSON
// objects with an `op`, binary ones begin with an opcode and are little-endian. Pure, thread-safe.
// Source: https://github.com/foxglove/ws-protocol/blob/main/docs/spec.md
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/core/result.h"
#include "roomcast/recording/export/foxglove_messages.h"

namespace roomcast::foxglove {

inline constexpr std::string_view kSubprotocol = "foxglove.websocket.v1";
inline constexpr std::size_t kMaxRequestBytes = 64 * 1024;
inline constexpr std::size_t kMaxIdsPerRequest = 1024;

/// Not reused while the server runs: clients keep what they know of a channel by its ID.
using ChannelId = Id<struct ChannelTag, std::uint32_t>;

struct Channel {
  ChannelId id{};
  std::string topic;
  recording::FoxgloveKind kind{};
};

[[nodiscard]] std::string server_info(std::string_view name, std::string_view session);
[[nodiscard]] std::string advertise(std::span<const Channel> channels);
[[nodiscard]] std::string unadvertise(std::span<const ChannelId> channels);

enum class Level { kInfo = 0, kWarning = 1, kError = 2 };
[[nodiscard]] std::string status(Level level, std::string_view sentence);

struct Subscription {
  std::uint32_t id = 0;  // chosen by the client
  ChannelId channel{};
};

/// What a client's text message asks for.
struct Request {
  std::vector<Subscription> subscribe;
  std::vector<std::uint32_t> unsubscribe;
};

/// kMalformed for text that is not such a message; kUnsupported for operations that the server does
/// not offer. The sentence is for the client.
[[nodiscard]] Result<Request> parse_request(std::string_view text);

/// What precedes the payload of a topic's message. `time` is since 1970-01-01 UTC.
[[nodiscard]] std::array<std::uint8_t, 13> data_header(std::uint32_t subscription,
                                                       nanoseconds time);

}  // namespace roomcast::foxglove
