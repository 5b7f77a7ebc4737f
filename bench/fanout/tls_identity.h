// SPDX-License-Identifier: Apache-2.0
// A certificate for one run of a server under test, and the fingerprint for its clients.
#pragma once

#include <memory>

#include "roomcast/core/result.h"
#include "roomcast/net/tls/tls_context.h"

namespace roomcast::bench {

struct TlsIdentity {
  std::shared_ptr<const net::TlsServerContext> context;
  net::Fingerprint fingerprint;
};

/// Errors of net::Certificate and net::TlsServerContext.
[[nodiscard]] inline Result<TlsIdentity> make_tls_identity() {
  const auto certificate = net::Certificate::make_self_signed({"localhost"});
  if (!certificate) return certificate.error();
  auto context = net::TlsServerContext::create(*certificate);
  if (!context) return context.error();
  return TlsIdentity{*std::move(context), certificate->fingerprint()};
}

}  // namespace roomcast::bench
