// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/xr/test_runtime/test_runtime.h"

#include "roomcast/viewer/xr/test_runtime/session_record.h"

namespace roomcast::viewer::xr {

SessionRecord& session_record() {
  static SessionRecord record;
  return record;
}

XrResult violation(const char* what, XrResult result) {
  TestRuntime::instance().violations.emplace_back(what);
  return result;
}

TestRuntime& TestRuntime::instance() {
  static TestRuntime runtime;
  return runtime;
}

TestRuntime::TestRuntime() : head_at([](XrTime) { return XrPosef{{0, 0, 0, 1}, {0, 1.6F, 0}}; }) {}

void TestRuntime::reset() {
  *this = TestRuntime();
  session_record() = {};
}

void TestRuntime::change_state(XrSessionState state) {
  SessionRecord& session = session_record();
  session.state = state;
  session.events.push_back(packed(XrEventDataSessionStateChanged{
      XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED, nullptr, kTheSession, state, session.display}));
}

void TestRuntime::take_off() {
  change_state(XR_SESSION_STATE_VISIBLE);
  change_state(XR_SESSION_STATE_SYNCHRONIZED);
  change_state(XR_SESSION_STATE_STOPPING);
}

void TestRuntime::put_on() {
  change_state(XR_SESSION_STATE_IDLE);
  change_state(XR_SESSION_STATE_READY);
}

void TestRuntime::ask_for_end() {
  take_off();
  change_state(XR_SESSION_STATE_IDLE);
  change_state(XR_SESSION_STATE_EXITING);
}

void TestRuntime::move_space(XrReferenceSpaceType type, XrTime when,
                             std::optional<XrPosef> new_in_old) {
  session_record().events.push_back(packed(XrEventDataReferenceSpaceChangePending{
      XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING, nullptr, kTheSession, type, when,
      static_cast<XrBool32>(new_in_old.has_value()), new_in_old.value_or(XrPosef{})}));
}

void TestRuntime::lose_session() {
  session_record().lost = true;
  change_state(XR_SESSION_STATE_LOSS_PENDING);
}

}  // namespace roomcast::viewer::xr
