// SPDX-License-Identifier: Apache-2.0
// StudyApi: the part of the hub's HTTP interface that participants' pages use in a study
// (docs/spec/admin.openapi.yaml, docs/spec/study.md). Participants are known by a secret key; their
// calls are not in the audit log, which has addresses. Threading: the rooms' thread; answers come
// later, on any thread.
#pragma once

#include <string>

#include "roomcast/hub/access/rate_limit.h"
#include "roomcast/hub/admin/admin_routes.h"
#include "roomcast/hub/runtime/study_desk.h"
#include "roomcast/net/http_request.h"

namespace roomcast::hub {

class StudyApi {
 public:
  static constexpr double kEnrollmentsPerSecond = 1, kEnrollmentsAtOnce = 30;

  /// `desk`: null if this hub runs no study.
  explicit StudyApi(StudyDesk* desk) : desk_(desk) {}

  [[nodiscard]] static bool has(AdminCall call);
  /// The room of the study; empty: the hub's only one, or there is no study.
  [[nodiscard]] std::string room() const { return desk_ == nullptr ? "" : desk_->room(); }

  void answer(const MatchedRoute& match, const std::string& body, const net::Respond& respond);

 private:
  void enroll(const std::string& body, const net::Respond& respond);
  void resume(const MatchedRoute& match, const std::string& body, const net::Respond& respond);
  void picture(const MatchedRoute& match, const std::string& body, const net::Respond& respond);
  void log(const MatchedRoute& match, const std::string& body, const net::Respond& respond);

  StudyDesk* const desk_;
  SteadyClock clock_;
  RateLimit enrollments_{kEnrollmentsPerSecond, kEnrollmentsAtOnce};
};

}  // namespace roomcast::hub
