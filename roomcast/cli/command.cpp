// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/command.h"

#include "roomcast/cli/print.h"

namespace roomcast::cli {

int finish(std::string_view name, const Status& status) {
  if (status) return kDone;
  print_err("roomcast {}: {}\n", name, one_line(status.error().message));
  return status.error().code == ErrorCode::kInvalidArgument ? kWrongUsage : kFailed;
}

}  // namespace roomcast::cli
