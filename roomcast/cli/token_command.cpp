// SPDX-License-Identifier: Apache-2.0
// roomcast token: creates, lists and revokes tokens of a hub whose folder is on this machine. A
// running hub picks up the change.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/cli/command.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/qr_code.h"
#include "roomcast/cli/stderr_log.h"
#include "roomcast/cli/time_span.h"
#include "roomcast/hub/access/hub_secret.h"
#include "roomcast/hub/admin/admin_answer.h"
#include "roomcast/hub/admin/token_request.h"
#include "roomcast/hub/daemon/data_folder.h"
#include "roomcast/hub/daemon/hub_settings.h"
#include "roomcast/hub/store/hub_store.h"
#include "roomcast/io/private_file.h"

namespace roomcast::cli {
namespace {

using Json = nlohmann::json;

struct TokenCommand {
  std::string config, data, room, role, name, ttl = "8h", link, revoke, out;
  bool qr = false, list = false, json = false;
};

Error wrong_usage(std::string sentence) {
  return {ErrorCode::kInvalidArgument, std::move(sentence)};
}

/// The hub's folder, found by the same rules as the hub uses.
Result<std::filesystem::path> find_folder(const TokenCommand& command,
                                          const hub::HubConfig& config) {
  const auto folder = hub::daemon::data_folder(command.data.empty() ? config.data : command.data);
  if (!folder) return wrong_usage("there is no home folder; give the hub's folder with --data");
  return *folder;
}

/// True also if the secret exists but this user may not read the folder.
bool has_secret(const std::filesystem::path& folder) {
  std::error_code error;
  return std::filesystem::exists(hub::secret_file_in(folder), error) ||
         error == std::errc::permission_denied;
}

/// Opens the store that a hub has written to this folder.
Result<std::unique_ptr<hub::HubStore>> open_hub_store(const std::filesystem::path& folder) {
  if (has_secret(folder)) return hub::HubStore::open(folder);
  return Error{ErrorCode::kNotFound, "no hub's secret is in " + folder.string() +
                                         ", so it has no tokens; give the hub's folder with "
                                         "--data or its configuration with --config"};
}

/// Opens the store or creates it: a token may be made before the hub has ever run.
Result<std::unique_ptr<hub::HubStore>> open_or_create_hub_store(
    const std::filesystem::path& folder) {
  if (auto made = hub::daemon::make_data_folder(folder, stderr_log("token", false)); !made)
    return made.error();
  return hub::HubStore::open(folder);
}

Status list_tokens(const hub::HubStore& store, bool as_json) {
  const auto tokens = store.tokens(hub::kAllRooms);
  if (!tokens) return tokens.error();
  if (as_json) {
    Json list = Json::array();
    for (const auto& token : *tokens) list.push_back(hub::token_json(token));
    print_out("{}\n", Json{{"tokens", list}}.dump(1));
    return {};
  }
  print_out("{:34}{:20}{:8}{:20}{}\n", "ID", "ROOM", "ROLE", "NAME", "HOLDS");
  for (const auto& token : *tokens) {
    const auto left = token.claims.expires_at - store.now();
    print_out("{:34}{:20}{:8}{:20}{}\n", token.claims.id, token.claims.grant.room,
              hub::name_of(token.claims.grant.role), token.claims.grant.name,
              (token.is_code ? "code, " : "") + (token.revoked ? "revoked"
                                                 : left <= 0   ? "expired"
                                                               : format_time_span(left)));
  }
  return {};
}

Result<hub::TokenRequest> request_of(const TokenCommand& command) {
  const auto role = hub::token_role(command.role);
  if (!role) return wrong_usage("give --role: sensor, viewer, hub or admin");
  const auto ttl = parse_time_span(command.ttl);
  if (!ttl) return ttl.error();
  std::string room = command.room;
  if (room.empty() && *role == hub::TokenRole::kAdmin) room = hub::kAllRooms;
  if (room.empty()) return wrong_usage("give the room with --room");
  return hub::TokenRequest{.grant = {.room = room, .role = *role, .name = command.name},
                           .ttl = *ttl,
                           .once = !command.link.empty()};
}

/// The page's address with `fragment`, which the browser does not send to the server.
std::string link_of(std::string page, const std::string& fragment) {
  if (page.find("://") == std::string::npos) page = "https://" + page;
  if (!page.ends_with('/')) page += '/';
  return page + fragment;
}

/// A room that only a running hub knows, from its --room or from other hubs, cannot be told from
/// one whose name was mistyped: so this is no more than a warning.
void warn_of_unknown_room(const std::string& room, const hub::HubConfig& config,
                          hub::HubStore& store) {
  const auto configured = hub::rooms_of(config, hub::AccessRule::kToken);
  const auto opened = store.rooms().load();
  const bool has_others = !config.upstream_hubs.empty() || !config.nats_servers.empty();
  if (room == hub::kAllRooms || has_others || !configured || !opened) return;
  std::vector<std::string> known;
  for (const auto* rooms : {&*configured, &*opened}) {
    for (const hub::RoomSettings& settings : *rooms) known.push_back(settings.name);
  }
  if (std::ranges::find(known, room) != known.end()) return;
  print_err(
      "roomcast token: no room \"{0}\" is in this hub's configuration, nor was one opened; it has "
      "\"{1}\". The token holds once there is such a room: roomcast hub --room {0}\n",
      one_line(room), one_line(fmt::format("{}", fmt::join(known, "\", \""))));
}

/// To stdout, or to a new file that only this user may read.
Status put_token(const std::string& text, const std::string& file) {
  if (!file.empty()) return io::write_private_file(file, text + "\n");
  print_out("{}\n", text);
  return {};
}

Status make_token(const TokenCommand& command, const hub::HubConfig& config,
                  const std::filesystem::path& folder) {
  const auto request = request_of(command);
  if (!request) return request.error();
  const bool is_first = !has_secret(folder);
  const auto store = open_or_create_hub_store(folder);
  if (!store) return store.error();
  auto made = hub::make_token_for(*request, **store);
  if (!made) return made.error();
  if (is_first) {
    print_err(
        "roomcast token: {0} had no hub's secret, so a new one was made: only a hub with "
        "--data {0} accepts this token\n",
        folder.string());
  }
  warn_of_unknown_room(request->grant.room, config, **store);
  if (request->once) (*made)["link"] = link_of(command.link, (*made)["fragment"]);
  const std::string shown = request->once ? (*made)["link"] : (*made)["token"];
  if (auto put = put_token(command.json ? made->dump() : shown, command.out); !put) {
    (void)(*store)->revoke((*made)["id"].get<std::string>());  // nobody has it
    return put;
  }
  if (command.json) return {};
  if (request->once) {
    print_err(
        "The link works once, within {}; its token is valid for {}. For a program: --token {}\n"
        "Before its use it can be revoked: roomcast token --revoke {}\n",
        format_time_span(hub::HubStore::kCodeTtl), format_time_span(request->ttl),
        (*made)["code"].get<std::string>(), (*made)["id"].get<std::string>());
  }
  if (!command.qr) return {};
  const auto qr = qr_code_for_terminal(shown);
  if (!qr) return qr.error();
  (void)write_raw(stdout, *qr);  // with the terminal's own colours
  return {};
}

Status run_token(const TokenCommand& command) {
  const auto config = hub::daemon::find_hub_config(command.config);
  if (!config) return config.error();
  const auto folder = find_folder(command, *config);
  if (!folder) return folder.error();
  if (!command.list && command.revoke.empty()) return make_token(command, *config, *folder);
  const auto store = open_hub_store(*folder);
  if (!store) return store.error();
  return command.list ? list_tokens(**store, command.json) : (*store)->revoke(command.revoke);
}

}  // namespace

void add_token_command(CLI::App& app, Command& chosen) {
  auto values = std::make_shared<TokenCommand>();
  CLI::App* command =
      app.add_subcommand("token", "Make, list and revoke tokens of the hub on this machine");
  command->add_option("--role", values->role,
                      "sensor, viewer, admin, or hub (a relay of the room)");
  command->add_option("--room", values->room,
                      "The room (an admin's token without one is for all rooms)");
  command->add_option(
      "--name", values->name,
      "Name of its owner; a sensor's token is valid for the sensor of this name only");
  command->add_option("--ttl", values->ttl, "Period of validity: 90s, 30m, 8h, 7d")
      ->capture_default_str();
  command->add_option("--link", values->link,
                      "The hub's address; makes a link that works once instead of a token");
  CLI::Option* const out = command->add_option(
      "--out", values->out, "Write the token or link to this new file, which only you may read");
  command->add_flag("--qr", values->qr, "Also as a QR code");
  command->add_flag("--list", values->list, "List tokens and unused codes")->excludes(out);
  command
      ->add_option(
          "--revoke", values->revoke,
          "ID of a token or unused code to revoke; clients that joined with it are disconnected")
      ->excludes(out);
  command->add_option("--config", values->config,
                      "The hub's configuration file, which names its folder");
  command->add_option("--data", values->data,
                      "The hub's folder (default: ROOMCAST_HUB_DATA, the configuration's, "
                      "~/.local/state/roomcast)");
  command->add_flag("--json", values->json, "Print JSON");
  command->footer(
      "Examples:\n"
      "  roomcast token --room lab --role sensor --name left --ttl 30d --out left.token\n"
      "  roomcast token --room lab --role viewer --link https://hub.example.org:7600 --qr\n"
      "  roomcast token --role admin --ttl 1h\n"
      "  roomcast token --list\n"
      "  roomcast token --revoke ID\n"
      "  sudo roomcast token --data /var/lib/roomcast --role admin --ttl 1h    (of the service)");
  command->callback(
      [values, &chosen] { chosen = [values] { return finish("token", run_token(*values)); }; });
}

}  // namespace roomcast::cli
