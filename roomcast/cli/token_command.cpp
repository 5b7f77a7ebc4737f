// SPDX-License-Identifier: Apache-2.0
// roomcast token: creates, lists and revokes tokens of a hub whose folder is on this machine. A
// running hub picks up the change.
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/cli/command.h"
#include "roomcast/cli/qr_code.h"
#include "roomcast/cli/time_span.h"
#include "roomcast/hub/access/hub_secret.h"
#include "roomcast/hub/admin/admin_answer.h"
#include "roomcast/hub/admin/token_request.h"
#include "roomcast/hub/daemon/data_folder.h"
#include "roomcast/hub/daemon/hub_settings.h"
#include "roomcast/hub/store/hub_store.h"

namespace roomcast::cli {
namespace {

using Json = nlohmann::json;

struct TokenCommand {
  std::string config, data, room, role, name, ttl = "8h", link, revoke;
  bool qr = false, list = false, json = false;
};

Error wrong_usage(std::string sentence) {
  return {ErrorCode::kInvalidArgument, std::move(sentence)};
}

/// The hub's folder, found by the same rules as the hub uses.
Result<std::filesystem::path> find_folder(const TokenCommand& command) {
  const auto config = hub::daemon::find_hub_config(command.config);
  if (!config) return config.error();
  const auto folder = hub::daemon::data_folder(command.data.empty() ? config->data : command.data);
  if (!folder) return wrong_usage("there is no home folder; name the hub's with --data");
  return *folder;
}

/// True also if the secret exists but this user may not read the folder.
bool has_secret(const std::filesystem::path& folder) {
  std::error_code error;
  return std::filesystem::exists(hub::secret_file_in(folder), error) ||
         error == std::errc::permission_denied;
}

/// Opens the store that a hub has written to this folder.
Result<std::unique_ptr<hub::HubStore>> open_book(const std::filesystem::path& folder) {
  if (has_secret(folder)) return hub::HubStore::open(folder);
  return Error{ErrorCode::kNotFound, "no hub has its secret in " + folder.string() +
                                         ", so no token was made there; name the hub's folder with "
                                         "--data, or its configuration with --config"};
}

/// Opens the store or creates it: a token may be made before the hub has ever run.
Result<std::unique_ptr<hub::HubStore>> open_or_begin_book(const std::filesystem::path& folder) {
  if (auto made = hub::daemon::make_data_folder(folder); !made) return made.error();
  return hub::HubStore::open(folder);
}

Status list_tokens(const hub::HubStore& book, bool as_json) {
  const auto tokens = book.tokens(hub::kAllRooms);
  if (!tokens) return tokens.error();
  if (as_json) {
    Json list = Json::array();
    for (const auto& token : *tokens) list.push_back(hub::token_json(token));
    fmt::print("{}\n", Json{{"tokens", list}}.dump(1));
    return {};
  }
  fmt::print("{:34}{:20}{:8}{:20}{}\n", "ID", "ROOM", "ROLE", "NAME", "HOLDS");
  for (const auto& token : *tokens) {
    const auto left = token.claims.expires_at - book.now();
    fmt::print("{:34}{:20}{:8}{:20}{}\n", token.claims.id, token.claims.grant.room,
               hub::name_of(token.claims.grant.role), token.claims.grant.name,
               (token.is_code ? "code, " : "") + (token.revoked ? "revoked"
                                                  : left <= 0   ? "expired"
                                                                : format_time_span(left)));
  }
  return {};
}

Result<hub::TokenRequest> request_of(const TokenCommand& command) {
  const auto role = hub::token_role(command.role);
  if (!role) return wrong_usage("--role is sensor, viewer, hub or admin");
  const auto ttl = parse_time_span(command.ttl);
  if (!ttl) return ttl.error();
  std::string room = command.room;
  if (room.empty() && *role == hub::TokenRole::kAdmin) room = hub::kAllRooms;
  if (room.empty()) return wrong_usage("say which room with --room");
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

Status make_token(const TokenCommand& command, const std::filesystem::path& folder) {
  const auto request = request_of(command);
  if (!request) return request.error();
  const bool is_first = !has_secret(folder);
  const auto book = open_or_begin_book(folder);
  if (!book) return book.error();
  auto made = hub::make_token_for(*request, **book);
  if (!made) return made.error();
  if (is_first) {
    fmt::print(stderr,
               "roomcast token: no hub had its secret in {0}, so a new one was made: only a hub "
               "with --data {0} takes what was made with it\n",
               folder.string());
  }
  if (request->once) (*made)["link"] = link_of(command.link, (*made)["fragment"]);
  if (command.json) {
    fmt::print("{}\n", made->dump());
    return {};
  }
  const std::string shown = request->once ? (*made)["link"] : (*made)["token"];
  fmt::print("{}\n", shown);
  if (request->once) {
    fmt::print(stderr,
               "Good for once, within {}; then for {}. In a program: --token {}\n"
               "Until it was used it is taken back with roomcast token --revoke {}\n",
               format_time_span(hub::HubStore::kCodeTtl), format_time_span(request->ttl),
               (*made)["code"].get<std::string>(), (*made)["id"].get<std::string>());
  }
  if (!command.qr) return {};
  const auto qr = qr_code_for_terminal(shown);
  if (!qr) return qr.error();
  fmt::print("{}", *qr);
  return {};
}

Status run_token(const TokenCommand& command) {
  const auto folder = find_folder(command);
  if (!folder) return folder.error();
  if (!command.list && command.revoke.empty()) return make_token(command, *folder);
  const auto book = open_book(*folder);
  if (!book) return book.error();
  return command.list ? list_tokens(**book, command.json) : (*book)->revoke(command.revoke);
}

}  // namespace

void add_token_command(CLI::App& app, Command& chosen) {
  auto values = std::make_shared<TokenCommand>();
  CLI::App* command = app.add_subcommand(
      "token", "Let people, sensors and admins into the rooms of the hub on this machine");
  command->add_option("--role", values->role,
                      "sensor, viewer, admin, or hub: one that serves the room on");
  command->add_option("--room", values->room, "The room (without one an admin's is for all)");
  command->add_option("--name", values->name,
                      "Whom it is for; a sensor's is good for the sensor of this name only");
  command->add_option("--ttl", values->ttl, "How long it holds: 90s, 30m, 8h, 7d")
      ->capture_default_str();
  command->add_option("--link", values->link,
                      "The hub's address; gives a link that is good for once instead");
  command->add_flag("--qr", values->qr, "Also as a QR code");
  command->add_flag("--list", values->list,
                    "Say which tokens there are, and which codes nobody has used");
  command->add_option(
      "--revoke", values->revoke,
      "Id of a token, or of a code that nobody has used, that shall hold no longer; "
      "who came with it is sent away");
  command->add_option("--config", values->config,
                      "The hub's configuration, in which its folder is looked up");
  command->add_option("--data", values->data,
                      "The hub's folder (default: as the hub finds it: ROOMCAST_HUB_DATA, the "
                      "configuration, ~/.local/state/roomcast)");
  command->add_flag("--json", values->json, "For scripts");
  command->footer(
      "Examples:\n"
      "  roomcast token --room lab --role sensor --name left --ttl 30d\n"
      "  roomcast token --room lab --role viewer --link https://hub.example.org:7600 --qr\n"
      "  roomcast token --role admin --ttl 1h\n"
      "  roomcast token --list\n"
      "  roomcast token --revoke ID\n"
      "  sudo roomcast token --data /var/lib/roomcast --role admin --ttl 1h    (of the service)");
  command->callback(
      [values, &chosen] { chosen = [values] { return finish("token", run_token(*values)); }; });
}

}  // namespace roomcast::cli
