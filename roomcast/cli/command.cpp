// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/command.h"

#include <cstdio>
#include <string>

#include <fmt/format.h>

namespace roomcast::cli {

int finish(std::string_view name, const Status& status) {
  if (status) return kDone;
  fmt::print(stderr, "roomcast {}: {}\n", name, status.error().message);
  return status.error().code == ErrorCode::kInvalidArgument ? kWrongUsage : kFailed;
}

LogSink stderr_log(std::string_view name, bool verbose) {
  return [name = std::string(name), verbose](LogLevel level, std::string_view line) {
    if (verbose || level != LogLevel::kInfo) fmt::print(stderr, "roomcast {}: {}\n", name, line);
  };
}

}  // namespace roomcast::cli
