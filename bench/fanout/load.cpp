// SPDX-License-Identifier: Apache-2.0
#include "bench/fanout/load.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace roomcast::bench {

namespace {

using namespace std::chrono_literals;
using Outcome = net::TlsSession::Outcome;
constexpr auto kAnswersWithin = 10s;

Error hung_up() {
  return {ErrorCode::kUnavailable, "a server under test hung up"};
}

int connect_to(std::uint16_t port) {
  const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
    ::close(fd);
    return -1;
  }
  const int yes = 1;
  ::setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof(yes));
  ::fcntl(fd, F_SETFL, O_NONBLOCK);
  return fd;
}

void wait_for(int fd, short events) {
  pollfd question{.fd = fd, .events = events, .revents = 0};
  ::poll(&question, 1, 1000);
}

/// Writes everything; waits at most kAnswersWithin.
bool write_all(int fd, std::optional<net::TlsSession>& tls, std::string_view text) {
  const auto give_up = Load::Clock::now() + kAnswersWithin;
  while (!text.empty() && Load::Clock::now() < give_up) {
    std::size_t size = 0;
    short waits_for = POLLOUT;
    if (tls) {
      const auto step =
          tls->write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
      if (step.outcome == Outcome::kEnded || step.outcome == Outcome::kFailed) return false;
      if (step.outcome == Outcome::kWaitsToRead) waits_for = POLLIN;
      size = step.size;
    } else {
      const auto sent = ::send(fd, text.data(), text.size(), MSG_NOSIGNAL);
      if (sent < 0 && errno != EAGAIN) return false;
      size = sent < 0 ? 0 : static_cast<std::size_t>(sent);
    }
    text.remove_prefix(size);
    if (size == 0) wait_for(fd, waits_for);
  }
  return text.empty();
}

}  // namespace

Result<std::unique_ptr<Load>> Load::connect(const RunningEngine& engine, const FanoutRoom& room,
                                            int publishers, int viewers, int stalled) {
  std::unique_ptr<Load> load(new Load(engine, room));
  if (auto status = load->open(publishers, viewers, stalled); !status) return status.error();
  return load;
}

Load::~Load() {
  for (const Viewer& viewer : viewers_) ::close(viewer.fd);
  for (const Publisher& publisher : publishers_) ::close(publisher.fd);
  for (const int fd : stalled_fds_) ::close(fd);
  if (epoll_ >= 0) ::close(epoll_);
}

Status Load::open(int publishers, int viewers, int stalled) {
  epoll_ = ::epoll_create1(EPOLL_CLOEXEC);
  auto clients = net::TlsClientContext::create();
  if (!clients) return clients.error();
  clients_ = *std::move(clients);
  viewers_.reserve(static_cast<std::size_t>(viewers));
  for (int i = 0; i < publishers; ++i) {
    if (auto status = open_publisher(i); !status) return status;
  }
  constexpr int kAtATime = 32;  // a server may limit the number of clients that have not joined yet
  for (int i = 0; i < viewers; ++i) {
    if (auto status = open_viewer(i >= stalled); !status) return status;
    if (i % kAtATime == kAtATime - 1) {
      if (auto status = wait_for_answers(); !status) return status;
    }
  }
  return wait_for_answers();
}

Status Load::wait_for_answers() {
  const auto give_up = Clock::now() + kAnswersWithin;
  do {
    if (auto status = poll(20ms); !status) return status;
    const bool all = std::ranges::all_of(viewers_, &Viewer::answered);
    if (all || !engine_.protocol->answers_greetings()) return {};
  } while (Clock::now() < give_up);
  return Error{ErrorCode::kUnavailable, "a server under test does not answer"};
}

Status Load::encrypt(int fd, std::optional<net::TlsSession>& tls) {
  if (!engine_.certificate) return {};
  auto session = net::TlsSession::connect(fd, *clients_, {"localhost", engine_.certificate});
  if (!session) return session.error();
  tls = *std::move(session);
  return {};
}

Status Load::open_publisher(int index) {
  Publisher publisher;
  publisher.fd = connect_to(engine_.process.port());
  publisher.frame = make_frame(room_.frame_bytes);
  if (publisher.fd < 0) return hung_up();
  publishers_.push_back(std::move(publisher));
  Publisher& opened = publishers_.back();
  if (auto status = encrypt(opened.fd, opened.tls); !status) return status;
  if (!write_all(opened.fd, opened.tls, engine_.protocol->publisher_greeting(index))) {
    return hung_up();
  }
  std::this_thread::sleep_for(50ms);  // lets the server assign ids in the order of joining
  return {};
}

Status Load::open_viewer(bool reads) {
  Viewer viewer;
  viewer.fd = connect_to(engine_.process.port());
  if (viewer.fd < 0) return hung_up();
  if (!reads) {
    const int small = 16 * 1024;
    ::setsockopt(viewer.fd, SOL_SOCKET, SO_RCVBUF, &small, sizeof(small));
  }
  if (auto status = encrypt(viewer.fd, viewer.tls); !status) return status;
  if (!write_all(viewer.fd, viewer.tls, engine_.protocol->viewer_greeting())) return hung_up();
  if (!reads) {
    stalled_fds_.push_back(viewer.fd);
    return {};
  }
  viewer.counter = engine_.protocol->make_counter();
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.u64 = viewers_.size();
  ::epoll_ctl(epoll_, EPOLL_CTL_ADD, viewer.fd, &event);
  viewers_.push_back(std::move(viewer));
  return {};
}

void Load::publish_all() {
  const auto number = static_cast<std::uint32_t>(sent_at_.size());
  sent_at_.push_back(Clock::now());
  for (std::size_t i = 0; i < publishers_.size(); ++i) {
    Publisher& publisher = publishers_[i];
    set_number(publisher.frame, static_cast<int>(i), number, capture_time(number));
    engine_.protocol->publish(publisher.frame, publisher.unsent);
    flush(publisher);
  }
}

Status Load::tell_heads() {
  if (room_.heads == Heads::kNotTold) return {};
  ++head_steps_;
  for (std::size_t i = 0; i < viewers_.size(); ++i) {
    const std::string head = engine_.protocol->head_of(static_cast<int>(i), head_steps_,
                                                       room_.heads == Heads::kElsewhere);
    if (!write_all(viewers_[i].fd, viewers_[i].tls, head)) return hung_up();
  }
  return {};
}

RoomTime Load::capture_time(std::uint32_t number) const {
  if (room_.real_time) return RoomTime(sent_at_[number].time_since_epoch());
  return RoomTime(nanoseconds(std::llround(1e9 / room_.fps * number)));
}

/// Discards the server's answers to a publisher; unread answers would block the server.
void Load::flush(Publisher& publisher) {
  std::array<std::uint8_t, 4096> ignored{};
  if (publisher.tls) {
    publisher.tls->read(ignored);
    while (!publisher.unsent.empty()) {
      const auto size = publisher.tls
                            ->write({reinterpret_cast<const std::uint8_t*>(publisher.unsent.data()),
                                     publisher.unsent.size()})
                            .size;
      if (size == 0) return;
      publisher.unsent.erase(0, size);
    }
    return;
  }
  while (::recv(publisher.fd, ignored.data(), ignored.size(), MSG_DONTWAIT) > 0) {
  }
  const auto sent = ::send(publisher.fd, publisher.unsent.data(), publisher.unsent.size(),
                           MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent > 0) publisher.unsent.erase(0, static_cast<std::size_t>(sent));
}

Status Load::poll(Clock::duration at_most) {
  std::array<epoll_event, 256> events{};
  const auto until = Clock::now() + at_most;
  do {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
    const int wait = static_cast<int>(std::clamp<long>(left.count(), 0, 1));
    const int count = ::epoll_wait(epoll_, events.data(), static_cast<int>(events.size()), wait);
    for (int i = 0; i < count; ++i) {
      auto& viewer = viewers_[events[static_cast<std::size_t>(i)].data.u64];
      if (auto status = read(viewer); !status) return status;
    }
    for (Publisher& publisher : publishers_) {
      if (!publisher.unsent.empty()) flush(publisher);
    }
    if (count > 0 && at_most == Clock::duration::zero()) break;
  } while (Clock::now() < until);
  return {};
}

Status Load::read(Viewer& viewer) {
  numbers_.clear();
  for (;;) {
    std::size_t size = 0;
    if (viewer.tls) {
      const auto step = viewer.tls->read(buffer_);
      if (step.outcome == Outcome::kEnded || step.outcome == Outcome::kFailed) return hung_up();
      size = step.size;
    } else {
      const auto received = ::recv(viewer.fd, buffer_.data(), buffer_.size(), 0);
      if (received == 0 || (received < 0 && errno != EAGAIN)) return hung_up();
      size = received < 0 ? 0 : static_cast<std::size_t>(received);
    }
    if (size == 0) break;
    viewer.answered = true;
    if (!viewer.counter->take(std::span(buffer_).first(size), numbers_)) return hung_up();
    if (!viewer.tls && size < buffer_.size()) break;
  }
  const auto now = Clock::now();
  for (const std::uint32_t number : numbers_) {
    if (number >= sent_at_.size()) return hung_up();
    ++viewer.received;
    ++traffic_.deliveries;
    const std::chrono::duration<double, std::milli> latency = now - sent_at_[number];
    traffic_.latencies_ms.push_back(latency.count());
  }
  return {};
}

std::uint64_t Load::least_received() const {
  std::uint64_t least = UINT64_MAX;
  for (const Viewer& viewer : viewers_) least = std::min(least, viewer.received);
  return least;
}

Traffic Load::take_traffic() {
  return std::exchange(traffic_, {});
}

Status Load::warm_up() {
  const auto give_up = Clock::now() + kAnswersWithin;
  while (least_received() == 0) {
    if (Clock::now() > give_up) {
      return Error{ErrorCode::kUnavailable, "a server under test does not deliver"};
    }
    publish_all();
    if (auto status = poll(50ms); !status) return status;
  }
  if (auto status = poll(200ms); !status) return status;
  for (Viewer& viewer : viewers_) viewer.received = 0;
  traffic_ = {};
  return {};
}

Result<Traffic> Load::run_closed(int window, Clock::duration duration) {
  for (Viewer& viewer : viewers_) viewer.received = 0;
  const auto until = Clock::now() + duration;
  const auto per_round = publishers_.size();
  std::uint64_t rounds = 0;
  auto last_progress = Clock::now();
  while (Clock::now() < until) {
    if (rounds < least_received() / per_round + static_cast<std::uint64_t>(window)) {
      publish_all();
      ++rounds;
      last_progress = Clock::now();
    } else if (Clock::now() - last_progress > 1s) {
      return Error{ErrorCode::kUnavailable, "a server under test left frames out"};
    }
    if (auto status = poll(Clock::duration::zero()); !status) return status.error();
  }
  return take_traffic();
}

Result<Traffic> Load::run_paced(double fps, Clock::duration duration) {
  const auto period =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / fps));
  const auto until = Clock::now() + duration;
  for (auto next = Clock::now(); next < until; next += period) {
    if (next > Clock::now()) {
      if (auto status = poll(next - Clock::now()); !status) return status.error();
    }
    if (auto status = tell_heads(); !status) return status.error();
    publish_all();
  }
  if (auto status = poll(std::min<Clock::duration>(500ms, duration)); !status) {
    return status.error();
  }
  return take_traffic();
}

}  // namespace roomcast::bench
