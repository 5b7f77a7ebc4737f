// SPDX-License-Identifier: Apache-2.0
// Two real hubs and a real NATS server on loopback.
#include "roomcast/cluster/cluster_hub.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "roomcast/cluster/nats_server_fixture.h"
#include "roomcast/hub/hub_server_fixture.h"
#include "roomcast/hub/running_hub.h"

namespace roomcast::cluster {
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
      [cluster](hub::BackplaneSeat seat) -> Result<std::unique_ptr<hub::Backplane>> {
    auto opened = ClusterHub::open(cluster, std::move(seat));
    if (!opened) return opened.error();
    return std::unique_ptr<hub::Backplane>(*std::move(opened));
  };
  return options;
}

class ClusterHubTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!NatsServer::is_installed()) GTEST_SKIP() << "nats-server is not installed";
  }
  std::shared_ptr<hub::RawClient> join(const RunningHub& hub, const wpb::Control& message) {
    auto client = std::make_shared<hub::RawClient>(std::deque{hub::sealed_control(message)});
    net::connect(io, {.host = "127.0.0.1", .port = hub.port()}, {}, [=, this](auto socket) {
      ASSERT_TRUE(socket.ok());
      (*socket)->start(client);
      sockets.push_back(*socket);
    });
    run_until([&] { return !client->heard.empty(); });
    return client;
  }
  void run_until(const std::function<bool()>& done) {
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    while (!done() && io.run_one_until(give_up) > 0) {
    }
    ASSERT_TRUE(done()) << "nothing happened in 5 s";
  }
  void send_until_seen(const std::shared_ptr<hub::RawClient>& sensor,
                       const std::shared_ptr<hub::RawClient>& viewer) {
    const auto seen = viewer->frames.size();
    boost::asio::steady_timer pace(io);
    std::function<void()> send = [&] {
      sensor->say(hub::key_frame(seq++));
      sockets.front()->wake();
      pace.expires_after(10ms);
      pace.async_wait([&](boost::system::error_code error) {
        if (!error) send();
      });
    };
    send();
    run_until([&] { return viewer->frames.size() > seen; });
    pace.cancel();
    io.poll();
  }
  static bool shows_online(const hub::RawClient& viewer) {
    const auto& last = viewer.heard.back();
    return last.has_roster() && last.roster().sensors_size() == 1 &&
           last.roster().sensors(0).online();
  }
  /// Else the hubs would wait for an answer to their goodbyes.
  void part() {
    for (const auto& socket : sockets) socket->close(net::close_code::kNormal, "left");
    io.run_for(100ms);
  }

  boost::asio::io_context io;
  std::vector<std::shared_ptr<net::WebSocketConnection>> sockets;
  std::uint32_t seq = 0;
};

TEST_F(ClusterHubTest, a_viewer_at_any_hub_sees_a_sensor_at_any_other) {
  const NatsServer server;
  const RunningHub first(sharing_over(server)), second(sharing_over(server));
  const auto sensor = join(first, hub::sensor_join("left"));
  const auto viewer = join(second, hub::viewer_join());
  send_until_seen(sensor, viewer);
  const auto age =
      RoomTime(SteadyClock().now().time_since_epoch()) - viewer->frames.front().capture_time;
  EXPECT_GT(age, -1s);
  EXPECT_LT(age, 5s) << "captured in this hub's time";
  part();
}

TEST_F(ClusterHubTest, a_sensor_that_leaves_there_is_offline_here_and_comes_back) {
  const NatsServer server;
  const RunningHub first(sharing_over(server)), second(sharing_over(server));
  const auto viewer = join(second, hub::viewer_join());
  const auto sensor = join(first, hub::sensor_join("left"));
  run_until([&] { return shows_online(*viewer); });
  sockets.back()->close(net::close_code::kNormal, "left");
  run_until([&] { return !shows_online(*viewer); });
  const auto again = join(second, hub::sensor_join("left"));
  run_until([&] { return shows_online(*viewer); });
  part();
}

TEST_F(ClusterHubTest, viewers_and_sensors_are_told_where_else_their_room_is) {
  const NatsServer server;
  const RunningHub first(sharing_over(server, "wss://first")), second(sharing_over(server));
  const auto names_first = [](const hub::RawClient& client) {
    return std::ranges::any_of(client.heard, [](const wpb::Control& message) {
      return message.has_other_hubs() && message.other_hubs().urls_size() == 1 &&
             message.other_hubs().urls(0) == "wss://first";
    });
  };
  const auto viewer = join(second, hub::viewer_join());
  run_until([&] { return names_first(*viewer); });
  const auto sensor = join(second, hub::sensor_join("left"));
  run_until([&] { return names_first(*sensor); });
  part();
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
}  // namespace roomcast::cluster
