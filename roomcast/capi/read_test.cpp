// SPDX-License-Identifier: Apache-2.0
// Recordings through the C interface; no hub. tests/cli/examples.test.mjs reads a recorded room.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "roomcast/capi/roomcast.h"

namespace {

/// A rig of one sensor with a pose, 4 x 3 pixels, as text and picture files.
class SmallRigFolder {
 public:
  SmallRigFolder() {
    std::filesystem::create_directories(path / "a/depth");
    put("rig.json",
        R"({"version": 1, "fps": 10, "sensors": [{"id": "a", "path": "a", "clock_offset_s": 0,
            "world_from_depth": [1,0,0,2, 0,-1,0,1.5, 0,0,-1,0, 0,0,0,1]}]})");
    put("a/camera.json",
        R"({"depth": {"width": 4, "height": 3, "fx": 5, "fy": 5, "cx": 1.5, "cy": 1},
            "depth_scale_to_metre": 0.001, "invalid_depth": [0]})");
    put("a/depth.txt", "100.0 depth/0.png\n100.1 depth/1.png\n");
    for (const char* name : {"a/depth/0.png", "a/depth/1.png"}) put(name, depth_png());
  }
  ~SmallRigFolder() { std::filesystem::remove_all(path); }

  void put(const std::string& name, const std::string& bytes) const {
    std::ofstream(path / name, std::ios::binary) << bytes;
  }

  const std::filesystem::path path =
      std::filesystem::temp_directory_path() /
      ("roomcast-read-" + std::to_string(std::hash<const void*>()(this)) + "-" +
       std::to_string(getpid()));

 private:
  /// 4 x 3 pixels of 16 bits, each 1000, in a stored block of deflate (RFC 1950, 1951; PNG 5.3).
  static std::string depth_png() {
    std::string rows;
    for (int y = 0; y < 3; ++y) {
      rows += '\0';
      for (int x = 0; x < 4; ++x) rows += "\x03\xE8";
    }
    std::uint32_t a = 1, b = 0;
    for (const char c : rows) a += static_cast<unsigned char>(c), b += a;
    std::string zlib("\x78\x01\x01", 3);
    const auto size = static_cast<std::uint16_t>(rows.size());
    zlib += {static_cast<char>(size), 0, static_cast<char>(~size), static_cast<char>(~size >> 8)};
    zlib += rows + big(b % 65'521 << 16 | a % 65'521);
    std::string header = big(4) + big(3);
    header += {16, 0, 0, 0, 0};
    return std::string("\x89PNG\r\n\x1A\n", 8) + chunk("IHDR", header) + chunk("IDAT", zlib) +
           chunk("IEND", "");
  }
  static std::string big(std::uint32_t value) {
    return {static_cast<char>(value >> 24), static_cast<char>(value >> 16),
            static_cast<char>(value >> 8), static_cast<char>(value)};
  }
  static std::string chunk(const std::string& type, const std::string& data) {
    std::uint32_t crc = 0xFFFFFFFF;
    for (const char c : type + data) {
      crc ^= static_cast<unsigned char>(c);
      for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xEDB88320 : 0);
    }
    return big(static_cast<std::uint32_t>(data.size())) + type + data + big(~crc);
  }
};

TEST(CApiReader, a_recording_gives_its_sensors_and_one_set_after_the_other) {
  const SmallRigFolder rig;
  char error[200] = "x";
  roomcast_reader* const reader = roomcast_open(rig.path.c_str(), error, sizeof(error));
  ASSERT_NE(reader, nullptr) << error;
  ASSERT_EQ(roomcast_recorded_sensor_count(reader), 1u);
  roomcast_sensor sensor{};
  sensor.size = sizeof(sensor);
  ASSERT_EQ(roomcast_get_recorded_sensor(reader, 0, &sensor), 1);
  EXPECT_STREQ(sensor.name, "a");
  EXPECT_EQ(sensor.width, 4);
  EXPECT_EQ(sensor.fx, 5);
  EXPECT_EQ(sensor.depth_mm, nullptr);
  EXPECT_EQ(roomcast_get_recorded_sensor(reader, 1, &sensor), 0);
  EXPECT_EQ(roomcast_may_export_recorded(reader, error, sizeof(error)), 1);
  EXPECT_GE(roomcast_recorded_length_ns(reader), 0);

  roomcast_frames* const first = roomcast_next_frames(reader, error, sizeof(error));
  ASSERT_NE(first, nullptr) << error;
  EXPECT_EQ(roomcast_sensor_count(first), 1u);
  EXPECT_EQ(roomcast_room_sensor_count(first), 1u);
  ASSERT_EQ(roomcast_get_sensor(first, 0, &sensor), 1);
  EXPECT_EQ(sensor.placed, 1);
  EXPECT_EQ(sensor.world_from_depth[3], 2);
  EXPECT_EQ(sensor.capture_ns, 0);
  EXPECT_EQ(sensor.color_rgb, nullptr);
  EXPECT_EQ(sensor.depth_mm[11], 1000);
  roomcast_point points[20];
  ASSERT_EQ(roomcast_get_points(first, points, 20), 12u);
  // The first pixel's ray is (-0.3, -0.2, 1); the sensor is turned about its x axis.
  EXPECT_FLOAT_EQ(points[0].x, 1.7F);
  EXPECT_FLOAT_EQ(points[0].y, 1.7F);
  EXPECT_FLOAT_EQ(points[0].z, -1);

  roomcast_frames* const second = roomcast_next_frames(reader, error, sizeof(error));
  ASSERT_NE(second, nullptr) << error;
  roomcast_get_sensor(second, 0, &sensor);
  EXPECT_EQ(sensor.seq, 1u);
  EXPECT_NEAR(static_cast<double>(sensor.capture_ns), 1e8, 1e6);
  EXPECT_EQ(roomcast_next_frames(reader, error, sizeof(error)), nullptr);
  EXPECT_STREQ(error, "");
  roomcast_close(reader);
  roomcast_get_sensor(first, 0, &sensor);  // outlives the reader
  EXPECT_STREQ(sensor.name, "a");
  EXPECT_EQ(sensor.depth_mm[0], 1000);
  roomcast_free_frames(first);
  roomcast_free_frames(second);
}

TEST(CApiReader, a_damaged_place_is_told_and_passed) {
  const SmallRigFolder rig;
  rig.put("a/depth/1.png", "no picture");
  char error[200] = "";
  roomcast_reader* const reader = roomcast_open(rig.path.c_str(), error, sizeof(error));
  ASSERT_NE(reader, nullptr) << error;
  int sets = 0, damaged = 0;
  for (int call = 0; call < 10; ++call) {
    roomcast_frames* const frames = roomcast_next_frames(reader, error, sizeof(error));
    if (frames != nullptr) {
      ++sets;
    } else if (error[0] == 0) {
      break;  // the end
    } else {
      ++damaged;
      EXPECT_NE(std::string(error).find("1.png"), std::string::npos) << error;
    }
    roomcast_free_frames(frames);
  }
  EXPECT_EQ(sets, 1);
  EXPECT_EQ(damaged, 1);
  EXPECT_STREQ(error, "");
  roomcast_close(reader);
}

TEST(CApiReader, what_is_no_recording_is_a_sentence) {
  char error[200] = "";
  EXPECT_EQ(roomcast_open("/nowhere", error, sizeof(error)), nullptr);
  EXPECT_NE(std::string(error).find("/nowhere"), std::string::npos) << error;
  EXPECT_EQ(roomcast_open(nullptr, nullptr, 0), nullptr);
  roomcast_close(nullptr);
}

}  // namespace
