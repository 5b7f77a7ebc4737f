// SPDX-License-Identifier: Apache-2.0
// Claims: the content of a join token, and the reasons for a refusal. Plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

/// kHub: for a hub that relays the room and reports its people.
enum class TokenRole { kSensor, kViewer, kHub, kAdmin };

[[nodiscard]] constexpr std::string_view name_of(TokenRole role) {
  switch (role) {
    case TokenRole::kSensor:
      return "sensor";
    case TokenRole::kViewer:
      return "viewer";
    case TokenRole::kHub:
      return "hub";
    case TokenRole::kAdmin:
      break;
  }
  return "admin";
}
[[nodiscard]] constexpr std::optional<TokenRole> token_role(std::string_view name) {
  for (const TokenRole role :
       {TokenRole::kSensor, TokenRole::kViewer, TokenRole::kHub, TokenRole::kAdmin}) {
    if (name == name_of(role)) return role;
  }
  return std::nullopt;
}

/// The room of a token that is valid for the hub and all its rooms; role admin only.
inline constexpr std::string_view kAllRooms = "*";

/// The permission that a token gives, or the token for which a code is exchanged.
struct Grant {
  std::string room;
  TokenRole role = TokenRole::kViewer;
  std::string name = {};  // of the owner; a sensor's token is only for the sensor of this name
};

/// Seconds since 1970, UTC, so that the validity does not depend on the machine.
using UnixSeconds = std::int64_t;

struct Claims {
  std::string id;
  Grant grant;
  UnixSeconds issued_at = 0;
  UnixSeconds expires_at = 0;
};

/// A refusal: a code for programs and a sentence for people.
struct Refusal {
  wire::pb::ErrorCode code = wire::pb::ERROR_UNSPECIFIED;
  std::string sentence;
};

/// The requested value, or a refusal.
template <class T>
using Verdict = std::variant<T, Refusal>;

template <class T>
[[nodiscard]] const Refusal* refusal(const Verdict<T>& verdict) {
  return std::get_if<Refusal>(&verdict);
}

[[nodiscard]] inline bool covers(const Grant& grant, std::string_view room) {
  return grant.room == room || (grant.role == TokenRole::kAdmin && grant.room == kAllRooms);
}

}  // namespace roomcast::hub
