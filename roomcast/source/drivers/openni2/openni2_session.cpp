// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/openni2/openni2_session.h"

#include <array>
#include <future>
#include <thread>
#include <utility>

#include "roomcast/core/blocking_queue.h"

namespace roomcast::source {
namespace {

/// A thread that runs tasks one after the other.
class ProcessLifetimeThread {
 public:
  void run(const std::function<void()>& work) {
    std::packaged_task<void()> task(work);
    auto done = task.get_future();
    tasks_.push(std::move(task), {});
    done.wait();
  }

 private:
  static constexpr std::size_t kMaxCameras = 16;
  BlockingQueue<std::packaged_task<void()>> tasks_{kMaxCameras};
  std::jthread thread_{[this](const std::stop_token& stop) {
    while (auto task = tasks_.pop(stop)) (*task)();
  }};
};

}  // namespace

Status OpenNi2Session::status() const {
  if (started_) return {};
  return Error{ErrorCode::kUnavailable,
               std::string("OpenNI does not start: ") + openni::OpenNI::getExtendedError()};
}

OpenNi2DisconnectListener::OpenNi2DisconnectListener(std::string uri) : uri_(std::move(uri)) {
  openni::OpenNI::addDeviceDisconnectedListener(this);
}

OpenNi2DisconnectListener::~OpenNi2DisconnectListener() {
  openni::OpenNI::removeDeviceDisconnectedListener(this);
}

void OpenNi2DisconnectListener::onDeviceDisconnected(const openni::DeviceInfo* device) {
  if (uri_ == device->getUri()) happened_ = true;
}

void on_openni2_thread(const std::function<void()>& work) {
  static ProcessLifetimeThread thread;
  thread.run(work);
}

std::string openni2_serial(const openni::Device& device) {
  std::array<char, 128> text{};
  int size = static_cast<int>(text.size()) - 1;
  const auto status = device.getProperty(ONI_DEVICE_PROPERTY_SERIAL_NUMBER, text.data(), &size);
  return status == openni::STATUS_OK ? text.data() : "";
}

}  // namespace roomcast::source
