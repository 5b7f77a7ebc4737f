// SPDX-License-Identifier: Apache-2.0
#include "bench/abuse/attack.h"

#include <array>
#include <cerrno>
#include <chrono>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include "bench/fanout/protocol.h"

namespace roomcast::bench {

namespace {

using namespace std::chrono_literals;

constexpr int kFromEach = 8;  // connections per address, below the hub's limits
constexpr auto kDripEvery = 100ms;
constexpr std::string_view kGarbage = "\x16\x03\x01\xff\xff not a word of HTTP \r\n\r\n";
constexpr timeval kPatience{.tv_sec = 1, .tv_usec = 0};

/// 127.1.0.1, 127.1.0.2, ...
in_addr source_of(std::uint64_t connection) {
  const auto n = static_cast<std::uint32_t>(connection / kFromEach);
  const std::uint32_t address = (127U << 24) | (1U << 16) | ((n / 250 % 250) << 8) | (n % 250 + 1);
  return {.s_addr = htonl(address)};
}

bool say(int fd, std::string_view text) {
  return ::send(fd, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT) ==
         static_cast<ssize_t>(text.size());
}

/// True while the hub has not closed the connection.
bool is_there(int fd) {
  std::array<char, 4096> ignored{};
  const ssize_t got = ::recv(fd, ignored.data(), ignored.size(), MSG_DONTWAIT);
  return got > 0 || (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK));
}

void read_to_the_end(int fd) {
  std::array<char, 512> buffer{};
  while (::recv(fd, buffer.data(), buffer.size(), 0) > 0) {
    ::shutdown(fd, SHUT_WR);  // nothing more to send
  }
}

}  // namespace

std::string_view name_of(AttackKind kind) {
  switch (kind) {
    case AttackKind::kHalfOpen:
      return "half-open";
    case AttackKind::kGarbage:
      return "garbage";
    case AttackKind::kSlowloris:
      return "slowloris";
    case AttackKind::kBadTokens:
      break;
  }
  return "bad tokens";
}

Attack::Attack(AttackKind kind, std::uint16_t port, int connections)
    : kind_(kind),
      port_(port),
      connections_(connections),
      thread_([this](const std::stop_token& stop) {
        (void)::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), 19);
        switch (kind_) {
          case AttackKind::kHalfOpen:
            return hold(stop, "", "");
          case AttackKind::kGarbage:
            return hold(stop, kGarbage, "");
          case AttackKind::kSlowloris:
            return hold(stop, "GET / HTTP/1.1\r\nHost: localhost\r\nX-A: ", "a");
          case AttackKind::kBadTokens:
            return show_tokens(stop);
        }
      }) {}

/// Returns -1 if the connection was refused.
int Attack::connect() {
  const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in from{};
  from.sin_family = AF_INET;
  from.sin_addr = source_of(tried_++);
  sockaddr_in to = from;
  to.sin_addr = {.s_addr = htonl(INADDR_LOOPBACK)};
  to.sin_port = htons(port_);
  ::setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &kPatience, sizeof(kPatience));
  ::setsockopt(fd, SOL_SOCKET, SO_SNDTIMEO, &kPatience, sizeof(kPatience));
  const bool connected = ::bind(fd, reinterpret_cast<sockaddr*>(&from), sizeof(from)) == 0 &&
                         ::connect(fd, reinterpret_cast<sockaddr*>(&to), sizeof(to)) == 0;
  if (connected) return fd;
  ::close(fd);
  return -1;
}

/// Keeps `connections_` connections open and reopens those that the hub closes.
void Attack::hold(const std::stop_token& stop, std::string_view first, std::string_view drip) {
  std::vector<int> held(static_cast<std::size_t>(connections_), -1);
  while (!stop.stop_requested()) {
    for (int& fd : held) {
      if (stop.stop_requested()) break;
      if (fd >= 0 && is_there(fd) && (drip.empty() || say(fd, drip))) {
        ++served_;
        continue;
      }
      if (fd >= 0) ::close(fd);
      fd = connect();
      if (fd >= 0 && !first.empty()) say(fd, first);
    }
    std::this_thread::sleep_for(kDripEvery);
  }
  for (const int fd : held) {
    if (fd >= 0) ::close(fd);
  }
}

void Attack::show_tokens(const std::stop_token& stop) {
  for (int i = 0; i < connections_ && !stop.stop_requested(); ++i) {
    const int fd = connect();
    if (fd < 0) continue;
    if (say(fd, roomcast_greeting("eyJhbGciOiJIUzI1NiJ9.e30." + std::to_string(i)))) {
      read_to_the_end(fd);
      ++served_;
    }
    ::close(fd);
  }
  over_ = true;
}

}  // namespace roomcast::bench
