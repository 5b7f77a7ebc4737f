// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/socket_tuning.h"

#include <string_view>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

namespace roomcast::net {

void tune_for_live_streams(boost::asio::ip::tcp::socket& socket) {
  boost::system::error_code ignored;
  socket.non_blocking(true, ignored);
  socket.set_option(boost::asio::ip::tcp::no_delay(true), ignored);
  const int fd = socket.native_handle();
  const int unsent = kMaxUnsentBytes;
  (void)::setsockopt(fd, IPPROTO_TCP, TCP_NOTSENT_LOWAT, &unsent, sizeof(unsent));
  constexpr std::string_view kCongestionControl = "bbr";
  (void)::setsockopt(fd, IPPROTO_TCP, TCP_CONGESTION, kCongestionControl.data(),
                     static_cast<socklen_t>(kCongestionControl.size()));
}

bool is_writable_now(boost::asio::ip::tcp::socket& socket) {
  pollfd question{};
  question.fd = socket.native_handle();
  question.events = POLLOUT;
  return ::poll(&question, 1, 0) > 0;
}

}  // namespace roomcast::net
