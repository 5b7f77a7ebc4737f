/* SPDX-License-Identifier: Apache-2.0 */
/* Receives pictures of all sensors of a room and writes their points as a PLY file.
 *   cc points.c $(pkg-config --cflags --libs roomcast) -o points && ./points ws://127.0.0.1:7600 room.ply */
#include <roomcast.h>
#include <stdio.h>
#include <stdlib.h>

static int write_ply(const char* path, const roomcast_point* points, size_t count) {
  FILE* file = fopen(path, "wb");
  if (!file) return 0;
  fprintf(file,
          "ply\nformat binary_little_endian 1.0\nelement vertex %zu\n"
          "property float x\nproperty float y\nproperty float z\n"
          "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\nend_header\n",
          count);
  fwrite(points, sizeof(*points), count, file);
  return fclose(file) == 0;
}

int main(int argc, char** argv) {
  char error[256];
  roomcast_options options = {.size = sizeof(options), .name = "points.c"};
  options.hub = argc > 1 ? argv[1] : "ws://127.0.0.1:7600";
  roomcast_viewer* viewer = roomcast_connect(&options, error, sizeof(error));
  if (!viewer) {
    fprintf(stderr, "%s\n", error);
    return 1;
  }
  if (!roomcast_may_export(viewer, error, sizeof(error))) {
    fprintf(stderr, "%s\n", error);
    roomcast_disconnect(viewer);
    return 1;
  }
  int done = 0;
  for (int tries = 0; tries < 100 && !done; ++tries) {
    roomcast_frames* frames = roomcast_wait_frames(viewer, 200);
    if (!frames) continue;
    /* The first pictures of some sensors come later than those of others. */
    const size_t here = roomcast_sensor_count(frames), all = roomcast_room_sensor_count(frames);
    const size_t count = roomcast_get_points(frames, NULL, 0);
    if (count > 0 && (here == all || tries > 50)) {
      roomcast_point* points = malloc(count * sizeof(*points));
      roomcast_get_points(frames, points, count);
      done = write_ply(argc > 2 ? argv[2] : "room.ply", points, count);
      printf("%zu points of %zu of %zu sensors\n", count, here, all);
      free(points);
    }
    roomcast_free_frames(frames);
  }
  roomcast_disconnect(viewer);
  return done ? 0 : 1;
}
