// SPDX-License-Identifier: Apache-2.0
// The sizes of roomcast.h's structures and the offsets of their fields, on 64-bit machines, against
// abi.txt, and the names of its functions; tests/cli/examples.test.mjs compares these with what the
// library exports. Programs that were built against an earlier header rely on them: lines may be
// added to abi.txt where a structure grows at its end, and a size may grow; nothing else may
// change.
#include <cstddef>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "roomcast/capi/roomcast.h"

namespace {

#define ROOMCAST_SIZE(type) #type " size " << sizeof(type) << '\n'
#define ROOMCAST_FIELD(type, field) #type "." #field " " << offsetof(type, field) << '\n'

std::string layout() {
  std::ostringstream out;
  out << ROOMCAST_SIZE(roomcast_options);
  out << ROOMCAST_FIELD(roomcast_options, size);
  out << ROOMCAST_FIELD(roomcast_options, hub);
  out << ROOMCAST_FIELD(roomcast_options, room);
  out << ROOMCAST_FIELD(roomcast_options, name);
  out << ROOMCAST_FIELD(roomcast_options, token);
  out << ROOMCAST_FIELD(roomcast_options, author_key);
  out << ROOMCAST_FIELD(roomcast_options, hears);
  out << ROOMCAST_FIELD(roomcast_options, reserved);
  out << ROOMCAST_SIZE(roomcast_sensor);
  out << ROOMCAST_FIELD(roomcast_sensor, size);
  out << ROOMCAST_FIELD(roomcast_sensor, name);
  out << ROOMCAST_FIELD(roomcast_sensor, id);
  out << ROOMCAST_FIELD(roomcast_sensor, width);
  out << ROOMCAST_FIELD(roomcast_sensor, height);
  out << ROOMCAST_FIELD(roomcast_sensor, fx);
  out << ROOMCAST_FIELD(roomcast_sensor, fy);
  out << ROOMCAST_FIELD(roomcast_sensor, cx);
  out << ROOMCAST_FIELD(roomcast_sensor, cy);
  out << ROOMCAST_FIELD(roomcast_sensor, k1);
  out << ROOMCAST_FIELD(roomcast_sensor, k2);
  out << ROOMCAST_FIELD(roomcast_sensor, k3);
  out << ROOMCAST_FIELD(roomcast_sensor, p1);
  out << ROOMCAST_FIELD(roomcast_sensor, p2);
  out << ROOMCAST_FIELD(roomcast_sensor, world_from_depth);
  out << ROOMCAST_FIELD(roomcast_sensor, placed);
  out << ROOMCAST_FIELD(roomcast_sensor, seq);
  out << ROOMCAST_FIELD(roomcast_sensor, capture_ns);
  out << ROOMCAST_FIELD(roomcast_sensor, depth_mm);
  out << ROOMCAST_FIELD(roomcast_sensor, color_rgb);
  out << ROOMCAST_FIELD(roomcast_sensor, color_seen);
  out << ROOMCAST_FIELD(roomcast_sensor, capture_utc_ns);
  out << ROOMCAST_SIZE(roomcast_point);
  out << ROOMCAST_FIELD(roomcast_point, x);
  out << ROOMCAST_FIELD(roomcast_point, y);
  out << ROOMCAST_FIELD(roomcast_point, z);
  out << ROOMCAST_FIELD(roomcast_point, r);
  out << ROOMCAST_FIELD(roomcast_point, g);
  out << ROOMCAST_FIELD(roomcast_point, b);
  out << ROOMCAST_FIELD(roomcast_point, a);
  out << ROOMCAST_SIZE(roomcast_pose);
  out << ROOMCAST_FIELD(roomcast_pose, size);
  out << ROOMCAST_FIELD(roomcast_pose, world_from_head);
  out << ROOMCAST_FIELD(roomcast_pose, world_from_left_hand);
  out << ROOMCAST_FIELD(roomcast_pose, world_from_right_hand);
  out << ROOMCAST_SIZE(roomcast_camera);
  out << ROOMCAST_FIELD(roomcast_camera, size);
  out << ROOMCAST_FIELD(roomcast_camera, width);
  out << ROOMCAST_FIELD(roomcast_camera, height);
  out << ROOMCAST_FIELD(roomcast_camera, fx);
  out << ROOMCAST_FIELD(roomcast_camera, fy);
  out << ROOMCAST_FIELD(roomcast_camera, cx);
  out << ROOMCAST_FIELD(roomcast_camera, cy);
  out << ROOMCAST_FIELD(roomcast_camera, k1);
  out << ROOMCAST_FIELD(roomcast_camera, k2);
  out << ROOMCAST_FIELD(roomcast_camera, k3);
  out << ROOMCAST_FIELD(roomcast_camera, p1);
  out << ROOMCAST_FIELD(roomcast_camera, p2);
  out << ROOMCAST_SIZE(roomcast_sensor_options);
  out << ROOMCAST_FIELD(roomcast_sensor_options, size);
  out << ROOMCAST_FIELD(roomcast_sensor_options, depth);
  out << ROOMCAST_FIELD(roomcast_sensor_options, color);
  out << ROOMCAST_FIELD(roomcast_sensor_options, color_from_depth);
  out << ROOMCAST_FIELD(roomcast_sensor_options, world_from_depth);
  out << ROOMCAST_FIELD(roomcast_sensor_options, fps);
  out << ROOMCAST_FIELD(roomcast_sensor_options, depth_mode);
  out << ROOMCAST_FIELD(roomcast_sensor_options, depth_bound_mm);
  out << ROOMCAST_FIELD(roomcast_sensor_options, color_kbit_per_s);
  out << ROOMCAST_FIELD(roomcast_sensor_options, reserved);
  out << ROOMCAST_FIELD(roomcast_sensor_options, send_unwatched);
  out << ROOMCAST_SIZE(roomcast_capture);
  out << ROOMCAST_FIELD(roomcast_capture, size);
  out << ROOMCAST_FIELD(roomcast_capture, capture_ns);
  out << ROOMCAST_FIELD(roomcast_capture, depth_mm);
  out << ROOMCAST_FIELD(roomcast_capture, depth_width);
  out << ROOMCAST_FIELD(roomcast_capture, depth_height);
  out << ROOMCAST_FIELD(roomcast_capture, color_rgb);
  out << ROOMCAST_FIELD(roomcast_capture, color_width);
  out << ROOMCAST_FIELD(roomcast_capture, color_height);
  out << ROOMCAST_SIZE(roomcast_send_report);
  out << ROOMCAST_FIELD(roomcast_send_report, size);
  out << ROOMCAST_FIELD(roomcast_send_report, sent);
  out << ROOMCAST_FIELD(roomcast_send_report, connected);
  out << ROOMCAST_FIELD(roomcast_send_report, frames_waiting);
  out << ROOMCAST_FIELD(roomcast_send_report, max_frames_waiting);
  out << ROOMCAST_FIELD(roomcast_send_report, seq);
  out << ROOMCAST_FIELD(roomcast_send_report, capture_ns);
  out << ROOMCAST_FIELD(roomcast_send_report, frames_sent);
  out << ROOMCAST_FIELD(roomcast_send_report, frames_skipped);
  out << ROOMCAST_FIELD(roomcast_send_report, bytes_sent);
  out << ROOMCAST_FIELD(roomcast_send_report, rate_share);
  out << ROOMCAST_SIZE(roomcast_person);
  out << ROOMCAST_FIELD(roomcast_person, size);
  out << ROOMCAST_FIELD(roomcast_person, id);
  out << ROOMCAST_FIELD(roomcast_person, r);
  out << ROOMCAST_FIELD(roomcast_person, g);
  out << ROOMCAST_FIELD(roomcast_person, b);
  out << ROOMCAST_FIELD(roomcast_person, a);
  out << ROOMCAST_FIELD(roomcast_person, name);
  out << ROOMCAST_FIELD(roomcast_person, is_self);
  out << ROOMCAST_FIELD(roomcast_person, speaking);
  out << ROOMCAST_FIELD(roomcast_person, muted);
  out << ROOMCAST_FIELD(roomcast_person, has_head);
  out << ROOMCAST_FIELD(roomcast_person, has_left_hand);
  out << ROOMCAST_FIELD(roomcast_person, has_right_hand);
  out << ROOMCAST_FIELD(roomcast_person, world_from_head);
  out << ROOMCAST_FIELD(roomcast_person, world_from_left_hand);
  out << ROOMCAST_FIELD(roomcast_person, world_from_right_hand);
  out << ROOMCAST_SIZE(roomcast_mark);
  out << ROOMCAST_FIELD(roomcast_mark, size);
  out << ROOMCAST_FIELD(roomcast_mark, id);
  out << ROOMCAST_FIELD(roomcast_mark, kind);
  out << ROOMCAST_FIELD(roomcast_mark, points);
  out << ROOMCAST_FIELD(roomcast_mark, point_count);
  out << ROOMCAST_FIELD(roomcast_mark, text);
  out << ROOMCAST_FIELD(roomcast_mark, author);
  out << ROOMCAST_FIELD(roomcast_mark, r);
  out << ROOMCAST_FIELD(roomcast_mark, g);
  out << ROOMCAST_FIELD(roomcast_mark, b);
  out << ROOMCAST_FIELD(roomcast_mark, a);
  out << ROOMCAST_FIELD(roomcast_mark, own);
  out << ROOMCAST_SIZE(roomcast_voice);
  out << ROOMCAST_FIELD(roomcast_voice, size);
  out << ROOMCAST_FIELD(roomcast_voice, samples);
  out << ROOMCAST_FIELD(roomcast_voice, opus);
  out << ROOMCAST_FIELD(roomcast_voice, opus_bytes);
  out << ROOMCAST_FIELD(roomcast_voice, speaker);
  out << ROOMCAST_FIELD(roomcast_voice, seq);
  out << ROOMCAST_FIELD(roomcast_voice, ends);
  out << ROOMCAST_FIELD(roomcast_voice, has_head);
  out << ROOMCAST_FIELD(roomcast_voice, capture_ns);
  out << ROOMCAST_FIELD(roomcast_voice, world_from_head);
  out << ROOMCAST_SIZE(roomcast_placement);
  out << ROOMCAST_FIELD(roomcast_placement, size);
  out << ROOMCAST_FIELD(roomcast_placement, world_from_depth);
  out << ROOMCAST_FIELD(roomcast_placement, expected_error_mm);
  out << ROOMCAST_SIZE(roomcast_nudge);
  out << ROOMCAST_FIELD(roomcast_nudge, size);
  out << ROOMCAST_FIELD(roomcast_nudge, shift_m);
  out << ROOMCAST_FIELD(roomcast_nudge, turn_rad);
  out << ROOMCAST_FIELD(roomcast_nudge, tilt_rad);
  return out.str();
}

std::string text_of(const std::string& name) {
  std::ifstream file(ROOMCAST_SOURCE_DIR "/roomcast/capi/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The functions of roomcast.h in its order.
std::string functions() {
  const std::string header = text_of("roomcast.h");
  const std::regex declaration(R"(\nROOMCAST_API [^(]*?(roomcast_\w+)\()");
  std::string out;
  for (std::sregex_iterator it(header.begin(), header.end(), declaration), end; it != end; ++it)
    out += (*it)[1].str() + "()\n";
  return out;
}

TEST(Abi, no_function_or_structure_changes_silently) {
  if (sizeof(void*) != 8) GTEST_SKIP() << "abi.txt is of 64-bit machines";
  EXPECT_EQ(functions() + layout(), text_of("abi.txt"))
      << "structures may only grow at their end; see abi_test.cpp";
}

}  // namespace
