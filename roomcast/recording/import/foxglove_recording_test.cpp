// SPDX-License-Identifier: Apache-2.0
// Files as other programs write them, after the published schemas; roomcast's own are read in
// export/foxglove_round_trip_test.cpp.
#include "roomcast/recording/import/foxglove_recording.h"

#include <optional>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/io/jpeg_codec.h"
#include "roomcast/io/png_codec.h"
#include "roomcast/recording/dataset/recording_fixture.h"
#include "roomcast/recording/foxglove/foxglove.pb.h"
#include "roomcast/recording/import/open_recording.h"
#include "roomcast/recording/mcap/writer.h"

namespace roomcast::recording {
namespace {

using std::chrono::milliseconds;
constexpr nanoseconds kStart = std::chrono::seconds(1'700'000'000);

/// Writes messages as they come, a channel for each topic.
class FoxgloveFile {
 public:
  explicit FoxgloveFile(const std::filesystem::path& path)
      : writer_(*mcap::Writer::create(path, {.profile = "", .chunk_bytes = 64})) {}
  ~FoxgloveFile() { EXPECT_TRUE(writer_.finish().ok()); }

  template <class Message>
  void add(const std::string& topic, const Message& message, nanoseconds time,
           const char* encoding = "protobuf") {
    const auto [channel, is_new] = channels_.try_emplace(topic);
    if (is_new) {
      const auto schema = writer_.add_schema(message.GetTypeName(), encoding, {});
      channel->second = writer_.add_channel(schema, topic, encoding);
    }
    const std::string text = message.SerializeAsString();
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    EXPECT_TRUE(writer_.add_message({channel->second, 0, time, time, bytes}).ok());
  }

 private:
  mcap::Writer writer_;
  std::map<std::string, mcap::ChannelId> channels_;
};

template <class Message>
Message stamped_at(nanoseconds time, const std::string& frame) {
  Message message;
  message.mutable_timestamp()->set_seconds(time.count() / 1'000'000'000);
  message.mutable_timestamp()->set_nanos(static_cast<int>(time.count() % 1'000'000'000));
  message.set_frame_id(frame);
  return message;
}

foxglove::RawImage depth_picture(nanoseconds time, const std::string& frame, char value) {
  auto image = stamped_at<foxglove::RawImage>(time, frame);
  image.set_width(4), image.set_height(2), image.set_step(8);
  image.set_encoding("16UC1");
  image.set_data(std::string(16, value));
  return image;
}

foxglove::CameraCalibration camera_of(const std::string& frame, std::uint32_t width, double focal) {
  auto camera = stamped_at<foxglove::CameraCalibration>(kStart, frame);
  camera.set_width(width), camera.set_height(2);
  camera.set_distortion_model("plumb_bob");
  for (const double d : {0.1, -0.2, 0.001, 0.002, 0.03}) camera.add_d(d);
  for (const double k : {focal, 0.0, 1.5, 0.0, focal, 0.5, 0.0, 0.0, 1.0}) camera.add_k(k);
  return camera;
}

foxglove::FrameTransform frame_in(const std::string& parent, const std::string& child, double x,
                                  double y, double z) {
  foxglove::FrameTransform transform;
  transform.set_parent_frame_id(parent), transform.set_child_frame_id(child);
  transform.mutable_translation()->set_x(x);
  transform.mutable_translation()->set_y(y);
  transform.mutable_translation()->set_z(z);
  transform.mutable_rotation()->set_w(1);
  return transform;
}

std::string text_of_bytes(const std::vector<std::uint8_t>& bytes) {
  return {bytes.begin(), bytes.end()};
}

/// Two frames of depth with a JPEG from a camera 5 cm beside it, on a stand 1 m above the map.
void write_robot(const std::filesystem::path& path) {
  FoxgloveFile file(path);
  foxglove::FrameTransforms stand;
  *stand.add_transforms() = frame_in("map", "stand", 1, 2, 1);
  *stand.add_transforms() = frame_in("stand", "depth_optical", 0, 0, 0);
  *stand.add_transforms() = frame_in("stand", "color_optical", 0.05, 0, 0);
  file.add("/tf", stand, kStart);
  file.add("/robot/depth/info", camera_of("depth_optical", 4, 5), kStart);
  file.add("/robot/color/info", camera_of("color_optical", 8, 10), kStart);
  const ColorImage grey(8, 2, Rgb8{90, 90, 90});
  std::vector<std::uint8_t> jpeg;
  EXPECT_EQ(io::JpegCodec().encode(grey.view(), 90, jpeg), "");
  for (int i = 0; i < 2; ++i) {
    const nanoseconds time = kStart + milliseconds(100 * i);
    auto picture = stamped_at<foxglove::CompressedImage>(time + milliseconds(10), "color_optical");
    picture.set_format("jpeg");
    picture.set_data(text_of_bytes(jpeg));
    file.add("/robot/color/image", picture, time);
    file.add("/robot/depth/image", depth_picture(time, "depth_optical", static_cast<char>(i + 1)),
             time);
  }
}

TEST(FoxgloveRecording, a_robots_camera_has_depth_colour_lenses_times_and_its_place) {
  const TemporaryFolder folder;
  write_robot(folder / "robot.mcap");
  EXPECT_EQ(import_kind_of(folder / "robot.mcap"), "foxglove");
  const auto files = open_any(folder / "robot.mcap");
  ASSERT_TRUE(files.ok()) << files.error().message;
  ASSERT_EQ(files->size(), 1U);
  SensorFile& file = *(*files)[0];
  EXPECT_EQ(file.info().description.name, "robot");
  EXPECT_THAT(file.info().times, testing::ElementsAre(kStart, kStart + milliseconds(100)));
  EXPECT_EQ(file.info().clock.utc_minus_device, nanoseconds(0));
  EXPECT_THAT(file.info().notes, testing::IsEmpty());
  const SensorCalibration& cameras = file.info().description.calibration;
  EXPECT_EQ(cameras.depth.fx, 5);
  EXPECT_EQ(cameras.depth.k2, -0.2);
  EXPECT_EQ(cameras.depth.k3, 0.03);
  EXPECT_EQ(cameras.color.width, 8);
  EXPECT_FALSE(cameras.color_is_registered);
  EXPECT_NEAR(cameras.color_from_depth.translation_m.x(), -0.05, 1e-12);
  ASSERT_TRUE(file.info().description.world_from_depth);
  EXPECT_EQ(file.info().description.world_from_depth->translation_m, Eigen::Vector3d(1, 1, -2))
      << "y is up in roomcast's world";
  DepthImage depth;
  ASSERT_TRUE(file.read_depth(1, depth).ok());
  EXPECT_EQ(depth.at(3, 1), 0x0202);
  ColorImage color;
  ASSERT_TRUE(file.read_color(1, color).ok());
  EXPECT_NEAR(color.at(7, 1).g, 90, 2);
  std::vector<std::uint8_t> jpeg;
  ASSERT_TRUE(file.read_jpeg(0, jpeg).ok());
  EXPECT_FALSE(jpeg.empty());
}

TEST(FoxgloveRecording, depth_may_be_a_png_of_16_bits) {
  const TemporaryFolder folder;
  {
    FoxgloveFile file(folder / "a.mcap");
    DepthImage depth(4, 2, 1234);
    auto picture = stamped_at<foxglove::CompressedImage>(kStart, "cam");
    picture.set_format("png");
    std::vector<std::uint8_t> png;
    ASSERT_EQ(io::encode_depth_png(depth.view(), png), "");
    picture.set_data(text_of_bytes(png));
    file.add("/cam/depth", picture, kStart);
    file.add("/cam/camera", camera_of("cam", 4, 5), kStart);
  }
  const auto files = open_any(folder / "a.mcap");
  ASSERT_TRUE(files.ok()) << files.error().message;
  EXPECT_FALSE((*files)[0]->info().has_color);
  EXPECT_FALSE((*files)[0]->info().description.world_from_depth);
  DepthImage depth;
  ASSERT_TRUE((*files)[0]->read_depth(0, depth).ok());
  EXPECT_EQ(depth.at(3, 1), 1234);
}

/// Depth of a frame "cam" and of one "other", with what `more` adds.
template <class More>
Result<SensorFiles> two_cameras(const TemporaryFolder& folder, More more) {
  {
    FoxgloveFile file(folder / "a.mcap");
    for (const char* name : {"cam", "other"}) {
      const std::string topic = std::string("/") + name;
      file.add(topic + "/depth", depth_picture(kStart, name, 1), kStart);
      file.add(topic + "/camera", camera_of(name, 4, 5), kStart);
    }
    more(file);
  }
  return open_any(folder / "a.mcap");
}

TEST(FoxgloveRecording, a_camera_that_moved_has_its_last_pose_and_that_is_told) {
  const TemporaryFolder folder;
  const auto files = two_cameras(folder, [](FoxgloveFile& file) {
    file.add("/tf", frame_in("world", "cam", 1, 0, 0), kStart);
    file.add("/tf", frame_in("world", "cam", 3, 0, 0), kStart + milliseconds(5));
  });
  ASSERT_TRUE(files.ok()) << files.error().message;
  const SensorFileInfo& info = (*files)[0]->info();
  EXPECT_EQ(info.description.world_from_depth->translation_m, Eigen::Vector3d(3, 0, 0));
  EXPECT_THAT(info.notes, testing::ElementsAre(testing::HasSubstr("cam was moved")));
  EXPECT_FALSE((*files)[1]->info().description.world_from_depth);
}

TEST(FoxgloveRecording, cameras_of_different_worlds_are_not_placed) {
  const TemporaryFolder folder;
  const auto files = two_cameras(folder, [](FoxgloveFile& file) {
    file.add("/tf", frame_in("here", "cam", 1, 0, 0), kStart);
    file.add("/tf", frame_in("there", "other", 1, 0, 0), kStart);
  });
  ASSERT_TRUE(files.ok());
  for (const auto& file : *files) {
    EXPECT_FALSE(file->info().description.world_from_depth);
    EXPECT_THAT(file->info().notes, testing::ElementsAre(testing::HasSubstr("one root")));
  }
}

TEST(FoxgloveRecording, colour_in_other_video_is_left_out_and_told) {
  const TemporaryFolder folder;
  const auto files = two_cameras(folder, [](FoxgloveFile& file) {
    auto video = stamped_at<foxglove::CompressedVideo>(kStart, "cam");
    video.set_format("h264");
    video.set_data("video");
    file.add("/cam/color", video, kStart);
  });
  ASSERT_TRUE(files.ok());
  EXPECT_FALSE((*files)[0]->info().has_color);
  EXPECT_THAT((*files)[0]->info().notes, testing::ElementsAre(testing::HasSubstr("\"h264\"")));
  EXPECT_THAT((*files)[1]->info().notes, testing::IsEmpty());
}

TEST(FoxgloveRecording, times_from_zero_are_of_one_clock) {
  const TemporaryFolder folder;
  {
    FoxgloveFile file(folder / "a.mcap");
    int i = 0;
    for (const char* name : {"cam", "other"}) {
      const std::string topic = std::string("/") + name;
      const nanoseconds time = milliseconds(30 * i++);
      file.add(topic + "/depth", depth_picture(time, name, 1), time);
      file.add(topic + "/camera", camera_of(name, 4, 5), time);
    }
  }
  const auto files = open_any(folder / "a.mcap");
  ASSERT_TRUE(files.ok()) << files.error().message;
  EXPECT_FALSE((*files)[0]->info().clock.utc_minus_device);
  EXPECT_EQ((*files)[0]->info().clock.recording, (*files)[1]->info().clock.recording);
  EXPECT_THAT((*files)[1]->info().times, testing::ElementsAre(milliseconds(30)));
}

TEST(FoxgloveRecording, what_cannot_be_read_is_refused_with_a_sentence) {
  const TemporaryFolder folder;
  const auto message = [](const std::filesystem::path& path) {
    const auto files = open_recording("foxglove", path);
    return files.ok() ? std::string("read") : files.error().message;
  };
  put_text(folder / "empty.mcap", "");
  EXPECT_THAT(message(folder / "empty.mcap"), testing::HasSubstr("empty.mcap"));
  EXPECT_THAT(message(folder / "absent.mcap"), testing::HasSubstr("absent.mcap"));
  {
    FoxgloveFile file(folder / "json.mcap");
    file.add("/cam/depth", depth_picture(kStart, "cam", 1), kStart, "json");
  }
  EXPECT_THAT(message(folder / "json.mcap"), testing::HasSubstr("no messages in Protobuf"));
  {
    FoxgloveFile file(folder / "lensless.mcap");
    file.add("/cam/depth", depth_picture(kStart, "cam", 1), kStart);
  }
  EXPECT_THAT(message(folder / "lensless.mcap"), testing::HasSubstr("CameraCalibration"));
  {
    FoxgloveFile file(folder / "fisheye.mcap");
    file.add("/cam/depth", depth_picture(kStart, "cam", 1), kStart);
    auto camera = camera_of("cam", 4, 5);
    camera.set_distortion_model("kannala_brandt");
    file.add("/cam/camera", camera, kStart);
  }
  EXPECT_THAT(message(folder / "fisheye.mcap"), testing::HasSubstr("kannala_brandt"));
}

TEST(FoxgloveRecording, a_picture_of_another_size_is_refused_and_the_next_read) {
  const TemporaryFolder folder;
  {
    FoxgloveFile file(folder / "a.mcap");
    file.add("/cam/camera", camera_of("cam", 4, 5), kStart);
    auto huge = depth_picture(kStart, "cam", 1);
    huge.set_width(0xFFFFFFFFU), huge.set_height(0xFFFFFFFFU), huge.set_step(0xFFFFFFFFU);
    file.add("/cam/depth", huge, kStart);
    file.add("/cam/depth", depth_picture(kStart + milliseconds(30), "cam", 1), kStart);
    auto cut = depth_picture(kStart + milliseconds(60), "cam", 1);
    cut.set_data("short");
    file.add("/cam/depth", cut, kStart);
  }
  const auto files = open_any(folder / "a.mcap");
  ASSERT_TRUE(files.ok()) << files.error().message;
  DepthImage depth;
  EXPECT_EQ((*files)[0]->read_depth(0, depth).error().code, ErrorCode::kMalformed);
  EXPECT_TRUE((*files)[0]->read_depth(1, depth).ok());
  EXPECT_EQ((*files)[0]->read_depth(2, depth).error().code, ErrorCode::kMalformed);
}

TEST(FoxgloveRecording, a_cut_file_is_read_up_to_there) {
  const TemporaryFolder folder;
  write_robot(folder / "robot.mcap");
  truncate_file(folder / "robot.mcap", 0.6);
  const auto files = open_any(folder / "robot.mcap");
  ASSERT_TRUE(files.ok()) << files.error().message;
  EXPECT_THAT((*files)[0]->info().notes,
              testing::Contains(testing::HasSubstr("everything before that was read")));
  EXPECT_EQ((*files)[0]->info().times.size(), 1U);
}

}  // namespace
}  // namespace roomcast::recording
