// SPDX-License-Identifier: Apache-2.0
// For tests of mirrored sensors and people: a room that records the events it receives.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/hub/federation/mirror/backplane_connection.h"
#include "roomcast/hub/runtime/backplane.h"
#include "roomcast/hub/server/hub_server_fixture.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::hub::federation {

using namespace std::chrono_literals;

/// A room here that records the events it receives.
struct RoomHere final : hub::BackplaneEvents {
  void on_join(const hub::ConnectionInfo& arrival, const wire::pb::Join& join) override {
    joins.emplace_back(arrival.id(), join);
    arrivals.push_back(arrival);
  }
  void on_control(ConnectionId from, const wire::pb::Control& message) override {
    controls.emplace_back(from, message);
  }
  void on_frame(ConnectionId from, const wire::FrameHeader& header,
                net::MessageBuffer message) override {
    EXPECT_EQ(*wire::parse_frame(message.payload()), header) << "the bytes have the same header";
    frames.emplace_back(from, header);
  }
  void on_frames(std::span<hub::IncomingFrame> together) override {
    batches.push_back(together.size());
    for (auto& frame : together) on_frame(frame.from, frame.header, std::move(frame.message));
  }
  void on_key_needs(ConnectionId, const std::vector<SensorId>& sensors) override {
    key_needs.insert(key_needs.end(), sensors.begin(), sensors.end());
  }
  void on_watched_elsewhere(const std::string& room, bool is_watched) override {
    watched_elsewhere.emplace_back(room, is_watched);
  }
  void on_left(ConnectionId from, const net::CloseReason&) override { left.push_back(from); }

  std::vector<std::pair<ConnectionId, wire::pb::Join>> joins;
  std::vector<hub::ConnectionInfo> arrivals;
  std::vector<std::pair<ConnectionId, wire::pb::Control>> controls;
  std::vector<std::pair<ConnectionId, wire::FrameHeader>> frames;
  std::vector<std::size_t> batches;  // number of frames of each on_frames()
  std::vector<SensorId> key_needs;
  std::vector<std::pair<std::string, bool>> watched_elsewhere;
  std::vector<ConnectionId> left;
};

/// Makes connections that lose what the room sends to them.
inline NewConnection unread_connections() {
  return [ids = std::make_shared<hub::ConnectionIds>()] {
    return std::make_shared<BackplaneConnection>(ids->next(), [] { return nullptr; });
  };
}

inline wire::pb::SensorEntry sensor_there(
    std::uint32_t id, const std::string& name,
    wire::pb::Placement placement = wire::pb::PLACEMENT_GIVEN) {
  wire::pb::SensorEntry entry;
  entry.set_id(id);
  entry.set_name(name);
  entry.set_online(true);
  entry.set_fps(30);
  entry.set_placement(placement);
  hub::set_camera(*entry.mutable_calibration()->mutable_depth());
  hub::set_camera(*entry.mutable_calibration()->mutable_color());
  for (int i = 0; i < 16; ++i) {
    entry.mutable_calibration()->add_color_from_depth(i % 5 == 0 ? 1 : 0);
  }
  for (int i = 0; i < 16; ++i) entry.add_world_from_depth(i % 5 == 0 ? 1 : 0);
  return entry;
}

inline wire::pb::ViewerEntry person(std::uint32_t id, const std::string& name,
                                    std::uint32_t hubs_away = 0, std::uint32_t through = 0) {
  wire::pb::ViewerEntry entry;
  entry.set_id(id);
  entry.set_name(name);
  entry.set_hubs_away(hubs_away);
  entry.set_through(through);
  return entry;
}

inline wire::pb::Control pose_of(std::uint32_t person) {
  wire::pb::Control control;
  wire::pb::ViewerPose& pose = *control.mutable_viewer_poses()->add_poses();
  pose.set_viewer_id(person);
  pose.mutable_head()->set_qw(1);
  return control;
}

/// A frame of sensor 7 there, captured at 10 s of that hub's clock.
inline net::MessageBuffer frame_there() {
  const wire::FrameHeader header{
      .key = true, .sensor = SensorId{7}, .capture_time = RoomTime(10s), .clock_error_us = 100};
  std::vector<std::uint8_t> bytes(wire::kFrameHeaderBytes);
  wire::write_frame_header(header, std::span(bytes).first<wire::kFrameHeaderBytes>());
  return net::MessageBuffer(bytes);
}

}  // namespace roomcast::hub::federation
