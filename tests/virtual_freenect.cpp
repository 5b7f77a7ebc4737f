// SPDX-License-Identifier: Apache-2.0
// A Kinect v1 that can be unplugged. Replaces libfreenect and forwards every call to Debian's
// library for replaying recordings (fakenect). fakenect cannot restart a recording, so it is loaded
// again for every opening. This file adds the missing serial number and the calibration in the
// camera's memory. The camera is plugged in while $FAKENECT_PATH contains no file "unplugged".
#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>

#include <dlfcn.h>
#include <libfreenect.h>
#include <libfreenect_registration.h>

namespace {

constexpr char kFakenect[] = "/usr/lib/x86_64-linux-gnu/fakenect/libfreenect.so.0.5";
constexpr int kWidth = 640, kHeight = 480;
char serial[] = "A00367813501053A";

/// The replaying library, while a context is open. One thread plays recordings.
void* replay = nullptr;
int users = 0;

template <class Function>
Function* in_replay(const char* name) {
  void* const found = dlsym(replay, name);
  if (found == nullptr) std::abort();
  return reinterpret_cast<Function*>(found);
}

bool is_plugged_in() {
  const char* const folder = std::getenv("FAKENECT_PATH");
  return folder != nullptr && !std::filesystem::exists(std::filesystem::path(folder) / "unplugged");
}

}  // namespace

#define REPLAYED(function) in_replay<decltype(function)>(#function)

extern "C" {

int freenect_init(freenect_context** context, freenect_usb_context* usb) {
  if (users++ == 0) replay = dlopen(kFakenect, RTLD_NOW | RTLD_LOCAL);
  return replay == nullptr ? -1 : REPLAYED(freenect_init)(context, usb);
}
int freenect_shutdown(freenect_context* context) {
  const int result = REPLAYED(freenect_shutdown)(context);
  if (--users == 0) dlclose(replay);
  return result;
}
int freenect_num_devices(freenect_context*) {
  return is_plugged_in() ? 1 : 0;
}
int freenect_list_device_attributes(freenect_context*, freenect_device_attributes** list) {
  *list = nullptr;
  if (!is_plugged_in()) return 0;
  *list = static_cast<freenect_device_attributes*>(std::calloc(1, sizeof(**list)));
  (*list)->camera_serial = serial;
  return 1;
}
void freenect_free_device_attributes(freenect_device_attributes* list) {
  std::free(list);
}
int freenect_open_device(freenect_context* context, freenect_device** device, int index) {
  return is_plugged_in() ? REPLAYED(freenect_open_device)(context, device, index) : -1;
}
int freenect_open_device_by_camera_serial(freenect_context* context, freenect_device** device,
                                          const char* wanted) {
  if (!is_plugged_in()) return -1;
  return REPLAYED(freenect_open_device_by_camera_serial)(context, device, wanted);
}
int freenect_process_events_timeout(freenect_context* context, timeval* timeout) {
  if (!is_plugged_in()) return -1;
  return REPLAYED(freenect_process_events_timeout)(context, timeout);
}

/// Cameras without distortion, focal lengths 575.8 and 525 pixels, 25 mm apart.
freenect_registration freenect_copy_registration(freenect_device*) {
  constexpr double kScale = 525 / 575.8, kShift_px_mm = -525 * 25;
  freenect_registration memory{};
  memory.zero_plane_info = {7.5F, 2.5F, 120.F, 0.1042F};
  memory.const_shift = 200;
  using Pixel = std::array<std::int32_t, 2>;
  auto* const pixels = static_cast<Pixel*>(std::malloc(sizeof(Pixel) * kWidth * kHeight));
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      pixels[y * kWidth + x] = {static_cast<std::int32_t>(256 * (320 + (x - 319.5) * kScale)),
                                static_cast<std::int32_t>(240 + (y - 239.5) * kScale)};
    }
  }
  memory.registration_table = reinterpret_cast<std::int32_t(*)[2]>(pixels);
  memory.depth_to_rgb_shift =
      static_cast<std::int32_t*>(std::calloc(FREENECT_DEPTH_MM_MAX_VALUE, sizeof(std::int32_t)));
  for (int mm = 1; mm < FREENECT_DEPTH_MM_MAX_VALUE; ++mm)
    memory.depth_to_rgb_shift[mm] = static_cast<std::int32_t>(256 * kShift_px_mm / mm);
  return memory;
}
int freenect_destroy_registration(freenect_registration* memory) {
  std::free(memory->registration_table);
  std::free(memory->depth_to_rgb_shift);
  return 0;
}

int freenect_close_device(freenect_device* device) {
  return REPLAYED(freenect_close_device)(device);
}
void freenect_select_subdevices(freenect_context* context, freenect_device_flags devices) {
  REPLAYED(freenect_select_subdevices)(context, devices);
}
void freenect_set_log_level(freenect_context* context, freenect_loglevel level) {
  REPLAYED(freenect_set_log_level)(context, level);
}
void freenect_set_user(freenect_device* device, void* user) {
  REPLAYED(freenect_set_user)(device, user);
}
void* freenect_get_user(freenect_device* device) {
  return REPLAYED(freenect_get_user)(device);
}
void freenect_set_depth_callback(freenect_device* device, freenect_depth_cb callback) {
  REPLAYED(freenect_set_depth_callback)(device, callback);
}
void freenect_set_video_callback(freenect_device* device, freenect_video_cb callback) {
  REPLAYED(freenect_set_video_callback)(device, callback);
}
freenect_frame_mode freenect_find_depth_mode(freenect_resolution size,
                                             freenect_depth_format format) {
  return REPLAYED(freenect_find_depth_mode)(size, format);
}
freenect_frame_mode freenect_find_video_mode(freenect_resolution size,
                                             freenect_video_format format) {
  return REPLAYED(freenect_find_video_mode)(size, format);
}
int freenect_set_depth_mode(freenect_device* device, const freenect_frame_mode mode) {
  return REPLAYED(freenect_set_depth_mode)(device, mode);
}
int freenect_set_video_mode(freenect_device* device, const freenect_frame_mode mode) {
  return REPLAYED(freenect_set_video_mode)(device, mode);
}
int freenect_start_depth(freenect_device* device) {
  return REPLAYED(freenect_start_depth)(device);
}
int freenect_start_video(freenect_device* device) {
  return REPLAYED(freenect_start_video)(device);
}
int freenect_stop_depth(freenect_device* device) {
  return REPLAYED(freenect_stop_depth)(device);
}
int freenect_stop_video(freenect_device* device) {
  return REPLAYED(freenect_stop_video)(device);
}
int freenect_set_flag(freenect_device*, freenect_flag, freenect_flag_value) {
  return 0;
}

}  // extern "C"
