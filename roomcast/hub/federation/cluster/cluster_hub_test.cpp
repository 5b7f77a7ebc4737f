// SPDX-License-Identifier: Apache-2.0
// Two real hubs and a real NATS server on loopback.
#include "roomcast/hub/federation/cluster/cluster_hub.h"

#include <algorithm>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/hub/federation/mirror/clients_of_hubs_fixture.h"
#include "roomcast/hub/federation/nats/nats_server_fixture.h"

namespace roomcast::hub::federation {
namespace {

using namespace std::chrono_literals;
namespace wpb = wire::pb;
using hub::RunningHub;

hub::HubOptions sharing_over(const NatsServer& server, const std::string& public_url = "") {
  ClusterOptions cluster;
  cluster.public_url = public_url;
  cluster.nats.servers = {server.url()};
  cluster.kept_unwatched = 50ms;
  hub::HubOptions options;
  options.open_backplane =
      [cluster](hub::BackplaneContext context) -> Result<std::unique_ptr<hub::Backplane>> {
    auto opened = ClusterHub::open(cluster, std::move(context));
    if (!opened) return opened.error();
    return std::unique_ptr<hub::Backplane>(*std::move(opened));
  };
  return options;
}

class ClusterHubTest : public hub::federation::ClientsOfHubs {
 protected:
  void SetUp() override {
    if (!NatsServer::is_installed()) GTEST_SKIP() << "nats-server is not installed";
  }
  static bool shows_online(const hub::RawClient& viewer) {
    const auto& last = viewer.received.back();
    return last.has_roster() && last.roster().sensors_size() == 1 &&
           last.roster().sensors(0).online();
  }
};

TEST_F(ClusterHubTest, a_viewer_at_any_hub_sees_a_sensor_at_any_other) {
  const NatsServer server;
  const RunningHub first(sharing_over(server)), second(sharing_over(server));
  const auto sensor = join(first, hub::join_as_sensor("left"));
  const auto viewer = join(second, hub::join_as_viewer());
  send_until_seen(sensor, viewer);
  const auto age =
      RoomTime(SteadyClock().now().time_since_epoch()) - viewer->frames.front().capture_time;
  EXPECT_GT(age, -1s);
  EXPECT_LT(age, 5s) << "captured in this hub's time";
  disconnect_all();
}

TEST_F(ClusterHubTest, a_viewer_at_one_hub_makes_the_sensors_of_another_send) {
  const NatsServer server;
  const RunningHub first(sharing_over(server)), second(sharing_over(server));
  const auto sensor = join(first, hub::join_as_sensor("left"));
  const auto last_demand = [](const hub::RawClient& client) {
    std::optional<bool> wanted;
    for (const wpb::Control& message : client.received) {
      if (message.has_frame_demand()) wanted = message.frame_demand().wanted();
    }
    return wanted;
  };
  run_until([&] { return last_demand(*sensor) == false; });
  const auto viewer = join(second, hub::join_as_viewer());
  run_until([&] { return last_demand(*sensor) == true; });
  disconnect_all();
}

TEST_F(ClusterHubTest, counts_the_traffic_over_nats) {
  const NatsServer server;
  const RunningHub first(sharing_over(server)), second(sharing_over(server));
  const auto sensor = join(first, hub::join_as_sensor("left"));
  const auto viewer = join(second, hub::join_as_viewer());
  send_until_seen(sensor, viewer);
  const std::string metrics = metrics_of(second);
  EXPECT_THAT(metrics, testing::HasSubstr("\nroomcast_backplane_links_up 1\n"));
  EXPECT_THAT(metrics, testing::HasSubstr("\nroomcast_backplane_other_hubs 1\n"));
  EXPECT_THAT(metrics, testing::Not(testing::HasSubstr("_sent_messages_total 0\n")));
  EXPECT_THAT(metrics, testing::Not(testing::HasSubstr("_received_bytes_total 0\n")));
  disconnect_all();
}

TEST_F(ClusterHubTest, a_remote_sensor_that_leaves_is_offline_and_can_return) {
  const NatsServer server;
  const RunningHub first(sharing_over(server)), second(sharing_over(server));
  const auto viewer = join(second, hub::join_as_viewer());
  const auto sensor = join(first, hub::join_as_sensor("left"));
  run_until([&] { return shows_online(*viewer); });
  sockets.back()->close(net::close_code::kNormal, "left");
  run_until([&] { return !shows_online(*viewer); });
  const auto again = join(second, hub::join_as_sensor("left"));
  run_until([&] { return shows_online(*viewer); });
  disconnect_all();
}

TEST_F(ClusterHubTest, viewers_and_sensors_get_the_urls_of_other_hubs) {
  const NatsServer server;
  const RunningHub first(sharing_over(server, "wss://first")), second(sharing_over(server));
  const auto names_first = [](const hub::RawClient& client) {
    return std::ranges::any_of(client.received, [](const wpb::Control& message) {
      return message.has_other_hubs() && message.other_hubs().urls_size() == 1 &&
             message.other_hubs().urls(0) == "wss://first";
    });
  };
  const auto viewer = join(second, hub::join_as_viewer());
  run_until([&] { return names_first(*viewer); });
  const auto sensor = join(second, hub::join_as_sensor("left"));
  run_until([&] { return names_first(*sensor); });
  disconnect_all();
}

TEST_F(ClusterHubTest, a_hub_that_nats_refuses_does_not_start) {
  const NatsServer server("authorization { user: hub, password: right }\n");
  auto options = sharing_over(server);
  options.port = 0;
  const auto opened = hub::HubServer::open(std::move(options));
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().message.find("refuses this hub"), std::string::npos);
}

}  // namespace
}  // namespace roomcast::hub::federation
