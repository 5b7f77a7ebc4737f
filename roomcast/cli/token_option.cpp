// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/token_option.h"

#include <cstdlib>

namespace roomcast::cli {

void add_token_options(CLI::App& command, TokenOption& option) {
  command.add_option("--token", option.token,
                     "Token or one-time code, see roomcast token (default: ROOMCAST_TOKEN of the "
                     "environment)");
  command.add_option("--token-file", option.file, "File whose first word is the token");
}

Result<client::Credential> find_credential(const TokenOption& option) {
  if (!option.token.empty() && !option.file.empty()) {
    return Error{ErrorCode::kInvalidArgument, "give --token or --token-file, not both"};
  }
  if (!option.token.empty()) return client::credential_of(option.token);
  if (!option.file.empty()) return client::read_credential_file(option.file);
  const char* from_environment = std::getenv("ROOMCAST_TOKEN");
  return client::credential_of(from_environment == nullptr ? "" : from_environment);
}

}  // namespace roomcast::cli
