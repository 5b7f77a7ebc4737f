// SPDX-License-Identifier: Apache-2.0
// Who did what with the interface for admins: one line of the log for each call that changes
// something, whatever comes of it, and for each that is refused. Threading: no state.
#pragma once

#include <string>

#include "roomcast/core/log.h"
#include "roomcast/net/http_request.h"

namespace roomcast::hub {

struct AuditedCall {
  std::string method, path, peer;
  std::string token_id = {}, name = {};  // of the token that was shown; empty: none, or a bad one
};

/// `respond`, and the log is told what it answers. Nothing secret: of a token its id.
[[nodiscard]] net::Respond audited(const LogSink& log, AuditedCall call, net::Respond respond);

}  // namespace roomcast::hub
