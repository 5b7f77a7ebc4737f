// SPDX-License-Identifier: Apache-2.0
// A room that is exported for Foxglove, imported as a rig and exported again is the same: depth,
// calibrations, times and poses; colour, which is lossy on both ways, nearly so.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/recording/export/set_writer.h"
#include "roomcast/recording/export/wall_fixture.h"
#include "roomcast/recording/foxglove/foxglove.pb.h"
#include "roomcast/recording/import/open_recording.h"
#include "roomcast/recording/import/rig_import.h"
#include "roomcast/recording/mcap/reader.h"

namespace roomcast::recording {
namespace {

constexpr int kSets = 12;
constexpr nanoseconds kOctober2025{1'760'000'000'000'000'123};

/// Depth that differs from pixel to pixel and from set to set, and a wide lens that distorts.
std::vector<SetSensor> lensed_sensors() {
  auto sensors = wall_sensors();
  sensors[1].depth.k1 = 0.0871234567890123, sensors[1].depth.p2 = -1e-5;
  for (SetSensor& sensor : sensors) sensor.fps = 29.97;
  return sensors;
}

FrameSet set_at(int number) {
  FrameSet set;
  set.number = static_cast<std::uint64_t>(number);
  for (std::size_t i = 0; i < 2; ++i) {
    auto pictures = std::make_shared<codec::DecodedFrame>();
    pictures->depth_mm = DepthImage(64, 48, 0);
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 64; ++x)
        pictures->depth_mm.at(x, y) = static_cast<std::uint16_t>(
            x == 5 ? 0 : 1000 + 3 * x + 7 * y + 11 * number + 2000 * static_cast<int>(i));
    }
    pictures->color = ColorImage(64, 48, i == 0 ? Rgb8{200, 90, 30} : Rgb8{40, 150, 220});
    pictures->color_seen = MaskImage(64, 48, 255);
    const nanoseconds time(33'366'701LL * number + 1'000'003LL * static_cast<int>(i));
    RigidTransform pose = wall_pose(i);
    pose.rotation =
        Eigen::AngleAxisd(0.3 + static_cast<double>(i), Eigen::Vector3d::UnitY()) * pose.rotation;
    set.frames.push_back({i, std::move(pictures), pose, time});
    set.time = std::max(set.time, time);
  }
  return set;
}

void export_sets(const std::filesystem::path& out, nanoseconds began_at, UpAxis up) {
  auto writer = make_set_writer(ExportFormat::kFoxglove, out, {lensed_sensors(), began_at}, {}, up);
  ASSERT_TRUE(writer.ok()) << writer.error().message;
  for (int i = 0; i < kSets; ++i) ASSERT_TRUE((*writer)->add(set_at(i)).ok());
  ASSERT_TRUE((*writer)->finish().ok());
}

void import_as_rig(const std::filesystem::path& file, const std::filesystem::path& rig) {
  const auto files = open_any(file);
  ASSERT_TRUE(files.ok()) << files.error().message;
  std::vector<const SensorFileInfo*> infos;
  std::vector<std::string> names;
  for (const auto& sensor : *files) {
    infos.push_back(&sensor->info());
    names.push_back(sensor->info().description.name);
    EXPECT_TRUE(sensor->info().notes.empty()) << sensor->info().notes.front();
  }
  const auto timeline = join_clocks(infos);
  ASSERT_TRUE(timeline.ok()) << timeline.error().message;
  const auto imported = import_rig(rig, *files, *timeline, {.names = names}, {});
  ASSERT_TRUE(imported.ok()) << imported.error().message;
  for (const ImportedSensor& sensor : *imported) {
    EXPECT_EQ(sensor.frames, static_cast<std::uint64_t>(kSets)) << sensor.name;
    EXPECT_EQ(sensor.colors, static_cast<std::uint64_t>(kSets)) << sensor.first_damage;
    EXPECT_EQ(sensor.damaged, 0U) << sensor.first_damage;
  }
}

void export_rig(const std::filesystem::path& rig, const std::filesystem::path& out, UpAxis up) {
  auto reader = open_frame_sets(rig);
  ASSERT_TRUE(reader.ok()) << reader.error().message;
  auto writer = make_set_writer(ExportFormat::kFoxglove, out,
                                {(*reader)->sensors(), (*reader)->began_at()}, {}, up);
  ASSERT_TRUE(writer.ok()) << writer.error().message;
  FrameSet set;
  while (*(*reader)->next(set)) ASSERT_TRUE((*writer)->add(set).ok());
  ASSERT_TRUE((*writer)->finish().ok());
}

struct Written {
  nanoseconds time{};
  std::string bytes;
};

std::map<std::string, std::vector<Written>> messages_by_topic(const std::filesystem::path& path) {
  const auto file = mcap::Reader::open(path);
  EXPECT_TRUE(file.ok());
  std::map<std::string, std::vector<Written>> topics;
  for (std::size_t i = 0; i < file->summary().chunks.size(); ++i) {
    const auto chunk = file->chunk(i);
    EXPECT_TRUE(chunk.ok());
    for (const mcap::Message& message : chunk->messages)
      topics[file->summary().channels.at(message.channel).topic].push_back(
          {message.log_time, {message.data.begin(), message.data.end()}});
  }
  return topics;
}

void expect_same_transform(const std::string& before, const std::string& after) {
  constexpr double kRounding = 1e-12;  // of a quaternion made from a matrix
  foxglove::FrameTransform a, b;
  ASSERT_TRUE(a.ParseFromString(before) && b.ParseFromString(after));
  EXPECT_EQ(a.parent_frame_id(), b.parent_frame_id());
  EXPECT_EQ(a.child_frame_id(), b.child_frame_id());
  EXPECT_EQ(a.timestamp().nanos(), b.timestamp().nanos());
  EXPECT_NEAR(a.translation().x(), b.translation().x(), kRounding);
  EXPECT_NEAR(a.translation().y(), b.translation().y(), kRounding);
  EXPECT_NEAR(a.translation().z(), b.translation().z(), kRounding);
  EXPECT_NEAR(a.rotation().w(), b.rotation().w(), kRounding);
  EXPECT_NEAR(a.rotation().x(), b.rotation().x(), kRounding);
  EXPECT_NEAR(a.rotation().y(), b.rotation().y(), kRounding);
  EXPECT_NEAR(a.rotation().z(), b.rotation().z(), kRounding);
}

/// Places are equal to a float's rounding; colours differ as far as VP9 and JPEG change them.
void expect_same_cloud(const std::string& before, const std::string& after) {
  constexpr float kRounding_m = 1e-6F;
  constexpr int kLossyColor = 12;
  foxglove::PointCloud a, b;
  ASSERT_TRUE(a.ParseFromString(before) && b.ParseFromString(after));
  ASSERT_EQ(a.data().size(), b.data().size());
  for (std::size_t at = 0; at < a.data().size(); at += 16) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      float left = 0, right = 0;
      std::memcpy(&left, a.data().data() + at + 4 * axis, 4);
      std::memcpy(&right, b.data().data() + at + 4 * axis, 4);
      ASSERT_NEAR(left, right, kRounding_m);
      const auto color = [&](const std::string& data) {
        return static_cast<int>(static_cast<unsigned char>(data[at + 12 + axis]));
      };
      ASSERT_NEAR(color(a.data()), color(b.data()), kLossyColor);
    }
  }
}

class FoxgloveRoundTrip : public testing::TestWithParam<UpAxis> {};

TEST_P(FoxgloveRoundTrip, keeps_depth_calibrations_times_and_poses) {
  for (const nanoseconds began_at : {kOctober2025, nanoseconds(0)}) {
    const TemporaryFolder folder;
    export_sets(folder / "first", began_at, GetParam());
    import_as_rig(folder / "first/room.mcap", folder / "rig");
    export_rig(folder / "rig", folder / "second", GetParam());
    const auto before = messages_by_topic(folder / "first/room.mcap");
    const auto after = messages_by_topic(folder / "second/room.mcap");
    ASSERT_EQ(before.size(), after.size());
    for (const auto& [topic, messages] : before) {
      ASSERT_TRUE(after.contains(topic)) << topic;
      ASSERT_EQ(after.at(topic).size(), messages.size()) << topic;
      for (std::size_t i = 0; i < messages.size(); ++i) {
        const Written &first = messages[i], &second = after.at(topic)[i];
        EXPECT_EQ(first.time, second.time) << topic << " " << i;
        if (topic.ends_with("/depth") || topic.ends_with("/camera")) {
          EXPECT_EQ(first.bytes, second.bytes) << topic << " " << i;
        }
        if (topic == "/tf") expect_same_transform(first.bytes, second.bytes);
        if (topic == "/points") expect_same_cloud(first.bytes, second.bytes);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(UpAxes, FoxgloveRoundTrip, testing::Values(UpAxis::kZ, UpAxis::kY),
                         [](const auto& up) { return up.param == UpAxis::kZ ? "z_up" : "y_up"; });

TEST(FoxgloveVideo, colour_is_read_in_any_order) {
  const TemporaryFolder folder;
  export_sets(folder / "out", kOctober2025, UpAxis::kZ);
  const auto files = open_any(folder / "out/room.mcap");
  ASSERT_TRUE(files.ok());
  SensorFile& file = *(*files)[0];
  ColorImage forwards, color;
  for (const std::size_t i : {0U, 1U, 2U, 3U}) ASSERT_TRUE(file.read_color(i, forwards).ok());
  for (const std::size_t i : {7U, 0U, 3U}) ASSERT_TRUE(file.read_color(i, color).ok());
  EXPECT_EQ(color, forwards);
  EXPECT_NEAR(color.at(30, 20).r, 200, 8);
}

}  // namespace
}  // namespace roomcast::recording
