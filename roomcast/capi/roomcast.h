// SPDX-License-Identifier: Apache-2.0
/* roomcast.h: live rooms in C, and with that in most other languages (libroomcast.so).
 *
 * Units are metres and nanoseconds; depth is in millimetres, 0 where there is no reading. World:
 * right-handed, y up, floor at y = 0. Sensor frames: x right, y down, z forward. Matrices are
 * row-major 4x4 and turn points of the second frame into points of the first (world_from_depth).
 * Pixel centres are at whole numbers.
 *
 * Errors: a function that can fail writes one sentence for people into `error` (cut to
 * `error_size`, always ended by a zero byte; may be NULL) and returns NULL, or 0 where it returns a
 * flag. Nothing is printed, nothing is thrown.
 *
 * Threads: functions of one roomcast_viewer or roomcast_recorder may be called from any threads at
 * the same time, except the one that ends it, which has to be the last. A roomcast_frames never
 * changes; any threads may read it until it is freed. It keeps its pictures alive also after the
 * viewer is gone.
 *
 * Versions: a later libroomcast.so.1 keeps everything that is here. Structures only grow at their
 * end; `size` tells the library how large the caller knows them, so set it to sizeof first. */
#ifndef ROOMCAST_H
#define ROOMCAST_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define ROOMCAST_API __attribute__((visibility("default")))
#else
#define ROOMCAST_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct roomcast_viewer roomcast_viewer;
typedef struct roomcast_frames roomcast_frames;
typedef struct roomcast_recorder roomcast_recorder;

/* Where the room is. Strings may be NULL for nothing. */
typedef struct roomcast_options {
  size_t size;
  const char* hub;   /* "ws://host:port" or "wss://host:port#sha256=..." */
  const char* room;  /* the hub's only one, if there is one only */
  const char* name;  /* shown to others */
  const char* token; /* where the room asks for one; or a one-time code */
} roomcast_options;

/* One sensor's newest pictures. Pointers are valid as long as the roomcast_frames. */
typedef struct roomcast_sensor {
  size_t size;
  const char* name;
  uint32_t id;
  int32_t width, height;     /* of all pictures, which are in the grid of the depth camera */
  double fx, fy, cx, cy;     /* pixels */
  double k1, k2, k3, p1, p2; /* Brown-Conrady distortion, as in OpenCV */
  double world_from_depth[16];
  int32_t placed;            /* 0: nobody knows where it stands, world_from_depth is a guess */
  uint32_t seq;              /* counts its frames */
  int64_t capture_ns;        /* room time */
  const uint16_t* depth_mm;  /* width * height */
  const uint8_t* color_rgb;  /* width * height * 3; NULL: it has no colour */
  const uint8_t* color_seen; /* width * height; 0 where the colour is made up; NULL: likewise */
} roomcast_sensor;

/* A point of the world. */
typedef struct roomcast_point {
  float x, y, z;
  uint8_t r, g, b, a; /* a: 255 */
} roomcast_point;

/* Where the viewer is. Matrices as above, from frames with x right, y up and z backwards; NULL: not
 * tracked. */
typedef struct roomcast_pose {
  size_t size;
  const double* world_from_head; /* never NULL */
  const double* world_from_left_hand;
  const double* world_from_right_hand;
} roomcast_pose;

/* "1.0.0" of this library. */
ROOMCAST_API const char* roomcast_version(void);

/* Joins a room; waits for the hub's answer. */
ROOMCAST_API roomcast_viewer* roomcast_connect(const roomcast_options* options, char* error,
                                               size_t error_size);
/* Leaves it. NULL is nothing. */
ROOMCAST_API void roomcast_disconnect(roomcast_viewer* viewer);
/* 1: connected; 0: not now (it is trying again) or no more, and why. */
ROOMCAST_API int roomcast_is_connected(roomcast_viewer* viewer, char* error, size_t error_size);

/* What the room's owner lets this viewer keep: pictures of it (recordings, videos, stills), and
 * files that other programs read (point clouds, meshes). 1: it may; 0: it may not, and why. The
 * library cannot stop a program that does not ask. */
ROOMCAST_API int roomcast_may_record(roomcast_viewer* viewer, char* error, size_t error_size);
ROOMCAST_API int roomcast_may_export(roomcast_viewer* viewer, char* error, size_t error_size);

/* The newest pictures of all sensors. Waits up to `timeout_ms` for some that are newer than those
 * of the last call; NULL when none came. */
ROOMCAST_API roomcast_frames* roomcast_wait_frames(roomcast_viewer* viewer, int timeout_ms);
ROOMCAST_API void roomcast_free_frames(roomcast_frames* frames);
ROOMCAST_API size_t roomcast_sensor_count(const roomcast_frames* frames);
/* 0 when there is no sensor of that number. */
ROOMCAST_API int roomcast_get_sensor(const roomcast_frames* frames, size_t number,
                                     roomcast_sensor* sensor);
/* Writes the points of all sensors that have been placed, at most `capacity`. Returns how many
 * there are. */
ROOMCAST_API size_t roomcast_get_points(const roomcast_frames* frames, roomcast_point* points,
                                        size_t capacity);

/* Tells the others in the room where this viewer is, who is drawn there from then on. Does not
 * wait; while there is no connection it is lost. 0: a matrix is no rigid motion, and which. */
ROOMCAST_API int roomcast_send_pose(roomcast_viewer* viewer, const roomcast_pose* pose, char* error,
                                    size_t error_size);

/* Keeps a room in an MCAP file from now on, docs/spec/recording.md; an existing file is not
 * overwritten. NULL where the room's owner does not let viewers record. */
ROOMCAST_API roomcast_recorder* roomcast_record(const roomcast_options* options, const char* path,
                                                char* error, size_t error_size);
/* 1: it goes on; 0: it had to stop, and why (a full disk). */
ROOMCAST_API int roomcast_is_recording(roomcast_recorder* recorder, char* error, size_t error_size);
/* Writes the end of the file and frees the recorder. 1: the file is whole. */
ROOMCAST_API int roomcast_stop_recording(roomcast_recorder* recorder, char* error,
                                         size_t error_size);

#ifdef __cplusplus
}
#endif

#endif /* ROOMCAST_H */
