// SPDX-License-Identifier: Apache-2.0
/* roomcast.h: the C interface of libroomcast.so. It receives and records live rooms, sends a
 * sensor's frames into them, and reads recordings.
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
 * Threads: all functions of one roomcast_viewer, roomcast_publisher, roomcast_recorder or
 * roomcast_reader may be called from several threads at the same time, except the function that
 * ends it: that call must be the last. Different ones are independent of each other. A
 * roomcast_frames is immutable: several threads may read it until it is freed. Its pictures stay
 * valid after the viewer is disconnected. Memory that a caller passes in is read or written during
 * the call only.
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
typedef struct roomcast_publisher roomcast_publisher;
typedef struct roomcast_reader roomcast_reader;

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
  int64_t capture_utc_ns;    /* capture time since 1970-01-01 UTC by this machine's clock as it was
                                when the viewer connected. Since 1.4.0 */
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

/* ---- Being a sensor: since 1.2.0 ---- */

/* The clock of roomcast_capture.capture_ns: this machine's CLOCK_MONOTONIC, in nanoseconds. */
ROOMCAST_API int64_t roomcast_host_time_ns(void);

/* A pinhole camera with Brown-Conrady distortion, as in OpenCV. */
typedef struct roomcast_camera {
  size_t size;
  int32_t width, height; /* pixels; of a depth camera 16 to 4096, of a colour camera 2 to 8192 */
  double fx, fy, cx, cy; /* pixels */
  double k1, k2, k3, p1, p2; /* 0: no distortion */
} roomcast_camera;

/* Values of roomcast_sensor_options.depth_mode. */
#define ROOMCAST_DEPTH_LIVE 0          /* few bytes: the sensor's noise is not sent */
#define ROOMCAST_DEPTH_NEAR_LOSSLESS 1 /* every reading within depth_bound_mm */
#define ROOMCAST_DEPTH_LOSSLESS 2      /* every reading exact */

/* A sensor: its cameras, where it is, and how its frames are encoded. Only `depth` is required; all
 * else may be 0 or NULL. Matrices point to 16 doubles. */
typedef struct roomcast_sensor_options {
  size_t size;
  const roomcast_camera* depth;
  const roomcast_camera* color;   /* NULL: colour, if any, comes in the depth camera's pixel grid */
  const double* color_from_depth; /* NULL: both cameras are at the same place */
  const double* world_from_depth; /* the sensor's pose; NULL: unknown */
  double fps;                     /* frames a second, above 0 to 240; 0: 30 */
  int32_t depth_mode;             /* ROOMCAST_DEPTH_... */
  int32_t depth_bound_mm;         /* near-lossless: 1 to 63; 0: 2 */
  int32_t color_kbit_per_s;       /* 50 to 100000; 0: 790 */
  int32_t reserved;               /* not read */
  int32_t send_unwatched;         /* 1: send while nobody watches, too; 0: do not. Since 1.3.0 */
} roomcast_sensor_options;

/* One frame. Pictures have rows without gaps and the sizes of the sensor's cameras. */
typedef struct roomcast_capture {
  size_t size;
  int64_t capture_ns;       /* as roomcast_host_time_ns: up to 10 s ago; 0: now */
  const uint16_t* depth_mm; /* required; aligned to 2 bytes */
  int32_t depth_width, depth_height;
  const uint8_t* color_rgb; /* 3 bytes for each pixel; NULL: no colour in this frame */
  int32_t color_width, color_height;
} roomcast_capture;

/* The result of roomcast_send_frame(), and the state of the connection. */
typedef struct roomcast_send_report {
  size_t size;
  int32_t sent;      /* 1: on its way. 0: skipped, because nobody watches the room, because the
                        network does not keep up, or because there is no connection (or no
                        room time yet, just after connecting) */
  int32_t connected; /* 0: the library is reconnecting */
  uint32_t frames_waiting;     /* frames that are not on the network yet */
  uint32_t max_frames_waiting; /* with so many waiting, the next one is skipped */
  uint32_t seq;                /* of a frame that was sent: its number, as in roomcast_sensor */
  int64_t capture_ns;          /* and its capture time on the room clock, as in roomcast_sensor */
  uint64_t frames_sent;        /* these three: since roomcast_publish() */
  uint64_t frames_skipped;     /* without those that nobody would have watched */
  uint64_t bytes_sent;
  double rate_share; /* of the full colour rate, what the network carries: 0 to 1 */
} roomcast_send_report;

/* Joins a room as a sensor and waits for the hub's answer. options->name, required, is the sensor's
 * identity: a sensor that comes back under its name keeps its ID and, if it was placed, its pose.
 * Where the connection breaks later, the library reconnects. */
ROOMCAST_API roomcast_publisher* roomcast_publish(const roomcast_options* options,
                                                  const roomcast_sensor_options* sensor,
                                                  char* error, size_t error_size);
/* Encodes and sends one frame, or skips it if nobody watches, or if earlier frames still wait for
 * the network (so that delay does not grow); it does not wait for the network. Takes as long as
 * encoding takes. `report` may be NULL. 1: sent or skipped; `report` says which. 0: the frame is
 * not as described above, it is larger than a hub takes (2 MiB when encoded), or the connection has
 * ended for good; `error` says why. */
ROOMCAST_API int roomcast_send_frame(roomcast_publisher* publisher, const roomcast_capture* capture,
                                     roomcast_send_report* report, char* error, size_t error_size);
/* 1: connected. 0: not connected (reconnecting, or ended for good); `error` says why. */
ROOMCAST_API int roomcast_is_publishing(roomcast_publisher* publisher, char* error,
                                        size_t error_size);
/* Leaves the room and frees the publisher. Frames that still wait may be lost. NULL is ignored. */
ROOMCAST_API void roomcast_stop_publishing(roomcast_publisher* publisher);

/* ---- Reading recordings, without a hub: since 1.5.0 ---- */

/* Opens a recording: FILE.mcap of roomcast, or the folder of a rig or of a TUM RGB-D recording.
 * `roomcast import` turns recordings of other programs into rigs. */
ROOMCAST_API roomcast_reader* roomcast_open(const char* path, char* error, size_t error_size);
/* The next frame set: the pictures of all sensors at one instant, one that missed it with its last
 * ones. Here capture_ns counts from the recording's beginning, and capture_utc_ns is 0 if the
 * recording does not tell the time of day. NULL: the end, where `error` becomes empty, or a damaged
 * place, which `error` describes; where possible the next call goes on behind it. Free the result
 * with roomcast_free_frames, also after the reader is closed. */
ROOMCAST_API roomcast_frames* roomcast_next_frames(roomcast_reader* reader, char* error,
                                                   size_t error_size);
/* The sensors of the recording, whose calibration is known before the first pictures: fills
 * `sensor` without pictures and pose. 0: there is no such sensor. */
ROOMCAST_API size_t roomcast_recorded_sensor_count(roomcast_reader* reader);
ROOMCAST_API int roomcast_get_recorded_sensor(roomcast_reader* reader, size_t number,
                                              roomcast_sensor* sensor);
/* 0: unknown. */
ROOMCAST_API int64_t roomcast_recorded_length_ns(roomcast_reader* reader);
/* As roomcast_may_export, of the room when it was recorded. */
ROOMCAST_API int roomcast_may_export_recorded(roomcast_reader* reader, char* error,
                                              size_t error_size);
/* Closes the recording and frees the reader. NULL is ignored. */
ROOMCAST_API void roomcast_close(roomcast_reader* reader);

#ifdef __cplusplus
}
#endif

#endif /* ROOMCAST_H */
