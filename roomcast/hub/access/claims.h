// SPDX-License-Identifier: Apache-2.0
// What a join token says, and why somebody is not let in. Plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

/// kHub: of a hub that serves the room on, and says who watches there.
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

/// Of a token for the hub and all its rooms; role admin only.
inline constexpr std::string_view kAllRooms = "*";

/// What a token, or the token that a code is exchanged for, is good for.
struct Grant {
  std::string room;
  TokenRole role = TokenRole::kViewer;
  std::string name = {};  // whom it is for; a sensor's: good for the sensor of this name only
};

/// Seconds since 1970, UTC: a token holds by the calendar, whatever machine made it.
using UnixSeconds = std::int64_t;

struct Claims {
  std::string id;
  Grant grant;
  UnixSeconds issued_at = 0;
  UnixSeconds expires_at = 0;
};

/// Why not: a code for programs, a sentence for a person.
struct Refusal {
  wire::pb::ErrorCode code = wire::pb::ERROR_UNSPECIFIED;
  std::string sentence;
};

/// What was asked for, or why not.
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
