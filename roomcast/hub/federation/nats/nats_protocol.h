// SPDX-License-Identifier: Apache-2.0
// The NATS client protocol: what a server says, taken apart where it lies, and what a client says.
// Threading: no state. Source: docs.nats.io, "Client Protocol".
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace roomcast::hub::federation {

/// INFO names all servers of a cluster; the other lines are short.
inline constexpr std::size_t kMaxNatsLineBytes = 64u << 10;
/// More than that no server takes, whatever its configuration.
inline constexpr std::size_t kMaxNatsMessageBytes = 64u << 20;

// ---- what a server says; views lie in the bytes that it was read from

struct NatsNeedsMore {};
struct NatsInfo {
  std::string_view json;
};
struct NatsMessage {
  std::string_view subject;
  std::uint64_t subscription = 0;  // its number
  std::span<const std::uint8_t> bytes;
};
struct NatsPing {};
struct NatsPong {};
struct NatsOk {};
/// Mostly it hangs up then.
struct NatsComplaint {
  std::string_view text;
};
/// It breaks the protocol; nothing can be read any more.
struct NatsViolation {};
using NatsEvent = std::variant<NatsNeedsMore, NatsInfo, NatsMessage, NatsPing, NatsPong, NatsOk,
                               NatsComplaint, NatsViolation>;

/// The next one, taken off the front of `bytes`. NatsNeedsMore and NatsViolation take nothing.
[[nodiscard]] NatsEvent next_nats_event(std::span<const std::uint8_t>& bytes);

struct NatsServerInfo {
  std::size_t max_message_bytes = 1u << 20;
  bool offers_tls = false, demands_tls = false;
  std::string nonce;  // to be signed by who has credentials
};

/// Nothing: this is no INFO.
[[nodiscard]] std::optional<NatsServerInfo> read_server_info(std::string_view json);

// ---- what a client says

/// Who it is; what is empty is left out.
struct NatsIdentity {
  std::string user = {}, password = {};
  std::string token = {};                     // instead of these
  std::string user_jwt = {}, signature = {};  // of credentials: the signature is of the nonce
};

/// Its own messages do not come back.
[[nodiscard]] std::string connect_line(const NatsIdentity& identity, bool uses_tls);
/// The message follows, then kNatsLineEnd.
[[nodiscard]] std::string publish_line(std::string_view subject, std::size_t message_bytes);
[[nodiscard]] std::string subscribe_line(std::string_view subject, std::uint64_t number);
[[nodiscard]] std::string unsubscribe_line(std::uint64_t number);
inline constexpr std::string_view kNatsLineEnd = "\r\n";
inline constexpr std::string_view kNatsPing = "PING\r\n", kNatsPong = "PONG\r\n";

}  // namespace roomcast::hub::federation
