// SPDX-License-Identifier: Apache-2.0
/* roomcast.h: the C interface of libroomcast.so. It receives and records live rooms, sends a
 * sensor's frames into them, takes part in what people do there (heads, voices, marks), and reads
 * recordings.
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
 * roomcast_frames and a roomcast_people are immutable: several threads may read them until they are
 * freed, also after the viewer is disconnected. Memory that a caller passes in is read or written
 * during the call only. Packets of voices go to one of the threads that wait for them.
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
typedef struct roomcast_people roomcast_people;

/* The room to join. Strings may be NULL: not given. */
typedef struct roomcast_options {
  size_t size;
  const char* hub;        /* "ws://host:port" or "wss://host:port#sha256=..." */
  const char* room;       /* NULL: the hub's room, if it has only one */
  const char* name;       /* shown to the others in the room */
  const char* token;      /* if the room requires one; or a one-time code */
  const char* author_key; /* a secret of the program, by which the marks that it leaves are its own
                             later, too, at most 64 bytes; NULL: a new one. Since 1.6.0 */
  int32_t hears;          /* 1: gets people's voices (roomcast_next_voice). Since 1.6.0 */
  int32_t reserved;       /* not read */
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

/* ---- People and marks: since 1.6.0 ---- */

/* The people in the room and what they have left there, at one moment. Waits up to `timeout_ms`
 * until something of it differs from `known`, an earlier result, which stays valid; returns at once
 * where `known` is NULL. NULL: nothing has changed. Without a connection there are no people. Free
 * the result with roomcast_free_people. */
ROOMCAST_API roomcast_people* roomcast_wait_people(roomcast_viewer* viewer,
                                                   const roomcast_people* known, int timeout_ms);
ROOMCAST_API void roomcast_free_people(roomcast_people* people);

/* A person in the room. Head and hand frames as in roomcast_pose. */
typedef struct roomcast_person {
  size_t size;
  uint32_t id;        /* the speaker's in roomcast_voice */
  uint8_t r, g, b, a; /* the person's colour for everybody; a: 255 */
  const char* name;   /* valid until the roomcast_people is freed; may be empty */
  int32_t is_self;    /* 1: this viewer */
  int32_t speaking;   /* known to viewers that hear, as the next one */
  int32_t muted;      /* by an admin */
  int32_t has_head, has_left_hand, has_right_hand; /* 0: not known, and its matrix is all 0 */
  double world_from_head[16], world_from_left_hand[16], world_from_right_hand[16];
} roomcast_person;

ROOMCAST_API size_t roomcast_person_count(const roomcast_people* people);
/* Fills `person`. 0: there is no such person. */
ROOMCAST_API int roomcast_get_person(const roomcast_people* people, size_t number,
                                     roomcast_person* person);

/* Values of roomcast_mark.kind. */
#define ROOMCAST_MARK_NOTE 1     /* words at a point */
#define ROOMCAST_MARK_SKETCH 2   /* a line of 2 to 512 points; no words */
#define ROOMCAST_MARK_DISTANCE 3 /* between two points; no words */
#define ROOMCAST_MARK_PLACE 4    /* a name, where somebody stands, and what they look at */

/* A note, sketch, distance or place that a person has left in the room; everybody sees it. Pointers
 * are valid until the roomcast_people is freed. */
typedef struct roomcast_mark {
  size_t size;
  uint32_t id;
  int32_t kind;        /* ROOMCAST_MARK_... */
  const float* points; /* x, y, z of each in the world frame */
  size_t point_count;
  const char* text; /* of a note, at most 280 bytes, and a place, at most 64; else NULL or empty */
  const char* author; /* who left it; may be empty */
  uint8_t r, g, b, a; /* the author's colour; a: 255 */
  int32_t own;        /* 1: this viewer may remove it. An admin may remove all */
} roomcast_mark;

/* All marks, in the order in which they were left. */
ROOMCAST_API size_t roomcast_mark_count(const roomcast_people* people);
/* Fills `mark`. 0: there is no such mark. */
ROOMCAST_API int roomcast_get_mark(const roomcast_people* people, size_t number,
                                   roomcast_mark* mark);
/* Leaves a mark, of which kind, points and text count, and waits for the hub's answer, at most 5 s.
 * `id` gets its ID; may be NULL. 0: it was not left; `error` says why. */
ROOMCAST_API int roomcast_leave_mark(roomcast_viewer* viewer, const roomcast_mark* mark,
                                     uint32_t* id, char* error, size_t error_size);
/* Likewise. 0: it is still there, or never was. */
ROOMCAST_API int roomcast_remove_mark(roomcast_viewer* viewer, uint32_t id, char* error,
                                      size_t error_size);

/* ---- Voices: since 1.6.0 ---- */

#define ROOMCAST_VOICE_RATE_HZ 48000      /* of all samples, which are of one channel, -1 to 1 */
#define ROOMCAST_VOICE_SAMPLES 960        /* of one packet: 20 ms */
#define ROOMCAST_VOICE_MAX_BYTES 1275     /* of one packet in Opus (RFC 6716) */
#define ROOMCAST_VOICE_SENSOR 0x80000000u /* of a speaker: it is this plus a sensor's ID */

/* 20 ms of somebody's voice, or of the sound at a sensor that has a microphone. The caller sets the
 * first two pointers. */
typedef struct roomcast_voice {
  size_t size;
  float* samples;     /* gets ROOMCAST_VOICE_SAMPLES samples; NULL: not wanted */
  uint8_t* opus;      /* gets at most ROOMCAST_VOICE_MAX_BYTES; NULL: not wanted */
  size_t opus_bytes;  /* 0: this packet was lost on its way, and `samples` conceals that */
  uint32_t speaker;   /* a person's ID, or ROOMCAST_VOICE_SENSOR plus a sensor's */
  uint32_t seq;       /* counts the speaker's packets */
  int32_t ends;       /* 1: the speaker pauses after it */
  int32_t has_head;   /* 0: where the speaker is is not known */
  int64_t capture_ns; /* of the first sample, on the room clock */
  double
      world_from_head[16]; /* where the speaker is now, as in roomcast_person; of a sensor, too */
} roomcast_voice;

/* The next packet of somebody's voice, for a viewer that joined with `hears`. Packets come as the
 * network delivers them, those of each speaker in their order: a program that plays them keeps some
 * 60 ms in stock. A second of what is not fetched is kept. 0: none came within `timeout_ms`, or
 * the connection has ended for good. */
ROOMCAST_API int roomcast_next_voice(roomcast_viewer* viewer, int timeout_ms,
                                     roomcast_voice* voice);
/* 1: the room's owner lets this viewer speak. 0: not; `error` says why. */
ROOMCAST_API int roomcast_may_speak(roomcast_viewer* viewer, char* error, size_t error_size);
/* Says this to the others in the room: what has been recorded since the last call, up to one second
 * and not faster than real time. It goes out in packets of 20 ms; what is left over waits for the
 * next call. Does not wait. Without a connection it is lost. 0: it was not said; `error` says
 * why. */
ROOMCAST_API int roomcast_speak(roomcast_viewer* viewer, const float* samples, size_t count,
                                char* error, size_t error_size);
/* Says what is left over, and that a pause follows. */
ROOMCAST_API void roomcast_pause_speaking(roomcast_viewer* viewer);

/* ---- Placing sensors: since 1.6.0 ---- */

/* Where a sensor stands after it was placed. */
typedef struct roomcast_placement {
  size_t size;
  double world_from_depth[16];
  double expected_error_mm; /* 2.5 m ahead of the sensor; 0: not known */
} roomcast_placement;

/* Proposes a pose for the sensor of this name; the room's aligner refines it and accepts it, or
 * refuses it with a reason. Takes a viewer that joined with an admin's token, a sensor that did not
 * supply its own pose, and up to 20 s. `placement` gets the refined pose; may be NULL. 0: not
 * placed; `error` says why. */
ROOMCAST_API int roomcast_place_sensor(roomcast_viewer* viewer, const char* sensor,
                                       const double* world_from_depth,
                                       roomcast_placement* placement, char* error,
                                       size_t error_size);
/* How a sensor is to be moved: tilted and turned about its own position, then shifted. */
typedef struct roomcast_nudge {
  size_t size;
  double shift_m[3]; /* along the world's axes */
  double turn_rad;   /* counter-clockwise as seen from above */
  double tilt_rad;   /* upwards, about the sensor's own horizontal axis */
} roomcast_nudge;
/* As roomcast_place_sensor(), from where the sensor stands. */
ROOMCAST_API int roomcast_nudge_sensor(roomcast_viewer* viewer, const char* sensor,
                                       const roomcast_nudge* nudge, roomcast_placement* placement,
                                       char* error, size_t error_size);

#ifdef __cplusplus
}
#endif

#endif /* ROOMCAST_H */
