// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/admin_audit.h"

#include <utility>

#include <nlohmann/json.hpp>

namespace roomcast::hub {

namespace {

using Json = nlohmann::json;

struct Outcome {
  std::string about;  // the object that was made: a token's ID or a room's name
  std::string error, sentence;
};

std::string text_of(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

Outcome outcome_of(const net::HttpResponse& response) {
  const Json json = Json::parse(response.body ? *response.body : "", nullptr, false);
  if (!json.is_object()) return {};
  if (const auto error = json.find("error"); error != json.end() && error->is_object())
    return {.about = "", .error = text_of(*error, "code"), .sentence = text_of(*error, "sentence")};
  const std::string id = text_of(json, "id");
  return {.about = id.empty() ? text_of(json, "name") : id, .error = "", .sentence = ""};
}

std::string described(const AuditedCall& call) {
  if (call.token_id.empty()) return "a caller without a valid token";
  return "\"" + call.name + "\" (token " + call.token_id + ")";
}

void log_call(const LogSink& log, const AuditedCall& call, const net::HttpResponse& response) {
  const Outcome outcome = outcome_of(response);
  const bool is_done = response.status < 400;
  std::string line = described(call) + " from " + call.peer + ": " + call.method + " " + call.path +
                     (is_done ? ": done" : " is refused: " + outcome.sentence);
  if (!outcome.about.empty()) line += ", " + outcome.about;
  log(LogLevel::kInfo, line,
      {{"event", "admin"},
       {"method", call.method},
       {"path", call.path},
       {"peer", call.peer},
       {"token", call.token_id},
       {"name", call.name},
       {"about", outcome.about},
       {"status", std::to_string(response.status)},
       {"error", outcome.error}});
}

bool is_refusal(int status) {
  return status == 401 || status == 403;
}

}  // namespace

net::Respond audited(const LogSink& log, AuditedCall call, net::Respond respond) {
  if (!log) return respond;
  return [log, call = std::move(call), respond = std::move(respond)](net::HttpResponse response) {
    const bool changes = call.method != "GET" && !call.is_frequent;
    if (changes || is_refusal(response.status)) log_call(log, call, response);
    respond(std::move(response));
  };
}

}  // namespace roomcast::hub
