/* SPDX-License-Identifier: Apache-2.0 */
/* Reads a recording without a hub, and prints what its sensors have seen.
 *   cc read.c $(pkg-config --cflags --libs roomcast) -o read && ./read lab.mcap */
#include <roomcast.h>
#include <stdio.h>

int main(int argc, char** argv) {
  char error[256];
  roomcast_reader* reader = roomcast_open(argc > 1 ? argv[1] : "lab.mcap", error, sizeof(error));
  if (!reader) {
    fprintf(stderr, "%s\n", error);
    return 1;
  }
  roomcast_sensor sensor = {.size = sizeof(sensor)};
  for (size_t i = 0; roomcast_get_recorded_sensor(reader, i, &sensor); ++i)
    printf("%s: %d x %d, focal length %.1f\n", sensor.name, sensor.width, sensor.height, sensor.fx);
  size_t sets = 0, points = 0;
  roomcast_frames* frames;
  while ((frames = roomcast_next_frames(reader, error, sizeof(error)))) {
    for (size_t i = 0; roomcast_get_sensor(frames, i, &sensor); ++i)
      printf("%.3f s: %s, %d mm in the middle\n", 1e-9 * (double)sensor.capture_ns, sensor.name,
             sensor.depth_mm[sensor.width * (sensor.height / 2) + sensor.width / 2]);
    points += roomcast_get_points(frames, NULL, 0);
    ++sets;
    roomcast_free_frames(frames);
  }
  if (error[0]) fprintf(stderr, "%s\n", error);
  printf("%zu sets, %zu points\n", sets, points);
  roomcast_close(reader);
  return error[0] ? 1 : 0;
}
