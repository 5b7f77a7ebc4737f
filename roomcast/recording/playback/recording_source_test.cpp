// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/playback/recording_source.h"

#include <thread>

#include <gtest/gtest.h>

#include "roomcast/recording/dataset/recording.h"
#include "roomcast/recording/dataset/recording_fixture.h"
#include "roomcast/recording/dataset/rig_json.h"

namespace roomcast::recording {
namespace {

using std::chrono::milliseconds;

const source::PlaybackOptions kFastOnce{.pace = source::Pace::kAsFastAsPossible, .loop = false};
const source::PlaybackOptions kFastLoop{.pace = source::Pace::kAsFastAsPossible, .loop = true};

std::unique_ptr<source::FrameSource> open_rig(const std::filesystem::path& rig,
                                              const std::string& sensor,
                                              const source::PlaybackOptions& options) {
  auto source = open_rig_source(rig.string(), sensor, options);
  EXPECT_TRUE(source.ok()) << (source.ok() ? "" : source.error().message);
  return source.ok() ? std::move(*source) : nullptr;
}

TEST(RigSource, gives_the_written_frames) {
  const TemporaryFolder folder;
  const auto source = open_rig(write_small_rig(folder), "s0", kFastOnce);
  ASSERT_TRUE(source);
  EXPECT_EQ(source->description().name, "s0");
  EXPECT_EQ(source->description().fps, kSmallFps);
  EXPECT_TRUE(source->description().world_from_depth);
  source::CapturedFrame frame;
  for (std::uint64_t i = 0; i < 5; ++i) {
    const auto more = source->next(frame, {});
    ASSERT_TRUE(more.ok()) << more.error().message;
    ASSERT_TRUE(*more);
    EXPECT_EQ(frame.index, i);
    EXPECT_EQ(frame.depth_mm, small_frame(0, i).depth_mm);
    EXPECT_NEAR(frame.color.at(40, 30).r, 20 * int(i), 6);
    EXPECT_EQ(frame.device_time, nanoseconds(100'000'000'000 + 20'000'000 * int(i)));
  }
  EXPECT_FALSE(*source->next(frame, {}));
}

TEST(RigSource, multiplies_depth_by_the_scale_of_the_rig) {
  const TemporaryFolder folder;
  const auto rig = write_small_rig(folder);
  auto description = read_rig_json(rig / "rig.json");
  ASSERT_TRUE(description.ok());
  description->sensors[0].depth_scale = 1.5;
  put_text(rig / "rig.json", rig_json_text(*description));
  const auto source = open_rig(rig, "s0", kFastOnce);
  ASSERT_TRUE(source);
  source::CapturedFrame frame;
  ASSERT_TRUE(*source->next(frame, {}));
  EXPECT_EQ(frame.depth_mm.at(0, 0), 1500);
  EXPECT_EQ(frame.depth_mm.at(20, 12), 1548);
}

TEST(RigSource, loops_with_the_same_frames_later) {
  const TemporaryFolder folder;
  const auto source = open_rig(write_small_rig(folder), "s0", kFastLoop);
  source::CapturedFrame frame;
  for (int i = 0; i < 12; ++i) {
    ASSERT_TRUE(*source->next(frame, {}));
    EXPECT_EQ(frame.index, static_cast<std::uint64_t>(i % 5));
    EXPECT_EQ(frame.capture_time, HostTime(milliseconds(20 * i)));  // a round: 5 frames of 20 ms
  }
}

TEST(RigSource, clock_offsets_are_taken_out_of_capture_times_only) {
  const TemporaryFolder folder;
  const auto rig = write_small_rig(folder);
  const auto first = open_rig(rig, "s0", kFastOnce);
  const auto second = open_rig(rig, "s1", kFastOnce);
  source::CapturedFrame a, b;
  ASSERT_TRUE(*first->next(a, {}));
  ASSERT_TRUE(*second->next(b, {}));
  EXPECT_EQ(b.capture_time - a.capture_time, milliseconds(3));
  EXPECT_EQ(b.device_time, nanoseconds(107'503'000'000));
}

TEST(RigSource, a_dropped_frame_stays_a_gap) {
  const TemporaryFolder folder;
  const auto source = open_rig(write_small_rig(folder), "s1", kFastOnce);
  source::CapturedFrame frame;
  std::vector<std::uint64_t> indices;
  std::vector<HostTime> times;
  while (*source->next(frame, {})) {
    indices.push_back(frame.index);
    times.push_back(frame.capture_time);
  }
  EXPECT_EQ(indices, (std::vector<std::uint64_t>{0, 1, 3, 4}));
  EXPECT_EQ(times[2] - times[1], milliseconds(40));
}

TEST(RigSource, two_sources_play_the_same_instants_in_real_time) {
  const TemporaryFolder folder;
  const auto rig = write_small_rig(folder);
  const auto a = open_rig(rig, "s0", {});
  source::CapturedFrame from_a, from_b;
  ASSERT_TRUE(*a->next(from_a, {}));
  const auto b = open_rig(rig, "s1", {});  // opened later
  ASSERT_TRUE(*b->next(from_b, {}));
  // Whichever frames the two sources return, their capture times differ by the same amount as the
  // recorded true times, modulo the loop.
  const auto recorded =
      milliseconds(20) * (int(from_b.index) - int(from_a.index)) + milliseconds(3);
  const auto played = from_b.capture_time - from_a.capture_time;
  EXPECT_EQ((played - recorded) % milliseconds(100), nanoseconds(0));
}

TEST(RigSource, in_real_time_a_frame_comes_when_it_is_due_and_not_before) {
  const TemporaryFolder folder;
  const auto source = open_rig(write_small_rig(folder), "s0", {});
  const SteadyClock clock;
  source::CapturedFrame frame;
  HostTime last{};
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(*source->next(frame, {}));
    EXPECT_GE(clock.now(), frame.capture_time);
    EXPECT_GT(frame.capture_time, last);
    last = frame.capture_time;
  }
}

TEST(RigSource, stop_ends_the_waiting) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "slow";
  std::vector<RigSensor> sensors(1);
  sensors[0].description = {"s0", small_calibration(), std::nullopt, 1};
  auto writer = RigWriter::create(path, 0.001, sensors);
  ASSERT_TRUE(writer.ok());
  ASSERT_TRUE(writer->add(0, small_frame(0, 0), nanoseconds(0)).ok());
  const auto source = open_rig(path, "s0", {});  // one frame in 1000 s
  std::stop_source stop;
  source::CapturedFrame frame;
  std::jthread stopper([&] { stop.request_stop(); });
  EXPECT_FALSE(*source->next(frame, stop.get_token()));
}

TEST(RigSource, a_missing_or_damaged_picture_is_named_and_passed_over) {
  const TemporaryFolder folder;
  const auto rig = write_small_rig(folder);
  std::filesystem::remove(rig / "s0/depth/000001.png");
  truncate_file(rig / "s0/depth/000002.png", 0.7);
  truncate_file(rig / "s0/rgb/000003.jpg", 0.5);
  ASSERT_TRUE(io::write_depth_png(rig / "s0/depth/000004.png", DepthImage(8, 8)).ok());
  const auto source = open_rig(rig, "s0", kFastOnce);
  source::CapturedFrame frame;
  EXPECT_TRUE(*source->next(frame, {}));
  const std::pair<ErrorCode, const char*> expected[] = {{ErrorCode::kNotFound, "000001.png"},
                                                        {ErrorCode::kMalformed, "000002.png"},
                                                        {ErrorCode::kMalformed, "000003.jpg"},
                                                        {ErrorCode::kMalformed, "000004.png"}};
  for (const auto& [code, name] : expected) {
    const auto result = source->next(frame, {});
    ASSERT_FALSE(result.ok()) << name;
    EXPECT_EQ(result.error().code, code);
    EXPECT_NE(result.error().message.find(name), std::string::npos) << result.error().message;
  }
  EXPECT_FALSE(*source->next(frame, {}));
}

TEST(RigSource, opening_names_the_faulty_file) {
  const TemporaryFolder folder;
  const auto rig = write_small_rig(folder);
  const auto message = [&](const std::string& sensor) {
    const auto source = open_rig_source(rig.string(), sensor, {});
    EXPECT_FALSE(source.ok());
    return source.ok() ? std::string() : source.error().message;
  };
  EXPECT_NE(message("s7").find("choose one of s0, s1"), std::string::npos);
  EXPECT_NE(message("").find("several sensors"), std::string::npos);
  put_text(rig / "s0/depth.txt", "# nothing\n");
  EXPECT_NE(message("s1").find("depth.txt lists no frames"), std::string::npos);
  put_text(rig / "s0/depth.txt", "1.0 depth/000000.png\nrubbish\n");
  EXPECT_NE(message("s0").find("depth.txt line 2"), std::string::npos);
  std::filesystem::remove(rig / "s0/depth.txt");
  EXPECT_NE(message("s0").find("depth.txt is missing"), std::string::npos);
  put_text(rig / "rig.json", "{\"fps\": 30");
  EXPECT_NE(message("s0").find("rig.json is not valid JSON"), std::string::npos);
  std::filesystem::remove(rig / "rig.json");
  EXPECT_NE(message("s0").find("rig.json is missing"), std::string::npos);
}

TEST(RigSource, values_become_millimetres_and_invalid_ones_zero) {
  const TemporaryFolder folder;
  const auto rig = write_small_rig(folder, 1);
  std::string camera = text_of(rig / "s0/camera.json");
  const std::string scale = "\"depth_scale_to_metre\": 0.001";
  ASSERT_NE(camera.find(scale), std::string::npos);
  camera.replace(camera.find(scale), scale.size(), "\"depth_scale_to_metre\": 0.002");
  camera.replace(camera.find("\"invalid_depth\""), 15, "\"invalid_depth\": [1007], \"unused\"");
  put_text(rig / "s0/camera.json", camera);
  const auto source = open_rig(rig, "s0", kFastOnce);
  ASSERT_TRUE(source);
  source::CapturedFrame frame;
  ASSERT_TRUE(*source->next(frame, {}));
  EXPECT_EQ(frame.depth_mm.at(0, 0), 2000);
  EXPECT_EQ(frame.depth_mm.at(7, 0), 0);  // 1007 in the file
  EXPECT_EQ(frame.depth_mm.at(8, 0), 2016);
}

std::filesystem::path write_tum(const TemporaryFolder& folder) {
  const std::filesystem::path path = folder / "office";
  std::filesystem::create_directories(path / "depth");
  put_text(path / "camera.json", R"({"width": 40, "height": 30, "depth_scale_to_metre": 0.0002,
    "depth_intrinsics": {"fx": 35, "fy": 35, "cx": 19.5, "cy": 14.5},
    "colour_registered_to_depth": true})");
  put_text(path / "depth.txt", "10.00 depth/a.png\n10.10 depth/b.png\n10.20 depth/c.png\n");
  for (const char* name : {"a", "b", "c"}) {
    const auto file = path / "depth" / (std::string(name) + ".png");
    EXPECT_TRUE(io::write_depth_png(file, DepthImage(40, 30, 5000)).ok());
  }
  return path;
}

TEST(TumSource, plays_a_folder_without_colour) {
  const TemporaryFolder folder;
  auto source = open_tum_source(write_tum(folder).string(), kFastOnce);
  ASSERT_TRUE(source.ok()) << source.error().message;
  EXPECT_EQ((*source)->description().name, "office");
  EXPECT_NEAR((*source)->description().fps, 10, 1e-6);
  source::CapturedFrame frame;
  for (std::uint64_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(*(*source)->next(frame, {}));
    EXPECT_EQ(frame.index, i);
    EXPECT_EQ(frame.depth_mm.at(0, 0), 1000);  // 5000 units of 0.2 mm
    EXPECT_TRUE(frame.color.empty());
  }
  EXPECT_FALSE(*(*source)->next(frame, {}));
}

TEST(TumSource, takes_the_colour_nearest_in_time) {
  const TemporaryFolder folder;
  const auto path = write_tum(folder);
  put_text(path / "rgb.txt", "9.99 x.png\n10.04 red.png\n10.17 x.png\n10.22 blue.png\n");
  ASSERT_TRUE(io::write_color_png(path / "x.png", ColorImage(40, 30, {0, 255, 0})).ok());
  ASSERT_TRUE(io::write_color_png(path / "red.png", ColorImage(40, 30, {255, 0, 0})).ok());
  ASSERT_TRUE(io::write_color_png(path / "blue.png", ColorImage(40, 30, {0, 0, 255})).ok());
  auto source = open_tum_source(path.string(), kFastOnce);
  ASSERT_TRUE(source.ok()) << source.error().message;
  source::CapturedFrame frame;
  ASSERT_TRUE(*(*source)->next(frame, {}));
  EXPECT_EQ(frame.color.at(0, 0), (Rgb8{0, 255, 0}));
  ASSERT_TRUE(*(*source)->next(frame, {}));
  EXPECT_TRUE(frame.color.empty());  // nearest is 60 ms away; half a frame is 50 ms
  ASSERT_TRUE(*(*source)->next(frame, {}));
  EXPECT_EQ(frame.color.at(0, 0), (Rgb8{0, 0, 255}));
}

TEST(TumSource, associations_pair_colour_with_depth) {
  const TemporaryFolder folder;
  const auto path = write_tum(folder);
  put_text(path / "associations.txt", "12.0 red.png 10.10 depth/b.png\n");
  ASSERT_TRUE(io::write_color_png(path / "red.png", ColorImage(40, 30, {255, 0, 0})).ok());
  auto source = open_tum_source(path.string(), kFastOnce);
  ASSERT_TRUE(source.ok()) << source.error().message;
  source::CapturedFrame frame;
  ASSERT_TRUE(*(*source)->next(frame, {}));
  EXPECT_TRUE(frame.color.empty());
  ASSERT_TRUE(*(*source)->next(frame, {}));
  EXPECT_EQ(frame.color.at(0, 0), (Rgb8{255, 0, 0}));
}

TEST(TumSource, a_missing_folder_or_camera_is_named) {
  const TemporaryFolder folder;
  const auto path = write_tum(folder);
  std::filesystem::remove(path / "camera.json");
  EXPECT_NE(open_tum_source(path.string(), {}).error().message.find("camera.json is missing"),
            std::string::npos);
  EXPECT_EQ(open_tum_source((folder / "none").string(), {}).error().code, ErrorCode::kNotFound);
}

TEST(Recording, no_sensor_of_a_rig_begins_again_before_all_have_ended) {
  const TemporaryFolder folder;
  std::vector<RigSensor> sensors(2);
  for (const int i : {0, 1}) {
    const std::string name = "s" + std::to_string(i);
    sensors[static_cast<std::size_t>(i)].description = {name, small_calibration(), {}, kSmallFps};
  }
  auto writer = RigWriter::create(folder / "rig", kSmallFps, sensors);
  ASSERT_TRUE(writer.ok());
  for (int i = 0; i < 5; ++i) {  // the second sensor was switched on three frames later
    const auto index = static_cast<std::uint64_t>(i);
    ASSERT_TRUE(writer->add(0, small_frame(0, index), milliseconds(20 * i)).ok());
    ASSERT_TRUE(writer->add(1, small_frame(1, index), milliseconds(20 * (i + 3))).ok());
  }
  ASSERT_TRUE(writer->finish().ok());
  for (const char* sensor : {"s0", "s1"}) {
    const auto recording = read_rig_recording(folder / "rig", sensor);
    ASSERT_TRUE(recording.ok()) << recording.error().message;
    EXPECT_EQ(recording->start, nanoseconds(0)) << sensor;
    EXPECT_EQ(recording->loop_duration, milliseconds(20 * 8)) << sensor;
    EXPECT_LT(recording->frames.back().true_time, recording->start + recording->loop_duration);
  }
}

TEST(Recording, a_rig_loops_after_a_whole_number_of_frames_for_all_sensors) {
  const TemporaryFolder folder;
  const auto rig = write_small_rig(folder);
  const auto s0 = read_rig_recording(rig, "s0");
  const auto s1 = read_rig_recording(rig, "s1");
  ASSERT_TRUE(s0.ok() && s1.ok());
  EXPECT_EQ(s0->loop_duration, milliseconds(100));
  EXPECT_EQ(s1->loop_duration, s0->loop_duration);
  EXPECT_EQ(s1->start, s0->start);
  EXPECT_EQ(s0->start, nanoseconds(100'000'000'000));
}

}  // namespace
}  // namespace roomcast::recording
