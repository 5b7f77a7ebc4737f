// SPDX-License-Identifier: Apache-2.0
#include "roomcast/doctor/network.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "roomcast/net/own_addresses.h"

namespace roomcast::doctor {

Finding check_port(std::uint16_t port) {
  using boost::asio::ip::tcp;
  boost::asio::io_context io;
  tcp::acceptor acceptor(io);
  boost::system::error_code error;
  const tcp::endpoint everywhere(tcp::v4(), port);
  acceptor.open(everywhere.protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(everywhere, error);
  if (!error) acceptor.listen(1, error);
  if (!error) return {"port", Verdict::kOk, fmt::format("A hub can listen at port {}.", port)};
  if (error == boost::asio::error::address_in_use) {
    return {"port", Verdict::kNotice,
            fmt::format("Another program, perhaps a hub, listens at port {}.", port),
            "End it, or use another port: roomcast hub --listen 127.0.0.1:7601"};
  }
  return {"port", Verdict::kProblem,
          fmt::format("A hub cannot listen at port {}: {}.", port, error.message()),
          "Use another port: roomcast hub --listen 127.0.0.1:7601"};
}

Finding judge_addresses(const std::vector<std::string>& addresses) {
  if (addresses.empty()) {
    return {"network", Verdict::kNotice,
            "This computer is in no network: nobody else can reach it.",
            "Connect it; programs on this computer work together all the same."};
  }
  return {"network", Verdict::kOk,
          fmt::format("Others reach this computer at {}.", fmt::join(addresses, ", "))};
}

Finding check_addresses() {
  return judge_addresses(net::own_addresses(false));
}

}  // namespace roomcast::doctor
