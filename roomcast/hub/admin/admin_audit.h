// SPDX-License-Identifier: Apache-2.0
// Audit log of the admin interface: one line for each call that changes something, whatever its
// outcome, and for each refused call. Threading: no state.
#pragma once

#include <string>

#include "roomcast/core/log.h"
#include "roomcast/net/http_request.h"

namespace roomcast::hub {

struct AuditedCall {
  std::string method, path, peer;
  std::string token_id = {}, name = {};  // of the token presented; empty: none, or an invalid one
  bool is_frequent = false;  // comes many times a second, and changes nothing that stays
};

/// Wraps `respond` so that the answer is logged. No secrets are logged: of a token only its ID.
[[nodiscard]] net::Respond audited(const LogSink& log, AuditedCall call, net::Respond respond);

}  // namespace roomcast::hub
