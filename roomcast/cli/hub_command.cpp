// SPDX-License-Identifier: Apache-2.0
// roomcast hub: connects sensors and viewers in rooms, on one port.
#include <atomic>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include "roomcast/cli/command.h"
#include "roomcast/cli/hub_flags.h"
#include "roomcast/cli/json_log.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/stderr_log.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/cli/web_directory.h"
#include "roomcast/hub/access/hub_secret.h"
#include "roomcast/hub/daemon/certificate_watch.h"
#include "roomcast/hub/daemon/data_folder.h"
#include "roomcast/hub/daemon/hub_aligners.h"
#include "roomcast/hub/daemon/hub_certificate.h"
#include "roomcast/hub/daemon/hub_models.h"
#include "roomcast/hub/daemon/hub_recorders.h"
#include "roomcast/hub/daemon/hub_settings.h"
#include "roomcast/hub/daemon/hub_study.h"
#include "roomcast/hub/federation/upstream/upstream_hub.h"
#include "roomcast/hub/server/hub_server.h"
#include "roomcast/net/listen_address.h"
#include "roomcast/net/own_addresses.h"
#include "roomcast/net/static_site.h"

namespace roomcast::cli {
namespace {

/// Raises the limit of open files, which is often 1024 in a shell: every connection needs one.
void allow_many_connections() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  (void)::setrlimit(RLIMIT_NOFILE, &limit);
}

/// Makes glibc keep freed memory. Frames are allocated and freed thirty times a second; by default
/// glibc returns some memory to the kernel after each set and requests it again for the next, which
/// costs two system calls and page faults.
void keep_freed_memory() {
  constexpr int kKeptBytes = 2 << 20;
  (void)::mallopt(M_TRIM_THRESHOLD, kKeptBytes);
  (void)::mallopt(M_MMAP_THRESHOLD, kKeptBytes);
}

LogSink log_of(const hub::HubConfig& config, bool verbose) {
  return config.log == "json" ? json_log("hub") : stderr_log("hub", verbose);
}

/// A configured hub that is not running yet.
struct HubPlan {
  hub::HubConfig config;
  net::ListenAddress listen;
  hub::HubOptions options;
  std::optional<net::Certificate> certificate;
  std::optional<hub::federation::UpstreamOptions> upstream;
  std::optional<hub::federation::ClusterOptions> cluster;
};

Result<HubPlan> plan_hub(const HubFlags& flags) {
  HubPlan plan;
  auto config = hub::daemon::find_hub_config(flags.config_file);
  if (!config) return config.error();
  plan.config = with_flags(*std::move(config), flags);
  if (auto status = hub::check(plan.config); !status) return status.error();
  const auto listen = net::parse_listen_address(plan.config.listen);
  if (!listen) return listen.error();
  plan.listen = *listen;
  const auto encrypted = hub::daemon::decide_encryption(plan.config, plan.listen);
  if (!encrypted) return encrypted.error();
  auto options = hub::daemon::hub_options_of(plan.config, plan.listen, *encrypted);
  if (!options) return options.error();
  plan.options = *std::move(options);
  auto upstream = hub::daemon::upstream_of(plan.config);
  if (!upstream) return upstream.error();
  plan.upstream = *std::move(upstream);
  auto cluster = hub::daemon::cluster_of(plan.config);
  if (!cluster) return cluster.error();
  plan.cluster = *std::move(cluster);
  return plan;
}

Status find_certificate(HubPlan& plan, bool only_look) {
  auto found = hub::daemon::find_hub_certificate({.certificate_file = plan.config.tls_cert,
                                                  .key_file = plan.config.tls_key,
                                                  .self_signed = plan.config.tls_self_signed,
                                                  .data_folder = plan.config.data,
                                                  .listen_address = plan.listen.address,
                                                  .only_look = only_look});
  if (!found) return found.error();
  plan.certificate = *std::move(found);
  if (!plan.certificate) return {};
  auto tls = net::TlsServerContext::create(*plan.certificate);
  if (!tls) return tls.error();
  plan.options.tls = *std::move(tls);
  return {};
}

/// Checks for errors that would prevent a start, as far as possible without writing anything.
Status check_plan(HubPlan& plan) {
  if (auto status = find_certificate(plan, true); !status) return status;
  if (const auto folder = hub::daemon::data_folder(plan.config.data)) {
    if (auto status = hub::daemon::check_folder(*folder); !status) return status;
    if (auto status = hub::check_hub_secret(hub::secret_file_in(*folder)); !status) return status;
  }
  if (!plan.config.recordings.empty()) {
    if (auto status = hub::daemon::check_folder(plan.config.recordings); !status) return status;
  }
  if (!plan.config.study.empty()) {
    if (const auto study = study::load_plan(plan.config.study); !study) return study.error();
  }
  const auto web = find_web_directory(plan.config.web);
  if (!web) return {};
  const auto site = net::StaticSite::load(*web);
  return site ? Status() : site.error();
}

/// "All addresses" is none that another machine could use.
void print_own_addresses(bool with_ipv6) {
  const std::vector<std::string> own = net::own_addresses(with_ipv6);
  if (own.empty()) return;
  print_out("roomcast hub: from other machines, use this one's address in its place: {}\n",
            fmt::join(own, ", "));
}

void print_where(const HubPlan& plan, std::uint16_t port) {
  const std::string& address = plan.listen.address;
  const bool v6 = address.find(':') != std::string::npos;
  const std::string where = fmt::format("{}{}{}:{}", v6 ? "[" : "", address, v6 ? "]" : "", port);
  print_out("roomcast hub: open {}://{}/\n", plan.certificate ? "https" : "http", where);
  if (plan.config.tls_self_signed) {
    print_out(
        "roomcast hub: browsers will ask whether to trust its certificate; sensors and viewers "
        "trust it by\n"
        "  --hub wss://{}#sha256={}\n",
        where, net::to_string(plan.certificate->fingerprint()));
  }
  if (address == "0.0.0.0" || address == "::") print_own_addresses(v6);
  std::fflush(stdout);
}

/// Reloads renewed certificates when the hub's certificate comes from files.
std::unique_ptr<hub::daemon::CertificateWatch> watch_certificate(const HubPlan& plan,
                                                                 hub::HubServer& server,
                                                                 hub::daemon::OwnHub& own,
                                                                 std::atomic<bool>& reload,
                                                                 const LogSink& log) {
  if (plan.config.tls_cert.empty()) return nullptr;
  const auto take = [&server, &own](const net::Certificate& certificate) -> Status {
    auto tls = net::TlsServerContext::create(certificate);
    if (!tls) return tls.error();
    server.replace_tls(*std::move(tls));
    own.trust(certificate.fingerprint());
    return {};
  };
  return std::make_unique<hub::daemon::CertificateWatch>(plan.config.tls_cert, plan.config.tls_key,
                                                         take, reload, log);
}

hub::daemon::RoomRetention retention_of(std::int64_t days, std::int64_t gb) {
  return {.max_age = std::chrono::days(days),
          .max_bytes = static_cast<std::uint64_t>(gb) * 1'000'000'000};
}

hub::daemon::Retention retention_of(const hub::HubConfig& config) {
  hub::daemon::Retention retention{.usual =
                                       retention_of(config.recordings_days, config.recordings_gb)};
  for (const auto& [room, kept] : config.recording_limits)
    retention.rooms[room] = retention_of(kept.days.value_or(config.recordings_days),
                                         kept.gb.value_or(config.recordings_gb));
  return retention;
}

/// Null where no folder for recordings is configured.
std::shared_ptr<hub::daemon::HubRecorders> make_recorders(
    const hub::daemon::OwnHub& own, const hub::HubConfig& config,
    const std::optional<std::filesystem::path>& data, const LogSink& log) {
  const hub::daemon::Retention retention = retention_of(config);
  if (!config.recordings.empty())
    return std::make_shared<hub::daemon::HubRecorders>(own, config.recordings, log, retention);
  return data ? std::make_shared<hub::daemon::HubRecorders>(own, *data / "recordings", log,
                                                            retention)
              : nullptr;
}

/// Null where none are to be kept.
std::shared_ptr<hub::daemon::HubModels> make_models(
    const hub::daemon::OwnHub& own, const hub::HubConfig& config,
    const std::optional<std::filesystem::path>& data, const LogSink& log) {
  if (!config.model) return nullptr;
  return std::make_shared<hub::daemon::HubModels>(
      own, data ? std::optional(*data / "models") : std::nullopt, log);
}

/// Null where none is configured.
Result<std::shared_ptr<hub::daemon::HubStudy>> open_study(
    const hub::HubConfig& config, const std::optional<std::filesystem::path>& data) {
  if (config.study.empty()) return std::shared_ptr<hub::daemon::HubStudy>();
  if (!config.study_folder.empty())
    return hub::daemon::HubStudy::open(config.study, config.study_folder);
  const auto plan = study::load_plan(config.study);
  if (!plan) return plan.error();
  if (!data)
    return invalid_argument("a study needs a folder for its sessions: --study-folder, or --data");
  return hub::daemon::HubStudy::open(config.study, *data / ("study-" + plan->name));
}

/// The connection to other hubs, if any are configured.
hub::OpenBackplane backplane_of(const HubPlan& plan, hub::daemon::HubAligners& aligners,
                                const LogSink& log) {
  using Opened = Result<std::unique_ptr<hub::Backplane>>;
  if (plan.upstream) {
    return [options = *plan.upstream, log](hub::BackplaneContext seat) mutable -> Opened {
      options.log = log;
      return std::unique_ptr<hub::Backplane>(
          std::make_unique<hub::federation::UpstreamHub>(options, std::move(seat)));
    };
  }
  if (!plan.cluster) return {};
  hub::federation::ClusterOptions options = *plan.cluster;
  options.log = log;
  if (plan.config.align) {
    options.on_owned = [&aligners](const std::string& room, bool owns) {
      owns ? aligners.start(room) : aligners.stop(room);
    };
  }
  return [options](hub::BackplaneContext seat) -> Opened {
    auto opened = hub::federation::ClusterHub::open(options, std::move(seat));
    if (!opened) return opened.error();
    return std::unique_ptr<hub::Backplane>(*std::move(opened));
  };
}

Status run_hub(const HubFlags& flags) {
  std::atomic<bool> reload = false;
  std::function<void()> on_hangup;  // on a terminal, SIGHUP means that the terminal was closed
  if (::isatty(STDIN_FILENO) == 0) on_hangup = [&reload] { reload = true; };
  StopOnSignal stop(on_hangup);
  auto plan = plan_hub(flags);
  if (!plan) return plan.error();
  if (flags.check) {
    if (auto status = check_plan(*plan); !status) return status;
    print_out("roomcast hub: this configuration is valid; rooms:");
    for (const auto& room : plan->options.rooms) print_out(" {}", room.name);
    print_out("\n");
    return {};
  }
  if (auto status = find_certificate(*plan, false); !status) return status;
  allow_many_connections();
  keep_freed_memory();
  const LogSink log = log_of(plan->config, flags.verbose);
  hub::HubOptions options = plan->options;
  options.web_directory = find_web_directory(plan->config.web);
  auto folder = hub::daemon::make_data_folder(plan->config.data, log);
  if (!folder) return folder.error();
  options.data_folder = *std::move(folder);
  options.log = log;
  hub::daemon::OwnHub own;
  const auto recorders = make_recorders(own, plan->config, options.data_folder, log);
  options.recordings = recorders;
  const auto models = make_models(own, plan->config, options.data_folder, log);
  options.models = models;
  // Ends before the models, which take time to be written.
  hub::daemon::HubAligners aligners(own, log);
  auto study = open_study(plan->config, options.data_folder);
  if (!study) return study.error();
  options.study = *study;
  options.on_room_in_use = [&, config = plan->config](const std::string& room) {
    if (config.align && config.nats_servers.empty()) aligners.start(room);
    if (config.record && recorders) (void)recorders->start(room, "");
    if (models) models->start(room);
  };
  options.open_backplane = backplane_of(*plan, aligners, log);
  auto server = hub::HubServer::open(std::move(options));
  if (!server) return server.error();
  own.opened({.listen_address = plan->listen.address,
              .port = (*server)->port(),
              .certificate = plan->certificate ? std::optional(plan->certificate->fingerprint())
                                               : std::nullopt},
             (*server)->own_token());
  if (models) models->start_kept();
  const auto watch = watch_certificate(*plan, **server, own, reload, log);
  if (::geteuid() == 0) {
    log(LogLevel::kWarning,
        "this hub runs as root without need; run it as a user of its own, as its systemd service "
        "does");
  }
  print_where(*plan, (*server)->port());
  if (*study)
    print_out("roomcast hub: participants of the study open that address with ?study=1\n");
  std::fflush(stdout);
  (*server)->run(stop.token());
  return {};
}

}  // namespace

void add_hub_command(CLI::App& app, Command& chosen) {
  auto flags = std::make_shared<HubFlags>();
  CLI::App* command =
      app.add_subcommand("hub", "Connect sensors and viewers in rooms, and serve the page");
  add_hub_flags(*command, *flags);
  command->footer(
      "Examples:\n"
      "  roomcast hub\n"
      "  roomcast hub --listen 0.0.0.0:7600\n"
      "  roomcast hub --listen 0.0.0.0:443 --tls-cert fullchain.pem --tls-key privkey.pem\n"
      "  roomcast hub --config /etc/roomcast.toml --check\n"
      "  roomcast hub --room lab --upstream wss://hub.example.org:7600 --upstream-token-file t\n"
      "  roomcast hub --room lab --nats nats://a:4222,nats://b:4222 --nats-credentials hub.creds\n"
      "Then open the address it prints and start sensors. From other machines they need tokens:\n"
      "roomcast token --help.");
  command->callback(
      [flags, &chosen] { chosen = [flags] { return finish("hub", run_hub(*flags)); }; });
}

}  // namespace roomcast::cli
