// SPDX-License-Identifier: Apache-2.0
// A camera without hardware: a driver that OpenNI loads like any other. Its depth is a slanted
// plane, its colour encodes the pixel position. It is plugged in while $ROOMCAST_VIRTUAL_CAMERAS
// names a folder that contains no file "unplugged".
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <thread>

#define XN_NEW(type, ...) new type(__VA_ARGS__)
#define XN_DELETE(object) delete object
#include <Driver/OniDriverAPI.h>

namespace {

using std::chrono::milliseconds;

constexpr int kWidth = 320, kHeight = 240, kFps = 30;
constexpr float kHorizontalField = 1.0145F, kVerticalField = 0.7898F;
constexpr char kSerial[] = "VIRTUAL-7";
constexpr OniDeviceInfo kInfo = {"virtual://camera", "roomcast", "virtual camera", 0, 0};

template <class T>
OniStatus give(const T& value, void* data, int* size) {
  if (*size < static_cast<int>(sizeof(T))) return ONI_STATUS_BAD_PARAMETER;
  std::memcpy(data, &value, sizeof(T));
  *size = sizeof(T);
  return ONI_STATUS_OK;
}

bool is_plugged_in() {
  const char* const folder = std::getenv("ROOMCAST_VIRTUAL_CAMERAS");
  return folder != nullptr && !std::filesystem::exists(std::filesystem::path(folder) / "unplugged");
}

class VirtualStream final : public oni::driver::StreamBase {
 public:
  explicit VirtualStream(bool is_depth) : is_depth_(is_depth) {}
  ~VirtualStream() override { stop(); }

  int getRequiredFrameSize() override { return stride() * kHeight; }

  OniStatus start() override {
    thread_ = std::jthread([this](const std::stop_token& stopped) { give_frames(stopped); });
    return ONI_STATUS_OK;
  }
  void stop() override { thread_ = {}; }

  OniBool isPropertySupported(int property) override {
    // Without the first two properties, recording and playing a file hang.
    return property == ONI_STREAM_PROPERTY_STRIDE || property == ONI_STREAM_PROPERTY_CROPPING ||
           property == ONI_STREAM_PROPERTY_VIDEO_MODE ||
           property == ONI_STREAM_PROPERTY_HORIZONTAL_FOV ||
           property == ONI_STREAM_PROPERTY_VERTICAL_FOV ||
           property == ONI_STREAM_PROPERTY_MAX_VALUE || property == ONI_STREAM_PROPERTY_MIRRORING;
  }
  OniStatus getProperty(int property, void* data, int* size) override {
    switch (property) {
      case ONI_STREAM_PROPERTY_STRIDE:
        return give(stride(), data, size);
      case ONI_STREAM_PROPERTY_CROPPING:
        return give(OniCropping{}, data, size);
      case ONI_STREAM_PROPERTY_VIDEO_MODE:
        return give(mode(), data, size);
      case ONI_STREAM_PROPERTY_HORIZONTAL_FOV:
        return give(kHorizontalField, data, size);
      case ONI_STREAM_PROPERTY_VERTICAL_FOV:
        return give(kVerticalField, data, size);
      case ONI_STREAM_PROPERTY_MAX_VALUE:
        return give(10000, data, size);
      case ONI_STREAM_PROPERTY_MIRRORING:
        return give(OniBool{FALSE}, data, size);
      default:
        return ONI_STATUS_NOT_SUPPORTED;
    }
  }
  OniStatus setProperty(int property, const void*, int) override {
    return isPropertySupported(property) ? ONI_STATUS_OK : ONI_STATUS_NOT_SUPPORTED;
  }

 private:
  [[nodiscard]] int stride() const { return kWidth * (is_depth_ ? 2 : 3); }
  [[nodiscard]] OniVideoMode mode() const {
    return {is_depth_ ? ONI_PIXEL_FORMAT_DEPTH_1_MM : ONI_PIXEL_FORMAT_RGB888, kWidth, kHeight,
            kFps};
  }

  void give_frames(const std::stop_token& stopped) {
    auto due = std::chrono::steady_clock::now();
    for (int index = 1; !stopped.stop_requested(); ++index) {
      if (is_plugged_in()) give_frame(index);
      due += std::chrono::microseconds(1'000'000 / kFps);
      std::this_thread::sleep_until(due);
    }
  }

  void give_frame(int index) {
    OniFrame* const frame = getServices().acquireFrame();
    frame->frameIndex = index;
    frame->timestamp = std::uint64_t(index) * 1'000'000 / kFps;
    frame->videoMode = mode();
    frame->width = kWidth;
    frame->height = kHeight;
    frame->cropOriginX = frame->cropOriginY = 0;
    frame->croppingEnabled = FALSE;
    frame->sensorType = is_depth_ ? ONI_SENSOR_DEPTH : ONI_SENSOR_COLOR;
    frame->stride = stride();
    frame->dataSize = getRequiredFrameSize();
    draw(frame->data);
    raiseNewFrame(frame);
    getServices().releaseFrame(frame);
  }

  void draw(void* data) const {
    auto* const depth = static_cast<std::uint16_t*>(data);
    auto* const color = static_cast<std::uint8_t*>(data);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const int pixel = y * kWidth + x;
        if (is_depth_) {
          depth[pixel] = static_cast<std::uint16_t>(1000 + x + 2 * y);
        } else {
          color[3 * pixel] = static_cast<std::uint8_t>(x / 2);
          color[3 * pixel + 1] = static_cast<std::uint8_t>(y);
          color[3 * pixel + 2] = 77;
        }
      }
    }
  }

  const bool is_depth_;
  std::jthread thread_;
};

class VirtualDevice final : public oni::driver::DeviceBase {
 public:
  OniStatus getSensorInfoList(OniSensorInfo** sensors, int* count) override {
    *sensors = sensors_;
    *count = 2;
    return ONI_STATUS_OK;
  }
  oni::driver::StreamBase* createStream(OniSensorType sensor) override {
    return new VirtualStream(sensor == ONI_SENSOR_DEPTH);
  }
  void destroyStream(oni::driver::StreamBase* stream) override { delete stream; }

  OniStatus getProperty(int property, void* data, int* size) override {
    switch (property) {
      case ONI_DEVICE_PROPERTY_SERIAL_NUMBER:
        std::memcpy(data, kSerial, sizeof(kSerial));
        *size = sizeof(kSerial);
        return ONI_STATUS_OK;
      case ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION:
        return give(registration_, data, size);
      default:
        return ONI_STATUS_NOT_SUPPORTED;
    }
  }
  OniStatus setProperty(int property, const void* data, int size) override {
    if (property != ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION || size != sizeof(registration_))
      return ONI_STATUS_NOT_SUPPORTED;
    std::memcpy(&registration_, data, sizeof(registration_));
    return ONI_STATUS_OK;
  }
  OniBool isPropertySupported(int property) override {
    return property == ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION ||
           property == ONI_DEVICE_PROPERTY_SERIAL_NUMBER;
  }
  OniBool isImageRegistrationModeSupported(OniImageRegistrationMode) override { return TRUE; }

 private:
  OniVideoMode depth_mode_{ONI_PIXEL_FORMAT_DEPTH_1_MM, kWidth, kHeight, kFps};
  OniVideoMode color_mode_{ONI_PIXEL_FORMAT_RGB888, kWidth, kHeight, kFps};
  OniSensorInfo sensors_[2] = {{ONI_SENSOR_DEPTH, 1, &depth_mode_},
                               {ONI_SENSOR_COLOR, 1, &color_mode_}};
  OniImageRegistrationMode registration_ = ONI_IMAGE_REGISTRATION_OFF;
};

class VirtualDriver final : public oni::driver::DriverBase {
 public:
  explicit VirtualDriver(OniDriverServices* services) : DriverBase(services) {}

  OniStatus initialize(oni::driver::DeviceConnectedCallback connected,
                       oni::driver::DeviceDisconnectedCallback disconnected,
                       oni::driver::DeviceStateChangedCallback changed, void* cookie) override {
    DriverBase::initialize(connected, disconnected, changed, cookie);
    was_plugged_in_ = is_plugged_in();
    if (was_plugged_in_) deviceConnected(&kInfo);
    watch_ = std::jthread([this](const std::stop_token& stopped) { watch_the_plug(stopped); });
    return ONI_STATUS_OK;
  }
  oni::driver::DeviceBase* deviceOpen(const char*, const char*) override {
    return is_plugged_in() ? new VirtualDevice : nullptr;
  }
  void deviceClose(oni::driver::DeviceBase* device) override { delete device; }
  void shutdown() override { watch_ = {}; }
  OniStatus tryDevice(const char*) override { return ONI_STATUS_ERROR; }

 private:
  void watch_the_plug(const std::stop_token& stopped) {
    while (!stopped.stop_requested()) {
      const bool is_in = is_plugged_in();
      if (is_in != was_plugged_in_) is_in ? deviceConnected(&kInfo) : deviceDisconnected(&kInfo);
      was_plugged_in_ = is_in;
      std::this_thread::sleep_for(milliseconds(10));
    }
  }

  bool was_plugged_in_ = false;
  std::jthread watch_;
};

}  // namespace

ONI_EXPORT_DRIVER(VirtualDriver)
