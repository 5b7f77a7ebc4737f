// SPDX-License-Identifier: Apache-2.0
#include "roomcast/doctor/hub_contact.h"

#include <chrono>
#include <optional>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <fmt/format.h>

#include "roomcast/core/clock.h"
#include "roomcast/net/websocket_client.h"

namespace roomcast::doctor {
namespace {

using namespace std::chrono_literals;

constexpr auto kPatience = 6s;
constexpr auto kRoundTripPatience = 2s;
constexpr int kRoundTrips = 5;
constexpr double kFar_ms = 150;  // people notice such a delay when they move or point

/// Connects and leaves. Nothing: it worked; else the reason.
std::optional<std::string> failure_to_connect(const net::HubUrl& hub) {
  boost::asio::io_context io;
  std::optional<std::string> failure = net::host_and_port(hub) + " does not answer.";
  const auto attempt = net::connect(io, hub, {}, [&](auto connected) {
    failure.reset();
    if (!connected) failure = connected.error().message;
  });
  io.run_for(kPatience);
  return failure;
}

/// Duration of a TCP connection's handshake, which is one round trip.
std::optional<double> round_trip_ms(const net::HubUrl& hub) {
  using boost::asio::ip::tcp;
  boost::asio::io_context io;
  boost::system::error_code error;
  const auto places = tcp::resolver(io).resolve(hub.host, std::to_string(hub.port), error);
  if (error) return std::nullopt;
  tcp::socket socket(io);
  const HostTime began = SteadyClock().now();
  std::optional<double> took_ms;
  boost::asio::async_connect(socket, places, [&](boost::system::error_code failed, const auto&) {
    if (failed) return;
    took_ms = std::chrono::duration<double, std::milli>(SteadyClock().now() - began).count();
  });
  io.run_for(kRoundTripPatience);
  return took_ms;
}

Finding unreachable(const std::string& sentence) {
  return {"hub", Verdict::kProblem, sentence,
          "Check the address, that the hub runs there, and that no firewall is in between."};
}

Finding judge_round_trip(const std::string& hub, double shortest_ms) {
  Finding finding{"hub", Verdict::kOk,
                  fmt::format("{} answers; the round trip takes {:.1f} ms.", hub, shortest_ms)};
  if (shortest_ms < kFar_ms) return finding;
  finding.verdict = Verdict::kNotice;
  finding.remedy = "Use a hub that is nearer: people will notice the delay.";
  return finding;
}

}  // namespace

Finding check_hub(const std::string& url) {
  const auto hubs = net::parse_hub_urls(url);
  if (!hubs) return {"hub", Verdict::kProblem, hubs.error().message, "Write it as for --hub."};
  const net::HubUrl& hub = hubs->front();
  if (const auto failure = failure_to_connect(hub)) return unreachable(*failure);
  std::optional<double> shortest_ms;
  for (int i = 0; i < kRoundTrips; ++i) {
    const auto took_ms = round_trip_ms(hub);
    if (took_ms && (!shortest_ms || *took_ms < *shortest_ms)) shortest_ms = took_ms;
  }
  if (!shortest_ms) return unreachable(net::host_and_port(hub) + " does not answer any more.");
  return judge_round_trip(net::host_and_port(hub), *shortest_ms);
}

}  // namespace roomcast::doctor
