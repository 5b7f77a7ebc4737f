// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/credential.h"

#include <algorithm>
#include <sstream>

#include "roomcast/core/text_file.h"
#include "roomcast/wire/limits.h"
#include "roomcast/wire/name_check.h"

namespace roomcast::client {

namespace {

constexpr std::size_t kMaxFileBytes = 64 << 10;  // a token has less than 1 KiB

bool is_printable_ascii(const std::string& text) {
  return std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; });
}

}  // namespace

Result<Credential> read_credential_file(const std::string& file) {
  const auto text = read_text_file(file, kMaxFileBytes);
  if (!text) return Error{text.error().code, "no token is to be had: " + text.error().message};
  std::string token;
  if (!(std::istringstream(*text) >> token)) {
    return Error{ErrorCode::kNotFound, "no token is in \"" + file + "\""};
  }
  return credential_of(std::move(token));
}

Status check_join(const std::string& room, const std::string& role, const std::string& name,
                  const Credential& credential) {
  if (auto status = wire::check_name(room, "room"); !status) return status;
  if (auto status = wire::check_name(name, role); !status) return status;
  for (const std::string* secret : {&credential.token, &credential.code}) {
    if (secret->size() > wire::kMaxTokenBytes)
      return Error{ErrorCode::kTooLarge, "this token is longer than any hub makes"};
    if (!is_printable_ascii(*secret))
      return malformed("a token has no other characters than those of ASCII");
  }
  return {};
}

}  // namespace roomcast::client
