// SPDX-License-Identifier: Apache-2.0
// roomcast hub: joins sensors and viewers, one room, one port.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include <fmt/format.h>

#include "roomcast/cli/command.h"
#include "roomcast/cli/hub_aligner.h"
#include "roomcast/cli/hub_certificate.h"
#include "roomcast/cli/listen_address.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/cli/web_directory.h"
#include "roomcast/hub/hub_server.h"

namespace roomcast::cli {
namespace {

struct HubCommandOptions {
  std::string listen = "127.0.0.1:7600";
  std::string room = "room";
  std::string web;
  HubCertificateOptions certificate;
  std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
  bool insecure = false;
  bool align = true;
  std::string key;
  bool verbose = false;
};

/// A sentence when the hub would speak in the clear to other machines, and nobody said it may.
Status check_secrecy(const HubCommandOptions& options, bool loopback, bool encrypted) {
  if (encrypted && options.insecure) {
    return Error{ErrorCode::kInvalidArgument, "--insecure and TLS exclude each other"};
  }
  if (loopback || encrypted || options.insecure) return {};
  return Error{ErrorCode::kInvalidArgument,
               "beyond this machine a hub encrypts: say --tls-self-signed, or --tls-cert and "
               "--tls-key; or --insecure if you trust everyone on the network"};
}

/// In the folder for what the hub keeps; nothing where there can be none.
std::optional<std::filesystem::path> find_state_file(const std::string& data_folder) {
  const auto folder = data_folder.empty() ? default_data_folder()
                                          : std::optional<std::filesystem::path>(data_folder);
  if (!folder) return std::nullopt;
  std::error_code error;
  std::filesystem::create_directories(*folder, error);
  if (error) return std::nullopt;
  return *folder / "hub.sqlite";
}

void print_where(const ListenAddress& listen, std::uint16_t port,
                 const std::optional<net::Certificate>& certificate, bool self_signed) {
  const bool v6 = listen.address.find(':') != std::string::npos;
  const std::string where =
      fmt::format("{}{}{}:{}", v6 ? "[" : "", listen.address, v6 ? "]" : "", port);
  fmt::print("roomcast hub: open {}://{}/\n", certificate ? "https" : "http", where);
  if (self_signed) {
    fmt::print(
        "roomcast hub: browsers will ask whether to trust its certificate; sensors and viewers "
        "trust it with\n  --hub wss://{}#sha256={}\n",
        where, net::to_string(certificate->fingerprint()));
  }
  std::fflush(stdout);
}

Status run_hub(const HubCommandOptions& options) {
  StopOnSignal stop;
  const auto listen = parse_listen_address(options.listen);
  if (!listen) return listen.error();
  HubCertificateOptions certificate_options = options.certificate;
  certificate_options.listen_address = listen->address;
  const auto certificate = find_hub_certificate(certificate_options);
  if (!certificate) return certificate.error();
  const bool encrypted = certificate->has_value();
  if (auto status = check_secrecy(options, listen->loopback, encrypted); !status) return status;
  hub::HubOptions hub;
  hub.address = listen->address;
  hub.port = listen->port;
  hub.room = options.room;
  hub.threads = options.threads;
  hub.web_directory = find_web_directory(options.web);
  if (encrypted) {
    auto tls = net::TlsServerContext::create(**certificate);
    if (!tls) return tls.error();
    hub.tls = *std::move(tls);
  }
  hub.log = stderr_log("hub", options.verbose);
  if (options.align) {
    hub.aligner_key = options.key.empty() ? make_aligner_key() : options.key;
  }
  hub.state_file = find_state_file(options.certificate.data_folder);
  HubAlignerOptions aligner_options{
      .listen_address = listen->address, .certificate = {}, .key = hub.aligner_key, .log = hub.log};
  auto server = hub::HubServer::open(std::move(hub));
  if (!server) return server.error();
  aligner_options.port = (*server)->port();
  if (encrypted) aligner_options.certificate = (*certificate)->fingerprint();
  std::unique_ptr<aligner::RoomAligner> aligner;
  if (options.align) {
    auto started = start_hub_aligner(aligner_options);
    if (!started) return started.error();
    aligner = *std::move(started);
  }
  print_where(*listen, (*server)->port(), *certificate, options.certificate.self_signed);
  (*server)->run(stop.token());
  return {};
}

}  // namespace

void add_hub_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<HubCommandOptions>();
  CLI::App* command =
      app.add_subcommand("hub", "Join sensors and viewers in a room, and serve the page");
  command->add_option("--listen", options->listen, "ADDRESS:PORT; port 0 takes any free one")
      ->capture_default_str();
  command->add_option("--room", options->room, "The room's name")->capture_default_str();
  command->add_option("--web", options->web,
                      "Folder of the built page (default: the one beside this program)");
  command->add_option("--tls-cert", options->certificate.certificate_file,
                      "PEM file: the certificate, then those that sign it");
  command->add_option("--tls-key", options->certificate.key_file, "PEM file: its private key");
  command->add_flag("--tls-self-signed", options->certificate.self_signed,
                    "Encrypt with a certificate that the hub makes for itself and keeps");
  command->add_option("--data", options->certificate.data_folder,
                      "Folder for what the hub keeps (default: ~/.local/state/roomcast)");
  command->add_option("--threads", options->threads, "Among which connections are dealt out")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command->add_flag("--insecure", options->insecure,
                    "Listen beyond this machine although nothing is encrypted");
  command->add_flag("!--no-align", options->align,
                    "Leave sensors where they say they are; work out nothing");
  command
      ->add_option("--key", options->key,
                   "Who knows it may put sensors in their place: `roomcast nudge`, and the page "
                   "when it is opened with #key=KEY (default: nobody)")
      ->check(CLI::Validator(
          [](std::string& key) { return key.size() <= 64 ? "" : "a key has at most 64 bytes"; },
          ""));
  command->add_flag("--verbose", options->verbose, "Say who joins and leaves");
  command->footer(
      "Examples:\n"
      "  roomcast hub\n"
      "  roomcast hub --listen 0.0.0.0:7600 --tls-self-signed\n"
      "  roomcast hub --listen 0.0.0.0:443 --tls-cert fullchain.pem --tls-key privkey.pem\n"
      "Then open the address it prints and start sensors.");
  command->callback(
      [options, &chosen] { chosen = [options] { return finish("hub", run_hub(*options)); }; });
}

}  // namespace roomcast::cli
