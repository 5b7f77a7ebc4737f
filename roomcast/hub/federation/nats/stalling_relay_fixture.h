// SPDX-License-Identifier: Apache-2.0
// For tests: a relay between a client and a server on loopback. It forwards both directions until
// it stalls in the middle of the server's data, or stops reading from the client.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <climits>
#include <string>
#include <thread>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace roomcast::hub::federation {

class StallingRelay {
 public:
  explicit StallingRelay(const std::string& server_port)
      : listener_(::socket(AF_INET, SOCK_STREAM, 0)),
        server_address_(loopback(static_cast<std::uint16_t>(std::stoi(server_port)))) {
    sockaddr_in any = loopback(0);
    ::bind(listener_, reinterpret_cast<sockaddr*>(&any), sizeof any);
    ::listen(listener_, 4);
    socklen_t size = sizeof any;
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&any), &size);
    port_ = ntohs(any.sin_port);
    thread_ = std::jthread([this](const std::stop_token& stop) { relay_first(stop); });
  }
  ~StallingRelay() {
    thread_.request_stop();
    thread_.join();
    ::close(listener_);
  }
  StallingRelay(const StallingRelay&) = delete;
  StallingRelay& operator=(const StallingRelay&) = delete;

  [[nodiscard]] std::string port() const { return std::to_string(port_); }
  /// Forwards this many more bytes from the server.
  void stall_after(int bytes) { from_server_ = bytes; }
  /// Forwards nothing more from the client.
  void stall_client() { from_client_ = 0; }

 private:
  static sockaddr_in loopback(std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
  }

  void relay_first(const std::stop_token& stop) {
    while (!stop.stop_requested() && !is_readable(listener_)) {
    }
    const int client = ::accept(listener_, nullptr, nullptr);
    const int server = ::socket(AF_INET, SOCK_STREAM, 0);
    ::connect(server, reinterpret_cast<const sockaddr*>(&server_address_), sizeof server_address_);
    while (!stop.stop_requested() && pass(client, server, from_client_) &&
           pass(server, client, from_server_)) {
    }
    ::close(client);
    ::close(server);
  }

  static bool is_readable(int socket) {
    pollfd question{.fd = socket, .events = POLLIN, .revents = 0};
    return ::poll(&question, 1, 1) > 0;
  }

  /// False: one end has disconnected.
  static bool pass(int from, int to, std::atomic<int>& allowed) {
    if (allowed == 0 || !is_readable(from)) return true;
    std::array<char, 16 << 10> buffer{};
    const auto wanted = std::min<std::size_t>(static_cast<std::size_t>(allowed), buffer.size());
    const auto count = ::recv(from, buffer.data(), wanted, 0);
    if (count <= 0) return false;
    if (allowed != INT_MAX) allowed -= static_cast<int>(count);
    return ::send(to, buffer.data(), static_cast<std::size_t>(count), MSG_NOSIGNAL) == count;
  }

  const int listener_;
  const sockaddr_in server_address_;
  std::uint16_t port_ = 0;
  std::atomic<int> from_server_ = INT_MAX, from_client_ = INT_MAX;
  std::jthread thread_;
};

}  // namespace roomcast::hub::federation
