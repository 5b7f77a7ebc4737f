// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cluster/nats_options.h"

#include <algorithm>
#include <fstream>
#include <utility>

namespace roomcast::cluster {
namespace {

Error wrong(std::string sentence) {
  return {ErrorCode::kInvalidArgument, std::move(sentence)};
}

Status check_server(const std::string& server) {
  const auto scheme_end = server.find("://");
  const std::string scheme = server.substr(0, std::min(scheme_end, server.size()));
  const std::string rest = scheme_end == std::string::npos ? "" : server.substr(scheme_end + 3);
  if ((scheme == "nats" || scheme == "tls") && !rest.empty() && rest.back() != '@' &&
      rest.find_first_of("/ ") == std::string::npos) {
    return {};
  }
  return wrong("\"" + without_secret(server) +
               "\" is no NATS address; write nats://host:4222 or tls://host:4222");
}

Status check_file(const std::string& file) {
  if (file.empty() || std::ifstream(file).good()) return {};
  return Error{ErrorCode::kNotFound, "cannot read " + file + ", which NATS is to be reached with"};
}

std::string all_of(const std::vector<std::string>& servers) {
  std::string text;
  for (const std::string& server : servers) {
    text += (text.empty() ? "" : ", ") + without_secret(server);
  }
  return text;
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

Status check(const NatsOptions& options) {
  if (options.servers.empty()) return wrong("name a NATS server with --nats nats://host:4222");
  for (const std::string& server : options.servers) {
    if (auto status = check_server(server); !status) return status;
  }
  if (options.cert_file.empty() != options.key_file.empty()) {
    return wrong("a certificate for NATS and its key go together: --nats-cert and --nats-key");
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

Result<NatsOptionsPtr> libnats_options(const NatsOptions& options) {
  natsOptions* made = nullptr;
  natsStatus status = natsOptions_Create(&made);
  NatsOptionsPtr result(made, &natsOptions_Destroy);
  const auto set = [&](natsStatus next) { status = status == NATS_OK ? next : status; };
  std::vector<const char*> servers;
  for (const std::string& server : options.servers) servers.push_back(server.c_str());
  set(natsOptions_SetServers(made, servers.data(), static_cast<int>(servers.size())));
  set(natsOptions_SetNoRandomize(made, true));
  set(natsOptions_SetIgnoreDiscoveredServers(made, true));  // only those that were named
  set(natsOptions_SetName(made, "roomcast hub"));
  set(natsOptions_SetTimeout(made, kConnectWithin.count()));
  set(natsOptions_SetAllowReconnect(made, false));  // NatsClient does
  set(natsOptions_SetPingInterval(made, 0));        // and asks whether a server is there
  set(natsOptions_SetIOBufSize(made, kIoBytes));
  set(natsOptions_SetSendAsap(made, true));  // NatsSession writes
  set(natsOptions_SetNoEcho(made, true));
  if (status != NATS_OK) return wrong("libnats cannot be set up: " + all_of(options.servers));
  if (wants_tls(options)) set(natsOptions_SetSecure(made, true));
  if (!options.ca_file.empty()) {
    set(natsOptions_LoadCATrustedCertificates(made, options.ca_file.c_str()));
  }
  if (status != NATS_OK) {
    return wrong(options.ca_file + " holds no certificates in PEM that NATS' can be checked with");
  }
  if (!options.cert_file.empty()) {
    set(natsOptions_LoadCertificatesChain(made, options.cert_file.c_str(),
                                          options.key_file.c_str()));
  }
  if (status != NATS_OK) {
    return wrong(options.cert_file + " and " + options.key_file +
                 " are no certificate and its key in PEM");
  }
  if (!options.credentials_file.empty()) {
    set(natsOptions_SetUserCredentialsFromFiles(made, options.credentials_file.c_str(), nullptr));
  }
  if (status != NATS_OK) return wrong(options.credentials_file + " holds no NATS credentials");
  return result;
}

Error connect_error(natsStatus status, const NatsOptions& options) {
  const std::string where = all_of(options.servers);
  switch (status) {
    case NATS_CONNECTION_AUTH_FAILED:
      if (options.credentials_file.empty()) {
        return {ErrorCode::kClosed,
                "NATS at " + where +
                    " refuses this hub; name its credentials with "
                    "--nats-credentials, or put user:password@ before the host"};
      }
      return {ErrorCode::kClosed,
              "NATS at " + where + " refuses the credentials in " + options.credentials_file};
    case NATS_SSL_ERROR:
      return {ErrorCode::kClosed,
              "no encrypted connection to NATS at " + where +
                  ": its certificate is not trusted, or it asks for one of ours; see --nats-ca, "
                  "--nats-cert and --nats-key"};
    case NATS_SECURE_CONNECTION_REQUIRED:
      return {ErrorCode::kClosed,
              "NATS at " + where + " asks for TLS; write tls:// before the host"};
    case NATS_SECURE_CONNECTION_WANTED:
      return {ErrorCode::kClosed, "NATS at " + where +
                                      " offers no TLS; what is sent there could be "
                                      "read by others"};
    case NATS_INVALID_ARG:
    case NATS_ERR:
      return {ErrorCode::kClosed,
              options.credentials_file.empty()
                  ? "NATS at " + where + " does not take this hub"
                  : "NATS at " + where + " cannot be shown the credentials in " +
                        options.credentials_file + ": they are no credentials, or damaged"};
    default:
      return {ErrorCode::kUnavailable, "no NATS server answers at " + where};
  }
}

}  // namespace roomcast::cluster
