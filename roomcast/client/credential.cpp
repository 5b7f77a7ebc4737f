// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/credential.h"

#include <sstream>

#include "roomcast/core/text_file.h"

namespace roomcast::client {

namespace {

constexpr std::size_t kMaxFileBytes = 64 << 10;  // a token has less than 1 KiB

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

}  // namespace roomcast::client
