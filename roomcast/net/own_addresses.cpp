// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/own_addresses.h"

#include <cstring>
#include <memory>

#include <boost/asio/ip/address.hpp>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

namespace roomcast::net {
namespace {

namespace ip = boost::asio::ip;

ip::address address_of(const sockaddr& given) {
  if (given.sa_family == AF_INET)
    return ip::address_v4(ntohl(reinterpret_cast<const sockaddr_in&>(given).sin_addr.s_addr));
  ip::address_v6::bytes_type bytes;
  std::memcpy(bytes.data(), &reinterpret_cast<const sockaddr_in6&>(given).sin6_addr, bytes.size());
  return ip::address_v6(bytes);
}

bool is_link_local(const ip::address& address) {
  if (address.is_v6()) return address.to_v6().is_link_local();
  return (address.to_v4().to_uint() >> 16) == 0xA9FE;  // 169.254.0.0/16, RFC 3927
}

}  // namespace

std::vector<std::string> own_addresses(bool with_ipv6) {
  ifaddrs* first = nullptr;
  if (::getifaddrs(&first) != 0) return {};
  const std::unique_ptr<ifaddrs, decltype(&::freeifaddrs)> all(first, &::freeifaddrs);
  std::vector<std::string> addresses;
  for (const ifaddrs* entry = all.get(); entry != nullptr; entry = entry->ifa_next) {
    if (entry->ifa_addr == nullptr || (entry->ifa_flags & IFF_UP) == 0) continue;
    const int family = entry->ifa_addr->sa_family;
    if (family != AF_INET && (family != AF_INET6 || !with_ipv6)) continue;
    const ip::address address = address_of(*entry->ifa_addr);
    if (!address.is_loopback() && !is_link_local(address)) addresses.push_back(address.to_string());
  }
  return addresses;
}

}  // namespace roomcast::net
