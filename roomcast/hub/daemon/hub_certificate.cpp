// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/hub_certificate.h"

#include <system_error>
#include <utility>
#include <vector>

#include <boost/asio/ip/host_name.hpp>

#include "roomcast/hub/daemon/data_folder.h"
#include "roomcast/io/private_folder.h"

namespace roomcast::hub::daemon {

namespace fs = std::filesystem;

namespace {

constexpr char kSelfSignedName[] = "self-signed.pem";

Error wrong_usage(std::string sentence) {
  return {ErrorCode::kInvalidArgument, std::move(sentence)};
}

/// Nothing: there is none yet, and `only_look` is set.
Result<std::optional<net::Certificate>> find_self_signed(const fs::path& folder,
                                                         const HubCertificateOptions& options) {
  const fs::path file = folder / kSelfSignedName;
  std::error_code error;
  const bool is_there = fs::exists(file, error);
  if (!is_there && options.only_look) return std::optional<net::Certificate>();
  if (!is_there) (void)io::make_private_folder(folder, {});  // if that fails, saving says why
  auto certificate = is_there
                         ? net::Certificate::load(file, file)
                         : net::Certificate::make_self_signed(own_hosts(options.listen_address));
  if (!certificate) return certificate.error();
  if (is_there) return std::optional(*std::move(certificate));
  if (auto status = certificate->save(file); !status) return status.error();
  return std::optional(*std::move(certificate));
}

}  // namespace

std::vector<std::string> own_hosts(const std::string& listen_address) {
  std::vector<std::string> hosts = {"localhost", "127.0.0.1", "::1"};
  boost::system::error_code error;
  const std::string name = boost::asio::ip::host_name(error);
  if (!error && !name.empty() && name != "localhost") {
    hosts.push_back(name);
    if (name.find('.') == std::string::npos) hosts.push_back(name + ".local");
  }
  const bool any = listen_address == "0.0.0.0" || listen_address == "::";
  if (!listen_address.empty() && !any) hosts.push_back(listen_address);
  return hosts;
}

Result<std::optional<net::Certificate>> find_hub_certificate(const HubCertificateOptions& options) {
  const bool from_files = !options.certificate_file.empty() || !options.key_file.empty();
  if (from_files && options.self_signed) {
    return wrong_usage("use either --tls-self-signed or --tls-cert and --tls-key");
  }
  if (!from_files && !options.self_signed) return std::optional<net::Certificate>();
  if (options.self_signed) {
    const auto folder = data_folder(options.data_folder);
    if (folder) return find_self_signed(*folder, options);
    return wrong_usage("there is no home folder to keep the certificate in; name one with --data");
  }
  if (options.certificate_file.empty() || options.key_file.empty()) {
    return wrong_usage("--tls-cert and --tls-key go together");
  }
  auto certificate = net::Certificate::load(options.certificate_file, options.key_file);
  if (!certificate) return certificate.error();
  return std::optional(*std::move(certificate));
}

}  // namespace roomcast::hub::daemon
