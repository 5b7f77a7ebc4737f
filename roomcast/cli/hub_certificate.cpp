// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/hub_certificate.h"

#include <cstdlib>
#include <system_error>
#include <utility>
#include <vector>

#include <boost/asio/ip/host_name.hpp>

namespace roomcast::cli {

namespace fs = std::filesystem;

namespace {

constexpr char kSelfSignedName[] = "self-signed.pem";

Error wrong_usage(std::string sentence) {
  return {ErrorCode::kInvalidArgument, std::move(sentence)};
}

Result<net::Certificate> keep_self_signed(const fs::path& folder,
                                          const std::string& listen_address) {
  const fs::path file = folder / kSelfSignedName;
  std::error_code error;
  if (fs::exists(file, error)) return net::Certificate::load(file, file);
  fs::create_directories(folder, error);
  auto made = net::Certificate::make_self_signed(own_hosts(listen_address));
  if (!made) return made;
  if (auto status = made->save(file); !status) return status.error();
  return made;
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

std::optional<fs::path> default_data_folder() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state == '/') {
    return fs::path(state) / "roomcast";
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/') {
    return fs::path(home) / ".local" / "state" / "roomcast";
  }
  return std::nullopt;
}

Result<std::optional<net::Certificate>> find_hub_certificate(const HubCertificateOptions& options) {
  const bool from_files = !options.certificate_file.empty() || !options.key_file.empty();
  if (from_files && options.self_signed) {
    return wrong_usage("use either --tls-self-signed or --tls-cert and --tls-key");
  }
  if (!from_files && !options.self_signed) return std::optional<net::Certificate>();
  auto certificate = [&]() -> Result<net::Certificate> {
    if (from_files) {
      if (options.certificate_file.empty() || options.key_file.empty()) {
        return wrong_usage("--tls-cert and --tls-key go together");
      }
      return net::Certificate::load(options.certificate_file, options.key_file);
    }
    const auto folder = options.data_folder.empty() ? default_data_folder()
                                                    : std::optional<fs::path>(options.data_folder);
    if (!folder)
      return wrong_usage(
          "there is no home folder to keep the certificate in; name one with --data");
    return keep_self_signed(*folder, options.listen_address);
  }();
  if (!certificate) return certificate.error();
  return std::optional(*std::move(certificate));
}

}  // namespace roomcast::cli
