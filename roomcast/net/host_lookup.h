// SPDX-License-Identifier: Apache-2.0
// Host look-up by name. A numeric address is used directly, because Asio's resolver would start a
// thread for it.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>

namespace roomcast::net {

/// Calls `then(error, endpoints)`: from within this call for a numeric address, else later on the
/// resolver's io_context.
template <class Then>
void look_up(boost::asio::ip::tcp::resolver& resolver, const std::string& host, std::uint16_t port,
             Then then) {
  using Tcp = boost::asio::ip::tcp;
  boost::system::error_code not_numeric;
  const auto address = boost::asio::ip::make_address(host, not_numeric);
  if (not_numeric) return resolver.async_resolve(host, std::to_string(port), std::move(then));
  then(boost::system::error_code(),
       Tcp::resolver::results_type::create(Tcp::endpoint(address, port), host, {}));
}

}  // namespace roomcast::net
