/* SPDX-License-Identifier: Apache-2.0 */
/* Is a sensor: sends pictures of a wall with a hole that moves, as a camera's program would send its own.
 *   cc sensor.c $(pkg-config --cflags --libs roomcast) -o sensor && ./sensor ws://127.0.0.1:7600 my-camera 60 */
#include <roomcast.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { WIDTH = 320, HEIGHT = 240, FPS = 15 };
static uint16_t depth_mm[WIDTH * HEIGHT];
static uint8_t color_rgb[3 * WIDTH * HEIGHT]; /* only red is filled here */

int main(int argc, char** argv) {
  char error[256];
  const int seconds = argc > 3 ? atoi(argv[3]) : 60;
  const roomcast_options room = {.size = sizeof(room), .hub = argc > 1 ? argv[1] : "ws://127.0.0.1:7600",
                                 .name = argc > 2 ? argv[2] : "sensor.c"};
  const roomcast_camera camera = {sizeof(camera), WIDTH, HEIGHT, 280, 280, 159.5, 119.5, 0, 0, 0, 0, 0};
  const double world_from_depth[16] = {1, 0, 0, 0, 0, -1, 0, 1.5, 0, 0, -1, 2, 0, 0, 0, 1}; /* looks along -z */
  const roomcast_sensor_options sensor = {.size = sizeof(sensor), .depth = &camera, .fps = FPS,
                                          .world_from_depth = world_from_depth, .depth_mode = ROOMCAST_DEPTH_LOSSLESS};
  roomcast_publisher* publisher = roomcast_publish(&room, &sensor, error, sizeof(error));
  roomcast_send_report report = {.size = sizeof(report)};
  int ok = publisher != NULL;
  for (int frame = 0; ok && frame < FPS * seconds; ++frame) {
    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
      depth_mm[i] = (i + 4 * frame) % WIDTH < 40 ? 0 : 2000; /* 0: no reading */
      color_rgb[3 * i] = (uint8_t)(i % WIDTH);
    }
    const roomcast_capture capture = {sizeof(capture), roomcast_host_time_ns(), depth_mm, WIDTH, HEIGHT,
                                      color_rgb, WIDTH, HEIGHT};
    ok = roomcast_send_frame(publisher, &capture, &report, error, sizeof(error));
    nanosleep(&(struct timespec){.tv_nsec = 1000000000 / FPS}, NULL);
  }
  if (ok) printf("%.0f frames sent, %.0f skipped\n", (double)report.frames_sent, (double)report.frames_skipped);
  else fprintf(stderr, "%s\n", error);
  roomcast_stop_publishing(publisher);
  return ok ? 0 : 1;
}
