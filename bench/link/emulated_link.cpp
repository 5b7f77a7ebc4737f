// SPDX-License-Identifier: Apache-2.0
#include "bench/link/emulated_link.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>
#include <thread>
#include <utility>

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/if.h>
#include <linux/if_tun.h>
#include <netinet/in.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include "roomcast/core/assert.h"

namespace roomcast::bench {

namespace {

constexpr const char* kDevice = "roomcast0";
constexpr const char* kOwnNetwork = "/proc/thread-self/ns/net";
constexpr std::size_t kMaxPacket = 64 * 1024;

/// Closes the file descriptor with its owner.
class Descriptor {
 public:
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  [[nodiscard]] int get() const { return fd_; }
  explicit operator bool() const { return fd_ >= 0; }

 private:
  int fd_;
};

Error failed(const std::string& what) {
  return {ErrorCode::kUnsupported,
          "an emulated link needs root and TUN devices: " + what + ": " + std::strerror(errno)};
}

ifreq request_for(const char* device) {
  ifreq request{};
  std::strncpy(request.ifr_name, device, IFNAMSIZ - 1);
  return request;
}

sockaddr ipv4(const char* text) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  ::inet_pton(AF_INET, text, &address.sin_addr);
  sockaddr generic{};
  static_assert(sizeof(generic) == sizeof(address));
  std::memcpy(&generic, &address, sizeof(address));
  return generic;
}

bool bring_up(int socket, const char* device) {
  ifreq request = request_for(device);
  if (::ioctl(socket, SIOCGIFFLAGS, &request) != 0) return false;
  request.ifr_flags = static_cast<short>(request.ifr_flags | IFF_UP | IFF_RUNNING);
  return ::ioctl(socket, SIOCSIFFLAGS, &request) == 0;
}

/// Opens a TUN device in the network namespace of this thread.
Result<Descriptor> open_tun(const char* own_address) {
  Descriptor tun(::open("/dev/net/tun", O_RDWR | O_NONBLOCK | O_CLOEXEC));
  if (!tun) return failed("/dev/net/tun");
  ifreq request = request_for(kDevice);
  request.ifr_flags = IFF_TUN | IFF_NO_PI;
  if (::ioctl(tun.get(), TUNSETIFF, &request) != 0) return failed("a TUN device");
  const Descriptor socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  request = request_for(kDevice);
  request.ifr_addr = ipv4(own_address);
  if (::ioctl(socket.get(), SIOCSIFADDR, &request) != 0) return failed("its address");
  request.ifr_netmask = ipv4("255.255.255.0");
  if (::ioctl(socket.get(), SIOCSIFNETMASK, &request) != 0) return failed("its netmask");
  if (!bring_up(socket.get(), kDevice) || !bring_up(socket.get(), "lo"))
    return failed("bringing it up");
  return tun;
}

struct Network {
  Descriptor handle, tun;
};

/// Makes a network namespace with one device and loopback. Leaves the calling thread in it.
Result<Network> make_network(const char* address) {
  if (::unshare(CLONE_NEWNET) != 0) return failed("a network namespace");
  auto tun = open_tun(address);
  if (!tun) return tun.error();
  Descriptor handle(::open(kOwnNetwork, O_RDONLY | O_CLOEXEC));
  if (!handle) return failed(kOwnNetwork);
  return Network{std::move(handle), *std::move(tun)};
}

}  // namespace

/// Carries packets between the two ends.
class EmulatedLink::Pump {
 public:
  Pump(const LinkSpec& spec, Network near, Network far)
      : networks_{std::move(near), std::move(far)},
        queues_{LinkQueue(spec, spec.seed), LinkQueue(spec, spec.seed + 1)},
        timer_(::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)),
        thread_([this](const std::stop_token& stop) { carry(stop); }) {}

  [[nodiscard]] const Network& network(End end) const {
    return networks_[static_cast<std::size_t>(end)];
  }
  [[nodiscard]] std::uint64_t carried_bytes() const { return carried_bytes_; }
  void set_rate(double mbit_per_s) { new_rate_ = mbit_per_s; }
  void stop_for(std::chrono::milliseconds duration) { stop_ms_ = duration.count(); }

 private:
  void carry(const std::stop_token& stop) {
    constexpr int kLookForStop_ms = 50;
    std::array<pollfd, 3> waits{{{networks_[0].tun.get(), POLLIN, 0},
                                 {networks_[1].tun.get(), POLLIN, 0},
                                 {timer_.get(), POLLIN, 0}}};
    while (!stop.stop_requested()) {
      set_timer();
      ::poll(waits.data(), waits.size(), kLookForStop_ms);
      if (const double rate = new_rate_.exchange(0); rate > 0)
        for (LinkQueue& queue : queues_) queue.set_rate(std::chrono::steady_clock::now(), rate);
      if (const std::chrono::milliseconds stop_time(stop_ms_.exchange(0)); stop_time.count() > 0)
        for (LinkQueue& queue : queues_)
          queue.stop_for(std::chrono::steady_clock::now(), stop_time);
      for (std::size_t i = 0; i < queues_.size(); ++i) {
        take_in(networks_[i].tun.get(), queues_[i]);
        let_out(queues_[i], networks_[1 - i].tun.get());
      }
      carried_bytes_ = queues_[0].carried_bytes();
    }
  }

  void set_timer() {
    std::optional<LinkQueue::Time> next;
    for (const LinkQueue& queue : queues_) {
      const auto arrival = queue.next_arrival();
      if (arrival && (!next || *arrival < *next)) next = arrival;
    }
    itimerspec spec{};  // all zero: off
    if (next) {
      const auto ns = std::chrono::nanoseconds(next->time_since_epoch()).count();
      spec.it_value = {ns / 1'000'000'000, ns % 1'000'000'000};
    }
    ::timerfd_settime(timer_.get(), TFD_TIMER_ABSTIME, &spec, nullptr);
  }

  void take_in(int tun, LinkQueue& queue) {
    constexpr int kAtATime = 64;  // then it is the other direction's turn
    for (int i = 0; i < kAtATime; ++i) {
      const auto size = ::read(tun, buffer_.data(), buffer_.size());
      if (size <= 0) return;
      queue.push(std::chrono::steady_clock::now(),
                 std::span(buffer_).first(static_cast<std::size_t>(size)));
    }
  }

  /// Packets that the kernel does not take at once are lost, as on any link.
  static void let_out(LinkQueue& queue, int tun) {
    while (const auto packet = queue.pop(std::chrono::steady_clock::now())) {
      [[maybe_unused]] const auto size = ::write(tun, packet->data(), packet->size());
    }
  }

  std::array<Network, 2> networks_;
  std::array<LinkQueue, 2> queues_;
  Descriptor timer_;
  std::vector<std::uint8_t> buffer_ = std::vector<std::uint8_t>(kMaxPacket);
  std::atomic<std::uint64_t> carried_bytes_ = 0;
  std::atomic<double> new_rate_ = 0;  // 0: as it is
  std::atomic<std::int64_t> stop_ms_ = 0;
  std::jthread thread_;  // last: uses the members above
};

EmulatedLink::EmulatedLink(std::unique_ptr<Pump> pump) : pump_(std::move(pump)) {}
EmulatedLink::~EmulatedLink() = default;

Result<std::unique_ptr<EmulatedLink>> EmulatedLink::open(const LinkSpec& spec) {
  Result<Network> near = Error{ErrorCode::kUnsupported, ""}, far = near.error();
  // On a temporary thread, because entering a namespace changes the calling thread.
  std::thread([&] {
    near = make_network(address(End::kNear));
    if (near) far = make_network(address(End::kFar));
  }).join();
  if (!near) return near.error();
  if (!far) return far.error();
  return std::unique_ptr<EmulatedLink>(
      new EmulatedLink(std::make_unique<Pump>(spec, *std::move(near), *std::move(far))));
}

void EmulatedLink::run(End end, const std::function<void()>& work) const {
  std::thread([&] {
    const int moved = ::setns(pump_->network(end).handle.get(), CLONE_NEWNET);
    ROOMCAST_ASSERT(moved == 0);
    work();
  }).join();
}

const char* EmulatedLink::address(End end) {
  return end == End::kNear ? "10.77.0.1" : "10.77.0.2";
}

void EmulatedLink::set_rate(double mbit_per_s) {
  pump_->set_rate(mbit_per_s);
}

void EmulatedLink::stop_for(std::chrono::milliseconds duration) {
  pump_->stop_for(duration);
}

std::uint64_t EmulatedLink::carried_bytes() const {
  return pump_->carried_bytes();
}

}  // namespace roomcast::bench
