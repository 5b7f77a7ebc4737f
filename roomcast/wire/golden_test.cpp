// SPDX-License-Identifier: Apache-2.0
// tests/golden/wire.json lists messages with their meaning; the browser's tests read the same
// files. To add a message, add it to golden_messages() and run this test once with
// ROOMCAST_UPDATE_GOLDEN=1.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/control.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::wire {
namespace {

using nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

struct GoldenMessage {
  std::string name;
  Bytes bytes;
  json meaning;
};

json json_from(const FrameHeader& h) {
  return {{"key", h.key},
          {"last", h.last},
          {"small", h.small},
          {"sensor", h.sensor.value},
          {"layer", h.layer},
          {"codec", h.codec},
          {"seq", h.seq},
          {"set_id", std::to_string(h.set.value)},
          {"capture_ns", std::to_string(h.capture_time.time_since_epoch().count())},
          {"clock_error_us", h.clock_error_us},
          {"base_seq", h.base_seq},
          {"payload_length", h.payload_length},
          {"header_length", h.header_length}};
}

GoldenMessage golden_frame(std::string name, FrameHeader header, const Bytes& payload) {
  header.payload_length = static_cast<std::uint32_t>(payload.size());
  Bytes message(kFrameHeaderBytes);
  write_frame_header(header, std::span(message).first<kFrameHeaderBytes>());
  message.insert(message.end(), payload.begin(), payload.end());
  return {std::move(name), std::move(message), {{"frame", json_from(header)}}};
}

json json_from(const AudioHeader& h) {
  return {{"ends", h.ends},
          {"speaker", h.speaker.value},
          {"seq", h.seq},
          {"capture_ns", std::to_string(h.capture_time.time_since_epoch().count())},
          {"codec", h.codec},
          {"payload_length", h.payload_length},
          {"header_length", h.header_length}};
}

GoldenMessage golden_audio(std::string name, AudioHeader header, const Bytes& payload) {
  header.payload_length = static_cast<std::uint16_t>(payload.size());
  Bytes message(kAudioHeaderBytes);
  write_audio_header(header, std::span(message).first<kAudioHeaderBytes>());
  message.insert(message.end(), payload.begin(), payload.end());
  return {std::move(name), std::move(message), {{"audio", json_from(header)}}};
}

GoldenMessage golden_control(std::string name, const std::string& json_text) {
  pb::Control control;
  EXPECT_TRUE(google::protobuf::util::JsonStringToMessage(json_text, &control).ok()) << name;
  Bytes message;
  encode_control(control, message);
  return {std::move(name), std::move(message), {{"control", json::parse(json_text)}}};
}

GoldenMessage golden_refusal(std::string name, Bytes bytes, std::string why) {
  return {std::move(name), std::move(bytes), {{"refused", std::move(why)}}};
}

/// Since audio exists; messages before it stay as they were.
void add_voice_messages(std::vector<GoldenMessage>& messages) {
  const AudioHeader spoken{.speaker = ViewerId{9},
                           .seq = 0xFFFFFFFF,
                           .capture_time = RoomTime(nanoseconds(1'234'567'890'123))};
  AudioHeader last = spoken;
  last.ends = true;
  last.speaker = {};
  last.seq = 0;
  const GoldenMessage whole = golden_audio("audio", spoken, {0x78, 1, 2, 3});
  messages.push_back(whole);
  messages.push_back(golden_audio("audio_ends", last, {0x78}));
  messages.push_back(
      golden_control("control_join_hears", R"({"join":{"name":"Ada","viewer":{"hears":true}}})"));
  messages.push_back(golden_control(
      "control_join_plays",
      R"({"join":{"room":"lab","name":"Ada","viewer":{"hears":true,"plays":"monday"}}})"));
  messages.push_back(golden_control(
      "control_welcome_may_speak",
      R"({"welcome":{"room":"lab","viewerId":9,"hubVersion":"0.1.0","maySpeak":true}})"));
  messages.push_back(
      golden_control("control_voices", R"({"voices":{"speaking":[9,11],"muted":[12]}})"));
  Bytes bad = whole.bytes;
  bad.pop_back();
  messages.push_back(golden_refusal("refused_truncated_audio", bad, "length"));
  bad = golden_audio("", last, {}).bytes;
  messages.push_back(golden_refusal("refused_empty_audio", bad, "payload"));
  bad = golden_audio("", last, Bytes(kMaxAudioPayloadBytes + 1)).bytes;
  messages.push_back(golden_refusal("refused_large_audio", bad, "payload"));
}

/// Since hubs leave out what a viewer cannot see.
void add_visibility_messages(std::vector<GoldenMessage>& messages) {
  messages.push_back(golden_control(
      "control_viewer_pose_angle",
      R"({"viewerPose":{"head":{"x":1.5,"y":1.75,"z":-2,"qw":1},"viewHalfAngle":0.75}})"));
  messages.push_back(
      golden_control("control_coarse_depth",
                     R"({"coarseDepth":{"columns":2,"rows":1,"nearCm":[120,0],"farCm":[300,0]}})"));
  messages.push_back(golden_control("control_unseen_sensors",
                                    R"({"unseenSensors":{"baseOnly":[1],"paused":[0,300]}})"));
  messages.push_back(golden_control(
      "control_frame_demand",
      R"({"frameDemand":{"wanted":true,"unseen":true,"baseOnly":true,"mbit":1.5}})"));
  messages.push_back(
      golden_control("control_set_end", R"({"setEnd":{"setId":"18446744073709551615"}})"));
}

/// Added after the settings, so that the files before them stay as they were.
void add_view_messages(std::vector<GoldenMessage>& messages) {
  messages.push_back(golden_control(
      "control_watched_from",
      R"({"watchedFrom":{"cones":[{"eye":{"x":0.5,"y":-1.5,"z":2},"forward":{"z":-1},"halfAngle":0.75}]}})"));
}

/// Since sensors may send a small rendition.
void add_rendition_messages(std::vector<GoldenMessage>& messages, FrameHeader header) {
  header.small = true;
  messages.push_back(golden_frame("frame_small", header, {1, 2}));
  messages.push_back(golden_control("control_frame_demand_small",
                                    R"({"frameDemand":{"wanted":true,"small":true}})"));
  messages.push_back(
      golden_control("control_key_request_small", R"({"keyRequest":{"sensorId":3,"small":true}})"));
}

/// Since views have sides, and sensors are held back.
void add_line_messages(std::vector<GoldenMessage>& messages) {
  messages.push_back(golden_control(
      "control_viewer_pose_sides",
      R"({"viewerPose":{"head":{"x":1.5,"y":1.75,"z":-2,"qw":1},"viewHalfAngle":0.75,"viewHalfWidth":0.625,"viewHalfHeight":0.5}})"));
  messages.push_back(golden_control(
      "control_watched_from_sides",
      R"({"watchedFrom":{"cones":[{"eye":{"x":0.5},"forward":{"z":-1},"halfAngle":0.75,"up":{"y":1},"halfWidth":0.625,"halfHeight":0.5}]}})"));
  messages.push_back(
      golden_control("control_unseen_sensors_held_back",
                     R"({"unseenSensors":{"baseOnly":[1,2],"paused":[0],"heldBack":[2]}})"));
}

void add_settings_messages(std::vector<GoldenMessage>& messages) {
  messages.push_back(golden_control(
      "control_settings_request",
      R"({"settingsRequest":{"number":7,"settings":{"codec":"live","mbit":2.5,"fitsLine":false},"restart":true}})"));
  messages.push_back(golden_control("control_settings_answer",
                                    R"({"settingsAnswer":{"number":7,"refusal":"not now"}})"));
}

std::vector<GoldenMessage> golden_messages() {
  FrameHeader key{.key = true,
                  .sensor = SensorId{3},
                  .seq = 7,
                  .set = SetId{1ull << 60},
                  .capture_time = RoomTime(nanoseconds(1'234'567'890'123)),
                  .clock_error_us = 180,
                  .base_seq = 7};
  FrameHeader droppable{.last = true,
                        .sensor = SensorId{0xFFFF},
                        .layer = 1,
                        .seq = 0xFFFFFFFF,
                        .set = SetId{42},
                        .capture_time = RoomTime(nanoseconds(-5)),
                        .base_seq = 0xFFFFFFFE};
  const std::string camera =
      R"({"width":512,"height":424,"fx":364.6,"fy":364.65,"cx":256.01,"cy":206.67,"k1":0.0868,"k2":-0.2606,"k3":0.1,"p1":-0.0001,"p2":0.0001})";
  const std::string identity = "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]";
  const std::string calibration = R"({"depth":)" + camera + R"(,"color":)" + camera +
                                  R"(,"colorFromDepth":)" + identity +
                                  R"(,"colorIsRegistered":true})";
  std::vector<GoldenMessage> messages = {
      golden_frame("frame_key", key, {1, 2, 3, 4, 5}),
      golden_frame("frame_droppable", droppable, {}),
      golden_control("control_join_sensor",
                     R"({"join":{"name":"s0","sensor":{"fps":30,"calibration":)" + calibration +
                         R"(,"worldFromDepth":)" + identity + "}}}"),
      golden_control("control_join_viewer",
                     R"({"join":{"room":"lab","name":"Émilie","viewer":{}}})"),
      golden_control("control_welcome", R"({"welcome":{"room":"lab","viewerId":9,"startPose":)" +
                                            identity + R"(,"hubVersion":"0.1.0"}})"),
      golden_control(
          "control_roster",
          R"({"roster":{"revision":3,"fps":30,"sensors":[{"id":1,"name":"s0","online":true,"fps":30,"calibration":)" +
              calibration + R"(,"worldFromDepth":)" + identity +
              R"(,"placement":"PLACEMENT_GIVEN"}],"viewers":[{"id":9,"name":"Émilie","colorRgb":16744448}]}})"),
      golden_control("control_clock_pong",
                     R"({"clockPong":{"clientNs":"18446744073709551615","hubNs":"5"}})"),
      golden_control(
          "control_viewer_poses",
          R"({"viewerPoses":{"poses":[{"viewerId":9,"head":{"x":1.5,"y":1.75,"z":-2,"qw":1}}]}})"),
      golden_control("control_error",
                     R"({"error":{"code":"ERROR_REPLACED","sentence":"replaced"}})"),
      golden_control("control_join_author",
                     R"({"join":{"room":"lab","viewer":{"authorKey":"c2VjcmV0"}}})"),
      golden_control("control_welcome_author",
                     R"({"welcome":{"room":"lab","viewerId":9,"startPose":)" + identity +
                         R"(,"mayMark":true,"authorTag":"18446744073709551615"}})"),
      golden_control(
          "control_marks",
          R"({"marks":{"all":true,"marks":[{"id":7,"kind":"MARK_KIND_NOTE","points":[1.5,0.75,-2],"text":"mind the step","author":"Émilie","colorRgb":16744448,"authorTag":"5"},{"id":8,"kind":"MARK_KIND_SKETCH","points":[0,0,0,0.5,0,0]}],"removed":[3],"refusal":"no"}})"),
      golden_control("control_guide", R"({"guide":{"on":true,"viewerId":9}})"),
  };
  Bytes bad = messages[0].bytes;
  bad[0] = 'X';
  messages.push_back(golden_refusal("refused_magic", bad, "magic"));
  bad = messages[0].bytes;
  bad[2] = 2;
  messages.push_back(golden_refusal("refused_version", bad, "version"));
  bad = messages[0].bytes;
  bad.pop_back();
  messages.push_back(golden_refusal("refused_truncated_payload", bad, "length"));
  bad = messages[0].bytes;
  bad[10] = 8;
  messages.push_back(golden_refusal("refused_layer", bad, "layer"));
  bad = messages[3].bytes;
  bad.pop_back();
  messages.push_back(golden_refusal("refused_truncated_control", bad, "protobuf"));
  add_voice_messages(messages);
  add_visibility_messages(messages);
  add_settings_messages(messages);
  add_view_messages(messages);
  add_rendition_messages(messages, key);
  add_line_messages(messages);
  return messages;
}

std::filesystem::path golden_path(const std::string& name) {
  return std::filesystem::path(ROOMCAST_GOLDEN_DIR) / name;
}

Bytes read_bytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_golden_files() {
  std::filesystem::create_directories(ROOMCAST_GOLDEN_DIR);
  json index = json::array();
  for (const auto& message : golden_messages()) {
    json entry = message.meaning;
    entry["file"] = "wire_" + message.name + ".bin";
    std::ofstream(golden_path(entry["file"]), std::ios::binary)
        .write(reinterpret_cast<const char*>(message.bytes.data()),
               static_cast<std::streamsize>(message.bytes.size()));
    index.push_back(std::move(entry));
  }
  std::ofstream(golden_path("wire.json")) << index.dump(1) << "\n";
}

bool is_accepted(const Bytes& bytes) {
  const auto type = message_type(bytes);
  if (!type) return false;
  if (*type == MessageType::kFrame) return parse_frame(bytes).ok();
  if (*type == MessageType::kAudio) return parse_audio(bytes).ok();
  return decode_control(bytes, Sender::kHub).ok();
}

TEST(WireGolden, every_message_is_written_and_read_as_the_files_say) {
  if (std::getenv("ROOMCAST_UPDATE_GOLDEN") != nullptr) write_golden_files();
  const json index = json::parse(std::ifstream(golden_path("wire.json")));
  const auto messages = golden_messages();
  ASSERT_EQ(index.size(), messages.size());
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const Bytes bytes = read_bytes(golden_path(index[i]["file"]));
    EXPECT_EQ(bytes, messages[i].bytes) << messages[i].name;
    EXPECT_EQ(is_accepted(bytes), !index[i].contains("refused")) << messages[i].name;
    if (index[i].contains("frame")) {
      EXPECT_EQ(json_from(*parse_frame(bytes)), index[i]["frame"]) << messages[i].name;
    }
    if (index[i].contains("audio")) {
      EXPECT_EQ(json_from(*parse_audio(bytes)), index[i]["audio"]) << messages[i].name;
    }
  }
}

}  // namespace
}  // namespace roomcast::wire
