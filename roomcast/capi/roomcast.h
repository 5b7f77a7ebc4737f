// SPDX-License-Identifier: Apache-2.0
/* roomcast.h: the C interface of libroomcast.so. It receives and records live rooms.
 *
 * Units: metres and nanoseconds; depth is in millimetres, 0 where there is no reading. World frame:
 * right-handed, y up, floor at y = 0. Sensor frames: x right, y down, z forward. Matrices are
 * row-major 4x4; a_from_b maps points of frame b to frame a (world_from_depth). Pixel centres are
 * at whole numbers.
 *
 * Errors: a function that can fail writes one readable sentence into `error` (cut to `error_size`,
 * always terminated by a zero byte; may be NULL) and returns NULL, or 0 where it returns a flag.
 * The library prints nothing and throws nothing.
 *
 * Threads: all functions of one roomcast_viewer or roomcast_recorder may be called from several
 * threads at the same time, except the function that ends it: that call must be the last. A
 * roomcast_frames is immutable: several threads may read it until it is freed. Its pictures stay
 * valid after the viewer is disconnected.
 *
 * Versions: every later libroomcast.so.1 is compatible with this header. Structures grow only at
 * their end. Set a structure's `size` to its sizeof before each call: the library reads and writes
 * at most that many bytes of it. */
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

/* The room to join. Strings may be NULL: not given. */
typedef struct roomcast_options {
  size_t size;
  const char* hub;   /* "ws://host:port" or "wss://host:port#sha256=..." */
  const char* room;  /* NULL: the hub's room, if it has only one */
  const char* name;  /* shown to the others in the room */
  const char* token; /* if the room requires one; or a one-time code */
} roomcast_options;

/* The newest pictures of one sensor. Pointers are valid until the roomcast_frames is freed. */
typedef struct roomcast_sensor {
  size_t size;
  const char* name;
  uint32_t id;
  int32_t width, height;     /* of all pictures, which share the depth camera's pixel grid */
  double fx, fy, cx, cy;     /* pixels */
  double k1, k2, k3, p1, p2; /* Brown-Conrady distortion, as in OpenCV */
  double world_from_depth[16];
  int32_t placed;            /* 0: the sensor's pose is unknown, world_from_depth is provisional */
  uint32_t seq;              /* frame number of this sensor */
  int64_t capture_ns;        /* capture time on the room clock */
  const uint16_t* depth_mm;  /* width * height */
  const uint8_t* color_rgb;  /* width * height * 3; NULL: no colour */
  const uint8_t* color_seen; /* width * height; 0: colour not measured; NULL: no colour */
} roomcast_sensor;

/* A coloured point in the world frame. */
typedef struct roomcast_point {
  float x, y, z;
  uint8_t r, g, b, a; /* a: 255 */
} roomcast_point;

/* The pose of the viewer's head and hands. Each matrix points to 16 doubles, row-major. Head and
 * hand frames: x right, y up, z backwards. NULL: not tracked. */
typedef struct roomcast_pose {
  size_t size;
  const double* world_from_head; /* required */
  const double* world_from_left_hand;
  const double* world_from_right_hand;
} roomcast_pose;

/* The version of this library, such as "1.0.0". */
ROOMCAST_API const char* roomcast_version(void);

/* Joins a room and waits for the hub's answer. */
ROOMCAST_API roomcast_viewer* roomcast_connect(const roomcast_options* options, char* error,
                                               size_t error_size);
/* Leaves the room and frees the viewer. NULL is ignored. */
ROOMCAST_API void roomcast_disconnect(roomcast_viewer* viewer);
/* 1: connected. 0: not connected (reconnecting, or ended for good); `error` says why. */
ROOMCAST_API int roomcast_is_connected(roomcast_viewer* viewer, char* error, size_t error_size);

/* Permissions granted by the room's owner. may_record: saving pictures of the room (recordings,
 * videos, stills). may_export: writing files for other programs (point clouds, meshes). 1: allowed.
 * 0: not allowed; `error` says why. The library cannot stop a program that does not ask. */
ROOMCAST_API int roomcast_may_record(roomcast_viewer* viewer, char* error, size_t error_size);
ROOMCAST_API int roomcast_may_export(roomcast_viewer* viewer, char* error, size_t error_size);

/* Returns the newest pictures of all sensors that have sent any. Waits up to `timeout_ms` for
 * pictures newer than those of the last call. NULL: none arrived. Free the result with
 * roomcast_free_frames. */
ROOMCAST_API roomcast_frames* roomcast_wait_frames(roomcast_viewer* viewer, int timeout_ms);
ROOMCAST_API void roomcast_free_frames(roomcast_frames* frames);
/* The sensors whose pictures are in `frames`, and the sensors that are sending in the room. The
 * first is smaller while pictures of some have not arrived, above all just after connecting. */
ROOMCAST_API size_t roomcast_sensor_count(const roomcast_frames* frames);
ROOMCAST_API size_t roomcast_room_sensor_count(const roomcast_frames* frames);
/* Fills `sensor`. `number` is from 0 to roomcast_sensor_count - 1. 0: there is no such sensor. */
ROOMCAST_API int roomcast_get_sensor(const roomcast_frames* frames, size_t number,
                                     roomcast_sensor* sensor);
/* Writes the points of all placed sensors, at most `capacity`. Returns the number of points there
 * are, which may be more. `points` may be NULL to get only that number. */
ROOMCAST_API size_t roomcast_get_points(const roomcast_frames* frames, roomcast_point* points,
                                        size_t capacity);

/* Sends this viewer's pose to the others in the room, who see the viewer there. Does not wait.
 * While there is no connection the pose is dropped. 0: a matrix is not a rigid transform; `error`
 * says which. */
ROOMCAST_API int roomcast_send_pose(roomcast_viewer* viewer, const roomcast_pose* pose, char* error,
                                    size_t error_size);

/* Starts recording a room to an MCAP file, format docs/spec/recording.md. An existing file is not
 * overwritten. Fails if the room's owner does not allow viewers to record. */
ROOMCAST_API roomcast_recorder* roomcast_record(const roomcast_options* options, const char* path,
                                                char* error, size_t error_size);
/* 1: recording. 0: recording has stopped; `error` says why (such as a full disk). */
ROOMCAST_API int roomcast_is_recording(roomcast_recorder* recorder, char* error, size_t error_size);
/* Completes the file and frees the recorder. 1: the file is complete. */
ROOMCAST_API int roomcast_stop_recording(roomcast_recorder* recorder, char* error,
                                         size_t error_size);

#ifdef __cplusplus
}
#endif

#endif /* ROOMCAST_H */
