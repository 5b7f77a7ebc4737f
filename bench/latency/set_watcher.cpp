// SPDX-License-Identifier: Apache-2.0
#include "bench/latency/set_watcher.h"

#include <cmath>
#include <mutex>
#include <utility>

#include "bench/latency/hub_address.h"
#include "roomcast/client/hub_link.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::bench {

namespace {

wire::pb::Join join_message() {
  wire::pb::Join join;
  join.mutable_viewer();
  return join;
}

}  // namespace

class SetWatcher::Link final : public client::HubLinkEvents {
 public:
  explicit Link(const std::string& hub_url)
      : link_(network_.io(), hub_address(hub_url), join_message(), *this) {
    link_.start();
    network_.start();
  }
  ~Link() override {
    network_.finish([this] { link_.stop(); });
  }

  void on_welcome(const wire::pb::Welcome&) override {}
  void on_control(const wire::pb::Control&) override {}
  void on_frame(net::MessageBuffer message) override {
    const HostTime now = SteadyClock().now();
    const auto header = wire::parse_frame(message.payload());
    if (!header) return;
    const std::chrono::duration<double, std::milli> age =
        now.time_since_epoch() - header->capture_time.time_since_epoch();
    const std::lock_guard lock(mutex_);
    arrivals_.ages_ms.push_back(age.count());
    if (header->small) ++arrivals_.small_frames;
    arrivals_.times_ms[header->sensor.value].push_back(
        std::chrono::duration<double, std::milli>(now.time_since_epoch()).count());
    ++arrivals_.sets[header->set.value];
  }
  net::FramedMessagePtr next_frame() override { return nullptr; }
  void on_clock(const client::ClockEstimate& estimate) override {
    const std::chrono::duration<double, std::micro> error = estimate.room_minus_host;
    const std::lock_guard lock(mutex_);
    arrivals_.clock_errors_us.push_back(std::abs(error.count()));
  }
  void on_down(const Error&, bool) override {}

  Arrivals take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(arrivals_, {});
  }
  bool sees_something() const {
    const std::lock_guard lock(mutex_);
    return !arrivals_.sets.empty();
  }

 private:
  mutable std::mutex mutex_;
  Arrivals arrivals_;
  client::NetworkThread network_;
  client::HubLink link_;
};

SetWatcher::SetWatcher(const std::string& hub_url) : link_(std::make_unique<Link>(hub_url)) {}
SetWatcher::~SetWatcher() = default;

bool SetWatcher::sees_something() const {
  return link_->sees_something();
}

Arrivals SetWatcher::take() {
  return link_->take();
}

}  // namespace roomcast::bench
