// SPDX-License-Identifier: Apache-2.0
// What libroomcast makes of a room when its hub says anything: sensors with frames, rays and poses
// of the same size, and points within the memory that its caller gave.
#include <array>
#include <cstdint>

#include "fuzz/hub_messages.h"
#include "roomcast/capi/received_sensor.h"
#include "roomcast/capi/room_points.h"
#include "roomcast/client/room/room_state.h"
#include "roomcast/core/image.h"
#include "roomcast/wire/control.h"
#include "roomcast/wire/frame_header.h"

namespace {

using namespace roomcast;

constexpr float kUntouched = -12345.5F;

/// Whether there is something new to look at.
bool take(client::RoomState& state, fuzz::Bytes message) {
  const auto type = wire::message_type(message);
  if (type && *type == wire::MessageType::kFrame) return state.frame(message).ok();
  const auto control = wire::decode_control(message, wire::Sender::kHub);
  if (!control) return false;
  if (control->has_welcome()) state.welcome(control->welcome());
  if (control->has_roster()) (void)state.roster(control->roster());
  if (control->has_viewer_poses()) state.poses(control->viewer_poses());
  return control->has_roster();
}

void look(const client::RoomSnapshot& room, capi::SensorRays& rays) {
  const auto sensors = capi::received_sensors(room, rays);
  for (const capi::ReceivedSensor& received : sensors) {
    if (received.sensor == nullptr || !received.frame || !received.rays) __builtin_trap();
    if (!same_size(received.frame->depth_mm.view(), received.rays->view())) __builtin_trap();
    const auto& color = received.frame->color;
    if (!color.empty() && !same_size(color.view(), received.frame->depth_mm.view()))
      __builtin_trap();
  }
  std::array<roomcast_point, 300> points;
  points.back().x = kUntouched;
  const std::size_t there_are = capi::write_points(sensors, std::span(points).first(299));
  if (there_are != capi::write_points(sensors, {})) __builtin_trap();
  if (points.back().x != kUntouched) __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const SteadyClock clock;
  client::RoomState state(clock);
  capi::SensorRays rays;
  for (const fuzz::Bytes message : fuzz::hub_messages({data, size})) {
    if (take(state, message)) look(*state.snapshot(), rays);
  }
  return 0;
}
