// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/nats/nats_options.h"

#include <algorithm>
#include <utility>

#include <unistd.h>

#include "roomcast/net/hub_url.h"

namespace roomcast::hub::federation {
namespace {

Status check_file(const std::string& file) {
  if (file.empty() || ::access(file.c_str(), R_OK) == 0) return {};
  return Error{ErrorCode::kNotFound, "cannot read " + file + ", a file for the connection to NATS"};
}

/// Removes "user:password@" from the front.
NatsIdentity take_identity(std::string_view& text) {
  const auto at = text.rfind('@');
  if (at == std::string_view::npos) return {};
  const auto shown = text.substr(0, at);
  text.remove_prefix(at + 1);
  const auto colon = shown.find(':');
  if (colon == std::string_view::npos) return {.token = std::string(shown)};
  return {.user = std::string(shown.substr(0, colon)),
          .password = std::string(shown.substr(colon + 1))};
}

bool names_port(std::string_view host_and_port) {
  const auto last = host_and_port.find_last_of(":]");
  return last != std::string_view::npos && host_and_port[last] == ':';
}

}  // namespace

std::string without_secret(const std::string& server) {
  const auto at = server.rfind('@');
  const auto scheme_end = server.find("://");
  if (at == std::string::npos) return server;
  const std::string scheme =
      scheme_end == std::string::npos ? "" : server.substr(0, scheme_end + 3);
  return scheme + server.substr(at + 1);
}

Result<NatsAddress> parse_nats_address(const std::string& server) {
  NatsAddress address;
  std::string_view rest = server;
  address.is_encrypted = rest.starts_with("tls://");
  const bool has_scheme = address.is_encrypted || rest.starts_with("nats://");
  rest.remove_prefix(has_scheme ? rest.find("://") + 3 : 0);
  address.identity = take_identity(rest);
  const std::string port = names_port(rest) ? "" : ":" + std::to_string(address.port);
  const auto url = net::parse_hub_url("ws://" + std::string(rest) + port);
  if (!has_scheme || !url || rest.find_first_of("/#") != std::string_view::npos) {
    return invalid_argument("\"" + without_secret(server) +
                            "\" is no NATS address; write nats://host:4222 or tls://host:4222");
  }
  address.host = url->host;
  address.port = url->port;
  return address;
}

Status check(const NatsOptions& options) {
  if (options.servers.empty())
    return invalid_argument("name a NATS server with --nats nats://host:4222");
  for (const std::string& server : options.servers) {
    if (const auto address = parse_nats_address(server); !address) return address.error();
  }
  if (options.cert_file.empty() != options.key_file.empty()) {
    return invalid_argument(
        "a certificate for NATS needs its key: give both --nats-cert and --nats-key");
  }
  for (const auto* file :
       {&options.credentials_file, &options.ca_file, &options.cert_file, &options.key_file}) {
    if (auto status = check_file(*file); !status) return status;
  }
  return {};
}

bool wants_tls(const NatsOptions& options) {
  return !options.ca_file.empty() || !options.cert_file.empty() ||
         std::ranges::any_of(options.servers, [](const std::string& server) {
           return server.starts_with("tls://");
         });
}

Error connect_error(NatsFault fault, const std::string& server, const NatsOptions& options) {
  const std::string where = "NATS at " + without_secret(server);
  switch (fault) {
    case NatsFault::kNoAnswer:
      return {ErrorCode::kUnavailable, "no NATS server answers at " + without_secret(server)};
    case NatsFault::kNotNats:
      return {ErrorCode::kClosed, "the server at " + without_secret(server) + " is no NATS server"};
    case NatsFault::kRefused:
      if (!options.credentials_file.empty()) {
        return {ErrorCode::kClosed,
                where + " refuses the credentials in " + options.credentials_file};
      }
      return {ErrorCode::kClosed, where +
                                      " refuses this hub; name its credentials with "
                                      "--nats-credentials, or put user:password@ before the host"};
    case NatsFault::kRejected:
      return {ErrorCode::kClosed, where + " rejects this hub"};
    case NatsFault::kNotTrusted:
      return {ErrorCode::kClosed, "no encrypted connection to " + where +
                                      ": its certificate is not trusted, or it requires a client "
                                      "certificate; see --nats-ca, "
                                      "--nats-cert and --nats-key"};
    case NatsFault::kOffersNoTls:
      return {ErrorCode::kClosed,
              where + " offers no TLS; what is sent there could be read by others"};
  }
  return {ErrorCode::kUnavailable, where};
}

}  // namespace roomcast::hub::federation
