// SPDX-License-Identifier: Apache-2.0
// --token and --token-file, the environment's ROOMCAST_TOKEN: how a client says why it should be
// let in. What stands on a command line can be read by everybody on the machine, so a file or the
// environment is better.
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

/// What was given, if anything; a one-time code where a token is expected is taken for what it is.
/// kNotFound: no such file. kInvalidArgument: both were given.
[[nodiscard]] Result<client::Credential> find_credential(const TokenOption& option);

}  // namespace roomcast::cli
