// SPDX-License-Identifier: Apache-2.0
// A minimal fan-out server: reads a frame and writes it to every socket.
#include <deque>
#include <unordered_map>

#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "bench/fanout/engine.h"
#include "bench/fanout/tls_identity.h"
#include "roomcast/net/tls/tls_context.h"
#include "roomcast/net/tls/tls_session.h"

namespace roomcast::bench {

namespace {

using Frame = std::shared_ptr<const std::vector<std::uint8_t>>;

struct Peer {
  int fd = -1;
  std::optional<net::TlsSession> tls;
  char role = 0;  // 'V' or 'P' after the first byte
  std::vector<std::uint8_t> incoming;
  std::deque<Frame> outgoing;
  std::size_t written = 0;  // of the message at the front
  bool waits_to_write = false;
};

class SocketLoop {
 public:
  SocketLoop(std::size_t frame_bytes, std::shared_ptr<const net::TlsServerContext> tls)
      : frame_bytes_(frame_bytes), tls_(std::move(tls)), buffer_(256 * 1024) {}

  [[noreturn]] void run(const ChildProcess::PortReport& report) {
    report(listen());
    std::vector<epoll_event> events(256);
    for (;;) {
      const int count = ::epoll_wait(epoll_, events.data(), static_cast<int>(events.size()), -1);
      for (int i = 0; i < count; ++i) handle(events[static_cast<std::size_t>(i)]);
    }
  }

 private:
  std::uint16_t listen() {
    listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    ::bind(listener_, reinterpret_cast<const sockaddr*>(&address), size);
    ::listen(listener_, 1024);
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    watch(listener_, EPOLLIN, EPOLL_CTL_ADD);
    return ntohs(address.sin_port);
  }

  void watch(int fd, std::uint32_t events, int operation) {
    epoll_event event{};
    event.events = events;
    event.data.fd = fd;
    ::epoll_ctl(epoll_, operation, fd, &event);
  }

  void handle(const epoll_event& event) {
    if (event.data.fd == listener_) return accept();
    const auto found = peers_.find(event.data.fd);
    if (found == peers_.end()) return;
    if ((event.events & EPOLLOUT) != 0) write(found->second);
    if ((event.events & (EPOLLIN | EPOLLHUP | EPOLLERR)) != 0) read(found->second);
  }

  void accept() {
    for (;;) {
      const int fd = ::accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK);
      if (fd < 0) return;
      const int yes = 1;
      ::setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof(yes));
      Peer& peer = peers_[fd];
      peer.fd = fd;
      if (tls_) peer.tls.emplace(*net::TlsSession::accept(fd, *tls_));
      watch(fd, EPOLLIN, EPOLL_CTL_ADD);
    }
  }

  void read(Peer& peer) {
    for (;;) {
      const long size = receive(peer);
      if (size < 0) return;
      if (size == 0) return drop(peer);
      const std::uint8_t* from = buffer_.data();
      const std::uint8_t* end = from + size;
      if (peer.role == 0) peer.role = static_cast<char>(*from++);
      peer.incoming.insert(peer.incoming.end(), from, end);
      if (peer.incoming.size() >= frame_bytes_) forward(peer);
      if (!peer.tls && size < static_cast<long>(buffer_.size())) return;
    }
  }

  /// Number of bytes; 0: the connection ended; -1: no data now.
  long receive(Peer& peer) {
    if (!peer.tls) {
      const long size = ::recv(peer.fd, buffer_.data(), buffer_.size(), 0);
      return size < 0 && errno != EAGAIN ? 0 : size;
    }
    const auto step = peer.tls->read(buffer_);
    if (step.outcome == net::TlsSession::Outcome::kDone) return static_cast<long>(step.size);
    const bool over = step.outcome == net::TlsSession::Outcome::kEnded ||
                      step.outcome == net::TlsSession::Outcome::kFailed;
    return over ? 0 : -1;
  }

  void forward(Peer& publisher) {
    while (publisher.incoming.size() >= frame_bytes_) {
      const auto end = publisher.incoming.begin() + static_cast<std::ptrdiff_t>(frame_bytes_);
      const auto frame =
          std::make_shared<const std::vector<std::uint8_t>>(publisher.incoming.begin(), end);
      publisher.incoming.erase(publisher.incoming.begin(), end);
      for (auto& [fd, peer] : peers_) {
        if (peer.role != 'V') continue;
        peer.outgoing.push_back(frame);
        if (!peer.waits_to_write) write(peer);
      }
    }
  }

  void write(Peer& peer) {
    bool blocked = false;
    while (!peer.outgoing.empty() && !blocked) {
      const auto rest = std::span(*peer.outgoing.front()).subspan(peer.written);
      const std::size_t size = send(peer, rest);
      peer.written += size;
      blocked = size == 0;
      if (peer.written < peer.outgoing.front()->size()) continue;
      peer.outgoing.pop_front();
      peer.written = 0;
    }
    if (blocked == peer.waits_to_write) return;
    peer.waits_to_write = blocked;
    watch(peer.fd, blocked ? EPOLLIN | EPOLLOUT : EPOLLIN, EPOLL_CTL_MOD);
  }

  static std::size_t send(Peer& peer, std::span<const std::uint8_t> bytes) {
    if (peer.tls) return peer.tls->write(bytes).size;
    const long size = ::send(peer.fd, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    return size < 0 ? 0 : static_cast<std::size_t>(size);
  }

  void drop(Peer& peer) {
    const int fd = peer.fd;
    peers_.erase(fd);
    ::close(fd);
  }

  const std::size_t frame_bytes_;
  const std::shared_ptr<const net::TlsServerContext> tls_;
  int epoll_ = ::epoll_create1(0);
  int listener_ = -1;
  std::unordered_map<int, Peer> peers_;
  std::vector<std::uint8_t> buffer_;
};

class SocketLoopEngine final : public Engine {
 public:
  explicit SocketLoopEngine(bool tls) : tls_(tls) {}
  std::string name() const override { return tls_ ? "epoll + SSL_write" : "epoll + send"; }
  bool encrypts() const override { return tls_; }

  Result<RunningEngine> start(const FanoutRoom& room) const override {
    std::shared_ptr<const net::TlsServerContext> context;
    std::optional<net::Fingerprint> fingerprint;
    if (tls_) {
      auto identity = make_tls_identity();
      if (!identity) return identity.error();
      context = identity->context;
      fingerprint = identity->fingerprint;
    }
    auto child = ChildProcess::fork_off([&](const ChildProcess::PortReport& report) {
      SocketLoop(room.frame_bytes, context).run(report);
    });
    if (!child) return child.error();
    return RunningEngine{*std::move(child), raw_protocol(room.frame_bytes), fingerprint};
  }

 private:
  bool tls_;
};

}  // namespace

std::unique_ptr<Engine> make_socket_loop(bool tls) {
  return std::make_unique<SocketLoopEngine>(tls);
}

}  // namespace roomcast::bench
