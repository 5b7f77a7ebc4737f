// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/command.h"

#include <nlohmann/json.hpp>

#include "roomcast/cli/print.h"
#include "roomcast/core/error_name.h"

namespace roomcast::cli {

int tell(const Finished& finished, bool json) {
  const auto& [status, told] = finished.outcome;
  if (status) return kDone;
  const std::string sentence = one_line(status.error().message);
  if (finished.name.empty()) {
    print_err("roomcast: {}\n", sentence);
  } else {
    print_err("roomcast {}: {}\n", finished.name, sentence);
  }
  if (json && !told) {
    nlohmann::json object;
    add_error(status, object);
    print_out("{}\n", object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  }
  return status.error().code == ErrorCode::kInvalidArgument ? kWrongUsage : kFailed;
}

void add_error(const Status& status, nlohmann::json& report) {
  if (status) return;
  report["error"] = {{"code", name_of(status.error().code)},
                     {"sentence", one_line(status.error().message)}};
}

}  // namespace roomcast::cli
