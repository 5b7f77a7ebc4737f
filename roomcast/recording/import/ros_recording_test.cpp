// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/ros_recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "roomcast/io/file_bytes.h"
#include "roomcast/io/image_file.h"
#include "roomcast/recording/dataset/recording_fixture.h"
#include "roomcast/recording/mcap/writer.h"
#include "roomcast/recording/ros/ros_fixture.h"
#include "roomcast/recording/rosbag/bag_fixture.h"

namespace roomcast::recording {
namespace {

using ros::Serialisation;
using std::chrono::milliseconds;
constexpr auto kRos1 = Serialisation::kRos1;
constexpr nanoseconds kBegin = std::chrono::seconds(1'700'000'000);

std::string depth_bytes(int frame) {
  std::string bytes;
  for (int i = 0; i < 6; ++i)
    bytes += rosbag::little(static_cast<std::uint64_t>(1000 * frame + i), 2);
  return bytes;
}

/// Two frames of 3 x 2 pixels with colour of 4 x 2, 100 ms apart; colour is 10 ms later.
rosbag::BagWriter camera(const std::string& name, rosbag::BagWriter bag, bool with_tf = true) {
  const std::string depth_frame = name + "_depth", color_frame = name + "_color";
  if (with_tf) {
    bag.message("/tf_static", "tf2_msgs/TFMessage", kBegin,
                ros::transforms_message(kRos1, {{name + "_link", depth_frame, {0, 0, 0}},
                                                {name + "_link", color_frame, {0.05, 0, 0}}}));
  }
  bag.message(name + "/depth/camera_info", "sensor_msgs/CameraInfo", kBegin,
              ros::camera_info_message(kRos1, depth_frame, 3, 2, 5, "plumb_bob", {}));
  bag.message(
      name + "/rgb/camera_info", "sensor_msgs/CameraInfo", kBegin,
      ros::camera_info_message(kRos1, color_frame, 4, 2, 6, "plumb_bob", {0.1, 0, 0, 0, 0}));
  for (int i = 0; i < 2; ++i) {
    const nanoseconds time = kBegin + milliseconds(100 * i);
    bag.message(name + "/depth/image_raw", "sensor_msgs/Image", time,
                ros::image_message(kRos1, time, depth_frame, 3, 2, "16UC1", 6, depth_bytes(i + 1)));
    bag.message(name + "/rgb/image_raw", "sensor_msgs/Image", time,
                ros::image_message(kRos1, time + milliseconds(10), color_frame, 4, 2, "bgr8", 12,
                                   std::string(24, static_cast<char>(50 + i))));
    bag.end_chunk();
  }
  return bag;
}

std::filesystem::path written(const TemporaryFolder& folder, rosbag::BagWriter bag) {
  const std::filesystem::path path = folder / "a.bag";
  EXPECT_TRUE(io::write_file(path, bag.finished()).ok());
  return path;
}

TEST(RosRecording, a_camera_of_a_bag_has_depth_colour_lenses_and_times) {
  const TemporaryFolder folder;
  for (const char* compression : {"none", "bz2", "lz4"}) {
    const auto files =
        open_ros1_bag(written(folder, camera("/cam", rosbag::BagWriter(compression))));
    ASSERT_TRUE(files.ok()) << files.error().message;
    ASSERT_EQ(files->size(), 1U);
    SensorFile& file = *(*files)[0];
    EXPECT_THAT(file.info().times, testing::ElementsAre(kBegin, kBegin + milliseconds(100)));
    EXPECT_EQ(file.info().clock.utc_minus_device, nanoseconds(0));
    EXPECT_EQ(file.info().description.name, "cam");
    const SensorCalibration& cameras = file.info().description.calibration;
    EXPECT_EQ(cameras.depth.fx, 5);
    EXPECT_EQ(cameras.color.k1, 0.1);
    EXPECT_NEAR(cameras.color_from_depth.translation_m.x(), -0.05, 1e-12);
    DepthImage depth;
    ColorImage color;
    ASSERT_TRUE(file.read_depth(1, depth).ok());
    EXPECT_EQ(depth.at(2, 1), 2005);
    ASSERT_TRUE(file.read_color(1, color).ok());
    EXPECT_EQ(color.at(3, 1), (Rgb8{51, 51, 51}));
  }
}

TEST(RosRecording, every_camera_of_a_bag_is_a_sensor) {
  const TemporaryFolder folder;
  const auto files =
      open_ros1_bag(written(folder, camera("/right", camera("/left", rosbag::BagWriter()))));
  ASSERT_TRUE(files.ok()) << files.error().message;
  ASSERT_EQ(files->size(), 2U);
  EXPECT_EQ((*files)[0]->info().description.name, "left");
  EXPECT_TRUE((*files)[1]->info().has_color);
}

TEST(RosRecording, colour_without_a_place_is_left_out_and_told) {
  const TemporaryFolder folder;
  const auto files = open_ros1_bag(written(folder, camera("/cam", rosbag::BagWriter(), false)));
  ASSERT_TRUE(files.ok());
  EXPECT_FALSE((*files)[0]->info().has_color);
  EXPECT_THAT((*files)[0]->info().notes, testing::ElementsAre(testing::HasSubstr("/tf_static")));
}

TEST(RosRecording, a_bag_without_depth_and_no_bag_are_refused) {
  const TemporaryFolder folder;
  rosbag::BagWriter bag;
  bag.message("/chatter", "std_msgs/String", kBegin, "hello");
  EXPECT_EQ(open_ros1_bag(written(folder, bag)).error().code, ErrorCode::kUnsupported);
  put_text(folder / "b.bag", "no bag");
  EXPECT_THAT(open_ros1_bag(folder / "b.bag").error().message, testing::HasSubstr("b.bag: "));
  EXPECT_EQ(open_ros1_bag(folder / "absent.bag").error().code, ErrorCode::kNotFound);
}

TEST(RosRecording, a_cut_bag_is_read_up_to_there) {
  const TemporaryFolder folder;
  auto bytes = camera("/cam", rosbag::BagWriter("none")).finished();
  bytes.resize(bytes.size() - 900);  // the connections at the end, and part of the second chunk
  ASSERT_TRUE(io::write_file(folder / "cut.bag", bytes).ok());
  const auto files = open_ros1_bag(folder / "cut.bag");
  ASSERT_TRUE(files.ok()) << files.error().message;
  EXPECT_FALSE((*files)[0]->info().notes.empty());
  DepthImage depth;
  EXPECT_TRUE((*files)[0]->read_depth(0, depth).ok());
}

struct Ros2Message {
  std::string topic, type;
  nanoseconds time;
  std::string data;
};

/// One depth picture and its camera, in CDR.
std::vector<Ros2Message> ros2_messages() {
  constexpr auto kRos2 = Serialisation::kRos2;
  return {{"/cam/depth/camera_info", "sensor_msgs/msg/CameraInfo", kBegin,
           ros::camera_info_message(kRos2, "d", 3, 2, 5, "plumb_bob", {})},
          {"/cam/depth/image_raw", "sensor_msgs/msg/Image", kBegin,
           ros::image_message(kRos2, kBegin, "d", 3, 2, "16UC1", 6, depth_bytes(1))}};
}

void expect_ros2_camera(const std::filesystem::path& path) {
  const auto files = open_ros2_recording(path);
  ASSERT_TRUE(files.ok()) << files.error().message;
  ASSERT_EQ(files->size(), 1U);
  EXPECT_EQ((*files)[0]->info().times[0], kBegin);
  DepthImage depth;
  ASSERT_TRUE((*files)[0]->read_depth(0, depth).ok());
  EXPECT_EQ(depth.at(2, 1), 1005);
}

TEST(RosRecording, ros_2_in_mcap_is_read) {
  const TemporaryFolder folder;
  auto writer = mcap::Writer::create(folder / "a.mcap");
  ASSERT_TRUE(writer.ok());
  for (const Ros2Message& message : ros2_messages()) {
    const auto schema = writer->add_schema(message.type, "ros2msg", {});
    const auto channel = writer->add_channel(schema, message.topic, "cdr", {});
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(message.data.data());
    ASSERT_TRUE(
        writer->add_message({channel, 0, message.time, message.time, {bytes, message.data.size()}})
            .ok());
  }
  ASSERT_TRUE(writer->finish().ok());
  expect_ros2_camera(folder / "a.mcap");
  expect_ros2_camera(folder.path());  // as the folder that rosbag2 makes
}

TEST(RosRecording, ros_2_in_sqlite_is_read) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "a_0.db3";
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  std::string sql =
      "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT,"
      " offered_qos_profiles TEXT); CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER,"
      " timestamp INTEGER, data BLOB);";
  int id = 0;
  for (const Ros2Message& message : ros2_messages()) {
    std::string hex;
    for (const char c : message.data) {
      constexpr const char* kDigits = "0123456789ABCDEF";
      const auto byte = static_cast<unsigned char>(c);
      hex += {kDigits[byte >> 4U], kDigits[byte & 15U]};
    }
    ++id;
    sql += "INSERT INTO topics VALUES(" + std::to_string(id) + ",'" + message.topic + "','" +
           message.type + "','cdr',''); INSERT INTO messages VALUES(" + std::to_string(id) + "," +
           std::to_string(id) + "," + std::to_string(message.time.count()) + ",x'" + hex + "');";
  }
  ASSERT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(database);
  expect_ros2_camera(path);
  truncate_file(path, 0.5);
  (void)open_ros2_recording(path);  // read in part, or refused
  put_text(path, std::string("SQLite format 3\0", 16) + std::string(5000, 'x'));
  EXPECT_EQ(open_ros2_recording(path).error().code, ErrorCode::kMalformed);
}

/// Real: a D435, recorded by librealsense. The pictures beside it were extracted by its authors.
TEST(RosRecording, reads_a_real_realsense_recording) {
  const auto folder = shared_data() / "realsense_d435_bag";
  const auto path = folder / "single_depth_color_640x480.bag";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const auto files = open_ros1_bag(path);
  ASSERT_TRUE(files.ok()) << files.error().message;
  ASSERT_EQ(files->size(), 1U);
  SensorFile& file = *(*files)[0];
  EXPECT_EQ(file.info().description.name, "728612070259");
  EXPECT_EQ(file.info().times[0], nanoseconds(360'815'089'000));
  ASSERT_EQ(file.info().times.size(), 2U);
  ASSERT_TRUE(file.info().clock.utc_minus_device);
  EXPECT_EQ((file.info().times[0] + *file.info().clock.utc_minus_device).count() / 1'000'000,
            1'534'232'519'732);
  const SensorCalibration& cameras = file.info().description.calibration;
  EXPECT_NEAR(cameras.depth.fx, 390.43145752, 1e-6);
  EXPECT_NEAR(cameras.color.cy, 239.18299866, 1e-6);
  EXPECT_NEAR(cameras.color_from_depth.translation_m.x(), 0.01431131, 1e-8);
  io::ImageFileReader reader;
  DepthImage depth, beside;
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_TRUE(file.read_depth(i, depth).ok());
    const auto png = folder / ("depth/00000" + std::to_string(i) + ".png");
    ASSERT_TRUE(reader.read_depth(png, {640, 480}, beside).ok());
    EXPECT_EQ(depth, beside) << i;
  }
  ColorImage color, color_beside;
  ASSERT_TRUE(file.read_color(0, color).ok());
  ASSERT_TRUE(reader.read_color(folder / "rgb/000000.png", {640, 480}, color_beside).ok());
  EXPECT_EQ(color, color_beside);
  ASSERT_TRUE(file.read_color(1, color).ok());
  EXPECT_TRUE(color.empty());
}

}  // namespace
}  // namespace roomcast::recording
