// SPDX-License-Identifier: Apache-2.0
// Credential: authorizes a client to join a hub. A code is valid once: the hub answers it with a
// token, which is used from then on. Plain data.
#pragma once

#include <string>
#include <utility>

#include "roomcast/core/result.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::client {

struct Credential {
  std::string token;  // both empty: for rooms that are open to all
  std::string code;
};

/// Distinguishes a token from a code: a token is a JWT, whose parts are separated by dots.
[[nodiscard]] inline Credential credential_of(std::string text) {
  if (text.find('.') == std::string::npos) return {.token = {}, .code = std::move(text)};
  return {.token = std::move(text), .code = {}};
}

/// The first word of `file`. kNotFound: the file has none, or cannot be read; kTooLarge: it is no
/// file with a token.
[[nodiscard]] Result<Credential> read_credential_file(const std::string& file);

/// Checks the texts of a Join before it is encoded: Protobuf prints to stderr where a text is not
/// UTF-8. kMalformed or kTooLarge; the sentence names the field. `role` names the client in it.
[[nodiscard]] Status check_join(const std::string& room, const std::string& role,
                                const std::string& name, const Credential& credential);

inline void show(const Credential& credential, wire::pb::Join& join) {
  join.set_token(credential.token);
  join.set_code(credential.code);
}

}  // namespace roomcast::client
