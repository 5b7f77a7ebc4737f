// SPDX-License-Identifier: Apache-2.0
// Load: the clients of one server under test: publishers that send numbered frames, and viewers
// that record the arrival time of each frame.
// Threading: one thread. Times are of the steady clock; both ends are in this process.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/fanout/engine.h"
#include "roomcast/core/result.h"
#include "roomcast/net/tls/tls_session.h"

namespace roomcast::bench {

struct Traffic {
  std::uint64_t deliveries = 0;
  std::vector<double> latencies_ms;  // from before the publisher's first byte to the viewer's last
};

class Load {
 public:
  using Clock = std::chrono::steady_clock;

  /// Connects publishers and viewers. `stalled` of the viewers subscribe and never read.
  /// kUnavailable: the server closed a connection.
  static Result<std::unique_ptr<Load>> connect(const RunningEngine& engine, const FanoutRoom& room,
                                               int publishers, int viewers, int stalled = 0);
  ~Load();
  Load(const Load&) = delete;
  Load& operator=(const Load&) = delete;

  /// Sends until every reading viewer has received a frame. kUnavailable: not reached within 10 s.
  [[nodiscard]] Status warm_up();
  /// Each publisher keeps `window` frames on the way: it sends the next when all viewers have one.
  [[nodiscard]] Result<Traffic> run_closed(int window, Clock::duration duration);
  /// Each publisher sends `fps` frames a second, all at the same instants.
  [[nodiscard]] Result<Traffic> run_paced(double fps, Clock::duration duration);

 private:
  struct Viewer {
    int fd = -1;
    std::optional<net::TlsSession> tls;
    std::unique_ptr<MessageCounter> counter;
    bool answered = false;       // any byte received
    std::uint64_t received = 0;  // frames
  };
  struct Publisher {
    int fd = -1;
    std::optional<net::TlsSession> tls;
    std::vector<std::uint8_t> frame;
    std::string unsent;
  };

  Load(const RunningEngine& engine, const FanoutRoom& room) : engine_(engine), room_(room) {}
  Status open(int publishers, int viewers, int stalled);
  Status encrypt(int fd, std::optional<net::TlsSession>& tls);
  Status open_viewer(bool reads);
  Status open_publisher(int index);
  void publish_all();
  Status tell_heads();
  [[nodiscard]] RoomTime capture_time(std::uint32_t number) const;
  void flush(Publisher& publisher);
  Status poll(Clock::duration at_most);
  Status wait_for_answers();
  Status read(Viewer& viewer);
  [[nodiscard]] std::uint64_t least_received() const;
  [[nodiscard]] Traffic take_traffic();

  const RunningEngine& engine_;
  const FanoutRoom room_;
  std::shared_ptr<const net::TlsClientContext> clients_;
  int epoll_ = -1;
  std::vector<Viewer> viewers_;
  int head_steps_ = 0;
  std::vector<int> stalled_fds_;
  std::vector<Publisher> publishers_;
  std::vector<Clock::time_point> sent_at_;  // by number
  std::vector<std::uint32_t> numbers_;      // of the last read
  std::vector<std::uint8_t> buffer_ = std::vector<std::uint8_t>(256 * 1024);
  Traffic traffic_;
};

}  // namespace roomcast::bench
