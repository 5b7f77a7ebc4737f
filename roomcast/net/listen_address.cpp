// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/listen_address.h"

#include <charconv>

#include <boost/asio/ip/address.hpp>

namespace roomcast::net {

Result<ListenAddress> parse_listen_address(const std::string& text) {
  const auto wrong = [&](const std::string& why) {
    return Error{ErrorCode::kInvalidArgument, "cannot listen on \"" + text + "\": " + why};
  };
  const auto colon = text.rfind(':');
  if (colon == std::string::npos) return wrong("write ADDRESS:PORT, for example 127.0.0.1:7600");
  const std::string port_text = text.substr(colon + 1);
  unsigned port = 0;
  const auto [end, fault] =
      std::from_chars(port_text.data(), port_text.data() + port_text.size(), port);
  if (fault != std::errc() || end != port_text.data() + port_text.size() || port > 65'535) {
    return wrong("the port must be a number from 0 to 65535");
  }
  std::string host = text.substr(0, colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']')
    host = host.substr(1, host.size() - 2);
  boost::system::error_code error;
  const auto address = boost::asio::ip::make_address(host, error);
  if (error) return wrong("\"" + host + "\" is not an IP address");
  return ListenAddress{host, static_cast<std::uint16_t>(port), address.is_loopback()};
}

}  // namespace roomcast::net
