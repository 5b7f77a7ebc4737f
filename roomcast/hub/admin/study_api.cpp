// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/study_api.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "roomcast/hub/admin/admin_answer.h"

namespace roomcast::hub {

namespace {

using Json = nlohmann::json;

net::HttpResponse bad_study_request(const char* sentence) {
  return error_answer(400, "bad_request", sentence);
}

/// Empty: there is none, or it is something else.
std::string study_text_in(const Json& json, const char* key) {
  const auto found = json.is_object() ? json.find(key) : json.end();
  return json.is_object() && found != json.end() && found->is_string() ? found->get<std::string>()
                                                                       : std::string();
}

net::HttpResponse study_refusal(const Error& error) {
  if (error.code == ErrorCode::kUnavailable) return error_answer(409, "conflict", error.message);
  return error_answer(error);
}

StudyDesk::WhenDone answering(int status, const net::Respond& respond) {
  return [status, respond](const Result<std::string>& done) {
    respond(done ? json_answer(status, Json::parse(*done)) : study_refusal(done.error()));
  };
}

}  // namespace

bool StudyApi::has(AdminCall call) {
  return call == AdminCall::kStudy || call == AdminCall::kEnroll || call == AdminCall::kResume ||
         call == AdminCall::kLogSession || call == AdminCall::kStudyPicture;
}

void StudyApi::answer(const MatchedRoute& match, const std::string& body,
                      const net::Respond& respond) {
  if (desk_ == nullptr) return respond(error_answer(404, "not_found", "this hub runs no study"));
  switch (match.route.call) {
    case AdminCall::kStudy:
      return respond(json_answer(200, Json::parse(desk_->plan())));
    case AdminCall::kEnroll:
      return enroll(body, respond);
    case AdminCall::kResume:
      return resume(match, body, respond);
    case AdminCall::kStudyPicture:
      return picture(match, body, respond);
    default:
      return log(match, body, respond);
  }
}

void StudyApi::enroll(const std::string& body, const net::Respond& respond) {
  const std::string plan = study_text_in(Json::parse(body, nullptr, false), "agrees_to");
  if (plan.empty())
    return respond(bad_study_request(R"(the body must be {"agrees_to": "the id of the plan"})"));
  if (!enrollments_.take(1, clock_.now())) {
    return respond(error_answer(429, "too_fast",
                                "many people begin this study at the moment; try again soon"));
  }
  desk_->enroll(plan, answering(201, respond));
}

void StudyApi::resume(const MatchedRoute& match, const std::string& body,
                      const net::Respond& respond) {
  const std::string key = study_text_in(Json::parse(body, nullptr, false), "key");
  desk_->resume({match.parameters[0], key}, answering(200, respond));
}

void StudyApi::picture(const MatchedRoute& match, const std::string& body,
                       const net::Respond& respond) {
  const Json json = Json::parse(body, nullptr, false);
  const std::string kind = study_text_in(json, "kind"),
                    comparison = study_text_in(json, "comparison");
  const bool is_whole = (kind == "real" || kind == "drawn") && !comparison.empty() &&
                        json.contains("pair") && json["pair"].is_number_unsigned();
  if (!is_whole) {
    return respond(bad_study_request(
        R"(the body must be {"key": "...", "comparison": "...", "pair": 0, "kind": "real"})"));
  }
  desk_->picture({match.parameters[0], study_text_in(json, "key")},
                 {comparison, json["pair"].get<std::size_t>(), kind == "real"},
                 [respond](Result<PictureFile> file) {
                   if (!file) return respond(study_refusal(file.error()));
                   net::HttpResponse response;
                   response.content_type = file->content_type;
                   response.body = std::make_shared<const std::string>(std::move(file->bytes));
                   response.cache_control = "no-store";
                   respond(std::move(response));
                 });
}

void StudyApi::log(const MatchedRoute& match, const std::string& body,
                   const net::Respond& respond) {
  const Json json = Json::parse(body, nullptr, false);
  const bool is_whole = json.is_object() && json.contains("batch") && json.contains("records") &&
                        json["batch"].is_number_unsigned() && json["records"].is_array();
  if (!is_whole) {
    return respond(
        bad_study_request(R"(the body must be {"key": "...", "batch": 1, "records": [...]})"));
  }
  desk_->log({match.parameters[0], study_text_in(json, "key")}, json["batch"].get<std::uint64_t>(),
             json["records"].dump(-1, ' ', false, Json::error_handler_t::replace),
             answering(200, respond));
}

}  // namespace roomcast::hub
