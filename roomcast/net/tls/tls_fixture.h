// SPDX-License-Identifier: Apache-2.0
// For tests: a server with a self-signed certificate.
#pragma once

#include <memory>
#include <stdexcept>

#include <gtest/gtest.h>

#include "roomcast/net/tls/certificate.h"
#include "roomcast/net/tls/tls_context.h"

namespace roomcast::net {

inline Certificate self_signed() {
  auto certificate = Certificate::make_self_signed({"localhost", "127.0.0.1"});
  if (!certificate) throw std::runtime_error(certificate.error().message);
  return *std::move(certificate);
}

inline std::shared_ptr<const TlsServerContext> server_context(const Certificate& certificate) {
  auto context = TlsServerContext::create(certificate);
  if (!context) throw std::runtime_error(context.error().message);
  return *context;
}

}  // namespace roomcast::net
