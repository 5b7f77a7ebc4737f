// SPDX-License-Identifier: Apache-2.0
// The NATS client protocol: parses a server's messages in place and formats a client's. Threading:
// no state. Source: docs.nats.io, "Client Protocol".
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace roomcast::hub::federation {

/// INFO lists all servers of a cluster; the other lines are short.
inline constexpr std::size_t kMaxNatsLineBytes = 64u << 10;
/// No server accepts longer messages, whatever its configuration.
inline constexpr std::size_t kMaxNatsMessageBytes = 64u << 20;

// ---- server to client; views refer to the bytes passed in

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
/// An error (-ERR). The server usually disconnects afterwards.
struct NatsServerError {
  std::string_view text;
};
/// A protocol violation; nothing more can be read.
struct NatsViolation {};
using NatsEvent = std::variant<NatsNeedsMore, NatsInfo, NatsMessage, NatsPing, NatsPong, NatsOk,
                               NatsServerError, NatsViolation>;

/// The next event, removed from the front of `bytes`. NatsNeedsMore and NatsViolation remove
/// nothing.
[[nodiscard]] NatsEvent next_nats_event(std::span<const std::uint8_t>& bytes);

struct NatsServerInfo {
  std::size_t max_message_bytes = 1u << 20;
  bool offers_tls = false, demands_tls = false;
  std::string nonce;  // to be signed with the credentials
};

/// Nothing: this is not an INFO.
[[nodiscard]] std::optional<NatsServerInfo> read_server_info(std::string_view json);

// ---- client to server

/// Credentials of the client; empty fields are left out.
struct NatsIdentity {
  std::string user = {}, password = {};
  std::string token = {};                     // instead of user and password
  std::string user_jwt = {}, signature = {};  // of credentials; signs the nonce
};

/// The server must not echo the client's own messages.
[[nodiscard]] std::string connect_line(const NatsIdentity& identity, bool uses_tls);
/// The message follows, then kNatsLineEnd.
[[nodiscard]] std::string publish_line(std::string_view subject, std::size_t message_bytes);
[[nodiscard]] std::string subscribe_line(std::string_view subject, std::uint64_t number);
[[nodiscard]] std::string unsubscribe_line(std::uint64_t number);
inline constexpr std::string_view kNatsLineEnd = "\r\n";
inline constexpr std::string_view kNatsPing = "PING\r\n", kNatsPong = "PONG\r\n";

}  // namespace roomcast::hub::federation
