// SPDX-License-Identifier: Apache-2.0
// Records a room for some seconds and prints the depth at the middle of each sensor's picture.
//   c++ -std=c++17 record.cpp $(pkg-config --cflags --libs roomcast) -o record
//   ./record ws://127.0.0.1:7600 lab.mcap 10
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <roomcast.h>

struct Deleter {
  void operator()(roomcast_viewer* viewer) const { roomcast_disconnect(viewer); }
  void operator()(roomcast_frames* frames) const { roomcast_free_frames(frames); }
};

static int fail(const char* sentence) {
  std::fprintf(stderr, "%s\n", sentence);
  return 1;
}

int main(int argc, char** argv) {
  if (argc < 4) return fail("usage: record HUB OUT.mcap SECONDS");
  char error[256] = "";
  roomcast_options options{};
  options.size = sizeof(options);
  options.hub = argv[1];
  options.name = "record.cpp";
  roomcast_recorder* recorder = roomcast_record(&options, argv[2], error, sizeof(error));
  if (!recorder) return fail(error);
  const std::unique_ptr<roomcast_viewer, Deleter> viewer(
      roomcast_connect(&options, error, sizeof(error)));
  const auto end =
      std::chrono::steady_clock::now() + std::chrono::duration<double>(std::atof(argv[3]));
  while (viewer && std::chrono::steady_clock::now() < end &&
         roomcast_is_recording(recorder, error, sizeof(error))) {
    const std::unique_ptr<roomcast_frames, Deleter> frames(roomcast_wait_frames(viewer.get(), 200));
    roomcast_sensor sensor{};
    sensor.size = sizeof(sensor);
    for (size_t i = 0; frames && roomcast_get_sensor(frames.get(), i, &sensor); ++i) {
      const int middle = sensor.height / 2 * sensor.width + sensor.width / 2;
      std::printf("%s: frame %u, %.2f m ahead\n", sensor.name, sensor.seq,
                  0.001 * sensor.depth_mm[middle]);
    }
  }
  if (!roomcast_stop_recording(recorder, error, sizeof(error)) || !viewer) return fail(error);
  std::printf("recorded %s\n", argv[2]);
  return 0;
}
