// SPDX-License-Identifier: Apache-2.0
// Sending limits of each role: a client that exceeds them is disconnected, and normal use stays
// below.
#include <algorithm>

#include "roomcast/hub/access/rate_limit.h"
#include "roomcast/hub/server/hub_server.h"
#include "roomcast/hub/server/hub_server_fixture.h"

namespace roomcast::hub {
namespace {

/// The rate is so low that the result does not depend on the machine's speed.
constexpr wire::SendingLimits at_once(double messages, double bytes = 1e6) {
  return {1e-6, messages, 1e-6, bytes};
}

struct Case {
  const char* name;
  pb::Control join;
  int messages;  // number that it may send at once
};

pb::Control aligner_join() {
  pb::Control control;
  control.mutable_join()->mutable_aligner();
  return control;
}

pb::Control join_as_hub() {
  pb::Control control = join_as_viewer();
  control.mutable_join()->mutable_viewer()->set_relays(true);
  return control;
}

std::vector<Case> cases() {
  return {{"sensor", join_as_sensor("left"), 40},
          {"viewer", join_as_viewer(), 10},
          {"hub", join_as_hub(), 20},
          {"aligner", aligner_join(), 15}};
}

class SessionLimitsTest : public HubServerTest {
 protected:
  explicit SessionLimitsTest(SessionLimits limits = {.sensor = at_once(40),
                                                     .viewer = at_once(10),
                                                     .hub = at_once(20),
                                                     .aligner = at_once(15)})
      : HubServerTest({.limits = {.session = limits}}) {}

  std::shared_ptr<RawClient> welcomed(pb::Control join) {
    join.mutable_join()->set_token(hub->own_token());
    auto client = connect(join);
    run_until([&] { return !client->received.empty(); });
    EXPECT_TRUE(client->received.at(0).has_welcome()) << client->received.at(0).error().sentence();
    return client;
  }

  /// `client` must be the newest one.
  void send(RawClient& client, int times, const net::FramedMessagePtr& message = clock_ping(1)) {
    for (int i = 0; i < times; ++i) client.send(message);
    sockets.back()->wake();
  }

  static std::ptrdiff_t pongs(const RawClient& client) {
    return std::ranges::count_if(client.received, [](const auto& m) { return m.has_clock_pong(); });
  }
};

TEST_F(SessionLimitsTest, disconnects_a_client_beyond_the_limits_of_its_role) {
  for (const Case& role : cases()) {
    SCOPED_TRACE(role.name);
    const auto client = welcomed(role.join);
    send(*client, role.messages);
    run_until([&] { return pongs(*client) == role.messages; });
    EXPECT_FALSE(client->closed);
    send(*client, 1);
    run_until([&] { return client->closed.has_value(); });
    EXPECT_EQ(pongs(*client), role.messages);
    EXPECT_EQ(client->received.back().error().code(), pb::ERROR_TOO_FAST);
  }
}

TEST_F(SessionLimitsTest, an_unjoined_connection_has_the_limits_of_a_viewer) {
  std::deque<net::FramedMessagePtr> to_send(30, clock_ping(1));
  pb::Control join = join_as_sensor("left");
  join.mutable_join()->set_room("nowhere");
  to_send.front() = framed_control(join);
  const auto stranger = connect(std::move(to_send));
  run_until([&] { return stranger->closed.has_value(); });
  EXPECT_LE(pongs(*stranger), 9);
}

class SmallMessagesTest : public SessionLimitsTest {
 protected:
  SmallMessagesTest()
      : SessionLimitsTest({.sensor = at_once(1000, 1e6),
                           .viewer = at_once(1000, 4000),
                           .hub = at_once(1000, 20'000),
                           .aligner = at_once(1000, 20'000)}) {}
};

TEST_F(SmallMessagesTest, disconnects_a_client_that_sends_too_large_messages) {
  pb::Control pose;
  pose.mutable_clock_ping()->set_client_ns(1);
  pose.GetReflection()->MutableUnknownFields(&pose)->AddLengthDelimited(1000,
                                                                        std::string(3000, 'x'));
  const auto large = framed_control(pose);
  const auto viewer = welcomed(join_as_viewer());
  send(*viewer, 2, large);
  run_until([&] { return viewer->closed.has_value(); });
  EXPECT_EQ(viewer->received.back().error().code(), pb::ERROR_TOO_FAST);
  const auto sensor = welcomed(join_as_sensor("left"));
  send(*sensor, 2, large);
  run_until([&] { return pongs(*sensor) == 2; });
  EXPECT_FALSE(sensor->closed);
}

/// One kind of message, sent at a fixed rate.
struct Use {
  double per_s;
  std::size_t bytes;
};

/// Whether a minute of these messages keeps within `limits` if those of the first 4 s are delayed
/// and sent at once.
bool passes(const wire::SendingLimits& limits, const std::vector<Use>& uses) {
  RateLimit messages(limits.messages_per_s, limits.messages_at_once);
  RateLimit bytes(limits.bytes_per_s, limits.bytes_at_once);
  std::vector<std::pair<HostTime, std::size_t>> sent;
  for (const auto& [per_s, size] : uses) {
    for (int i = 0; i < 60 * per_s; ++i) {
      const std::chrono::duration<double> at(i / per_s);
      sent.emplace_back(HostTime(1h + std::max<nanoseconds>(4s, duration_cast<nanoseconds>(at))),
                        size);
    }
  }
  std::ranges::sort(sent);
  return std::ranges::all_of(sent, [&](const auto& message) {
    return messages.take(1, message.first) &&
           bytes.take(static_cast<double>(message.second), message.first);
  });
}

std::size_t largest_pose() {
  pb::Control control;
  auto& pose = *control.mutable_viewer_pose();
  for (auto* part : {pose.mutable_head(), pose.mutable_left_hand(), pose.mutable_right_hand()}) {
    for (const auto set : {&pb::Pose::set_x, &pb::Pose::set_y, &pb::Pose::set_z, &pb::Pose::set_qx,
                           &pb::Pose::set_qy, &pb::Pose::set_qz, &pb::Pose::set_qw}) {
      (part->*set)(0.7F);
    }
  }
  for (auto* point :
       {pose.mutable_pointer()->mutable_from(), pose.mutable_pointer()->mutable_to()}) {
    point->set_x(1.5F);
    point->set_y(1.5F);
    point->set_z(1.5F);
  }
  return 4 + control.ByteSizeLong();
}

TEST(HonestUse, stays_below_the_limits_of_each_role) {
  constexpr std::size_t kSmall = 64;
  const double keys_per_s =
      wire::kMaxSensors / std::chrono::duration<double>(wire::kKeyRequestInterval).count();
  const Use pings{10, kSmall}, stats{1, kSmall}, keys{keys_per_s, kSmall};
  for (const double headset_hz : {30, 72, 90}) {
    EXPECT_TRUE(passes(wire::kMaxFromViewer,
                       {{headset_hz, largest_pose()}, {headset_hz, 200}, pings, stats, keys}));
  }
  const Use bundle{0.1, wire::kMaxBundleBytes}, sightings{2, 8000};
  EXPECT_TRUE(passes(wire::kMaxFromSensor, {{60, 400'000}, bundle, sightings, pings}));
  EXPECT_TRUE(passes(wire::kMaxFromSensor, {{wire::kMaxFps, 100'000}, bundle, sightings, pings}));
  const Use people{20, wire::kMaxControlFromClientBytes / 2};
  EXPECT_TRUE(passes(wire::kMaxFromHub, {people, people, keys, stats, pings}));
  EXPECT_TRUE(passes(wire::kMaxFromAligner, {{5, wire::kMaxControlFromClientBytes}, pings}));
  EXPECT_FALSE(passes(wire::kMaxFromViewer, {{600, kSmall}})) << "this test can fail";
}

}  // namespace
}  // namespace roomcast::hub
