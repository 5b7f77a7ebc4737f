// SPDX-License-Identifier: Apache-2.0
// Two real hubs on loopback: a sensor at one, a viewer at the other.
#include "roomcast/hub/federation/upstream/upstream_hub.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/hub/federation/mirror/clients_of_hubs_fixture.h"

namespace roomcast::hub::federation {
namespace {

using namespace std::chrono_literals;
namespace wpb = wire::pb;
using hub::RunningHub;

hub::HubOptions serving_on(const std::vector<std::uint16_t>& ports, const std::string& token = {}) {
  UpstreamOptions upstream;
  upstream.credential.token = token;
  upstream.kept_unwatched = 50ms;
  for (const auto port : ports) upstream.hubs.push_back({.host = "127.0.0.1", .port = port});
  hub::HubOptions options;
  options.open_backplane =
      [upstream](hub::BackplaneContext context) -> Result<std::unique_ptr<hub::Backplane>> {
    return std::unique_ptr<hub::Backplane>(
        std::make_unique<UpstreamHub>(upstream, std::move(context)));
  };
  return options;
}

class UpstreamHubTest : public hub::federation::ClientsOfHubs {
 protected:
  /// The names of the viewers at the same hub.
  static std::vector<std::string> viewers_in(const hub::RawClient& client) {
    std::vector<std::string> names;
    for (const auto& message : client.received) {
      if (!message.has_roster()) continue;
      names.clear();
      for (const auto& viewer : message.roster().viewers()) {
        if (viewer.hubs_away() == 0) names.push_back(viewer.name());
      }
    }
    return names;
  }
};

TEST_F(UpstreamHubTest, a_viewer_sees_the_sensors_of_the_other_hub) {
  const RunningHub origin, edge(serving_on({origin.port()}));
  const auto sensor = join(origin, hub::join_as_sensor("left"));
  const auto viewer = join(edge, hub::join_as_viewer());
  send_until_seen(sensor, viewer);
  EXPECT_TRUE(viewer->frames.front().key);
  const auto late =
      RoomTime(SteadyClock().now().time_since_epoch()) - viewer->frames.front().capture_time;
  EXPECT_GT(late, -1s);
  EXPECT_LT(late, 5s) << "captured in this hub's time";
  disconnect_all();
}

TEST_F(UpstreamHubTest, counts_the_traffic_from_the_other_hub) {
  const RunningHub origin, edge(serving_on({origin.port()}));
  const auto sensor = join(origin, hub::join_as_sensor("left"));
  EXPECT_THAT(metrics_of(edge), testing::HasSubstr("\nroomcast_backplane_links 0\n"));
  const auto viewer = join(edge, hub::join_as_viewer());
  send_until_seen(sensor, viewer);
  const std::string metrics = metrics_of(edge);
  EXPECT_THAT(metrics, testing::HasSubstr("\nroomcast_backplane_links_up 1\n"));
  EXPECT_THAT(metrics, testing::Not(testing::HasSubstr("_received_messages_total 0\n")));
  disconnect_all();
}

TEST_F(UpstreamHubTest, a_room_that_needs_a_token_is_relayed_with_a_token_only) {
  const RunningHub origin({.rooms = {{.name = "room", .view = hub::AccessRule::kToken}}});
  const RunningHub without(serving_on({origin.port()}));
  const RunningHub with(serving_on({origin.port()}, origin.server().own_token()));
  const auto sensor = join(origin, hub::join_as_sensor("left"));
  const auto stranger = join(without, hub::join_as_viewer());
  const auto viewer = join(with, hub::join_as_viewer());
  send_until_seen(sensor, viewer);
  EXPECT_TRUE(stranger->frames.empty());
  disconnect_all();
}

TEST_F(UpstreamHubTest, a_room_is_pulled_only_while_it_has_viewers) {
  const RunningHub origin, edge(serving_on({origin.port()}));
  const auto sensor = join(origin, hub::join_as_sensor("left"));
  const auto witness = join(origin, hub::join_as_viewer());
  run_until([&] { return viewers_in(*witness).size() == 1; });
  const auto viewer = join(edge, hub::join_as_viewer());
  run_until([&] { return viewers_in(*witness).size() == 2; });
  sockets.back()->close(net::close_code::kNormal, "left");
  run_until([&] { return viewers_in(*witness).size() == 1; });
  disconnect_all();
}

TEST_F(UpstreamHubTest, pulls_from_the_next_hub_when_one_is_gone) {
  auto first = std::make_unique<RunningHub>();
  const RunningHub second;
  const RunningHub edge(serving_on({first->port(), second.port()}));
  const auto sensor = join(second, hub::join_as_sensor("left"));
  const auto viewer = join(edge, hub::join_as_viewer());
  first.reset();
  send_until_seen(sensor, viewer);
  disconnect_all();
}

TEST_F(UpstreamHubTest, a_sensor_that_leaves_there_is_offline_here) {
  const RunningHub origin, edge(serving_on({origin.port()}));
  const auto sensor = join(origin, hub::join_as_sensor("left"));
  const auto viewer = join(edge, hub::join_as_viewer());
  send_until_seen(sensor, viewer);
  sockets.front()->close(net::close_code::kNormal, "left");
  run_until([&] {
    const auto& last = viewer->received.back();
    return last.has_roster() && last.roster().sensors_size() == 1 &&
           !last.roster().sensors(0).online();
  });
  disconnect_all();
}

}  // namespace
}  // namespace roomcast::hub::federation
