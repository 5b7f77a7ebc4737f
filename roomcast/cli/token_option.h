// SPDX-License-Identifier: Apache-2.0
// --token, --token-file and the environment variable ROOMCAST_TOKEN: a client's credential. Every
// user of the machine can read a command line, so prefer a file or the environment.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "roomcast/client/credential.h"
#include "roomcast/core/result.h"

namespace roomcast::cli {

struct TokenOption {
  std::string token = {}, file = {};
};

void add_token_options(CLI::App& command, TokenOption& option);

/// The given credential, if any. A one-time code is recognised where a token is expected.
/// kNotFound: the file does not exist. kInvalidArgument: both options were given.
[[nodiscard]] Result<client::Credential> find_credential(const TokenOption& option);

}  // namespace roomcast::cli
