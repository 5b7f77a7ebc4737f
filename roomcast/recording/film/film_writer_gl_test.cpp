// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/recording/export/wall_fixture.h"
#include "roomcast/recording/film/film_writer.h"

namespace roomcast::recording {
namespace {

using namespace std::chrono_literals;

class KeepingSink final : public viewer::VideoSink {
 public:
  explicit KeepingSink(std::vector<ColorImage>& pictures) : pictures_(pictures) {}
  Status write(ColorView frame) override {
    ColorImage picture(frame.width, frame.height);
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x) picture.at(x, y) = frame.at(x, y);
    pictures_.push_back(std::move(picture));
    return {};
  }
  Status finish() override { return {}; }

 private:
  std::vector<ColorImage>& pictures_;
};

/// A set in which the near sensor's view has one colour.
FrameSet set_at(nanoseconds time, Rgb8 color) {
  FrameSet set = wall_set();
  set.time = time;
  set.frames.resize(1);
  auto pictures = std::make_shared<codec::DecodedFrame>(*set.frames[0].pictures);
  pictures->color = ColorImage(64, 48, color);
  set.frames[0].pictures = std::move(pictures);
  return set;
}

constexpr Rgb8 kRed{200, 0, 0}, kBlue{0, 0, 200};

class FilmTest : public testing::Test {
 protected:
  std::unique_ptr<FilmWriter> film(CameraPath path) {
    FilmOptions options;
    options.size = {64, 48};
    options.fps = 20;
    options.mode = render::RenderMode::kMesh;
    options.path = std::move(path);
    auto writer =
        FilmWriter::create(wall_sensors(), options, std::make_unique<KeepingSink>(pictures_));
    EXPECT_TRUE(writer.ok()) << writer.error().message;
    return std::move(*writer);
  }
  static CameraPath still() { return *CameraPath::create({{0, {0, 1, 0}, {0, 1, -2}}}); }
  [[nodiscard]] Rgb8 middle(std::size_t picture) const { return pictures_.at(picture).at(32, 24); }
  std::vector<ColorImage> pictures_;
};

TEST_F(FilmTest, every_picture_shows_the_newest_set_of_its_moment) {
  const auto writer = film(still());
  ASSERT_TRUE(writer->add(set_at(10s, kRed)).ok());
  ASSERT_TRUE(writer->add(set_at(10s + 120ms, kBlue)).ok());
  ASSERT_TRUE(writer->finish().ok());
  ASSERT_EQ(pictures_.size(), 4u) << "at 0, 50 and 100 ms, and one for the last set";
  EXPECT_EQ(writer->totals().pictures, 4u);
  EXPECT_EQ(middle(0), kRed);
  EXPECT_EQ(middle(2), kRed);
  EXPECT_EQ(middle(3), kBlue);
}

TEST_F(FilmTest, the_camera_moves_while_the_room_is_paused) {
  const auto writer =
      film(*CameraPath::create({{0, {0, 1, 0}, {0, 1, -2}}, {1, {0, 1, 0}, {2, 1, 0}}}));
  ASSERT_TRUE(writer->add(set_at(0s, kRed)).ok());
  ASSERT_TRUE(writer->add(set_at(1s, kRed)).ok());
  ASSERT_TRUE(writer->finish().ok());
  ASSERT_EQ(pictures_.size(), 21u);
  EXPECT_EQ(middle(0), kRed);
  EXPECT_NE(middle(20), kRed) << "looks past the wall by then";
}

TEST_F(FilmTest, a_sensor_that_is_gone_is_not_shown) {
  const auto writer = film(still());
  ASSERT_TRUE(writer->add(set_at(0s, kRed)).ok());
  FrameSet empty = set_at(50ms, kRed);
  empty.frames.clear();
  ASSERT_TRUE(writer->add(empty).ok());
  ASSERT_TRUE(writer->finish().ok());
  ASSERT_EQ(pictures_.size(), 2u);
  EXPECT_NE(middle(1), kRed);
}

TEST_F(FilmTest, without_a_path_it_looks_at_the_view_of_the_first_sensor) {
  FilmOptions options;
  options.size = {64, 48};
  options.length_s = 1;
  options.mode = render::RenderMode::kMesh;
  auto writer =
      FilmWriter::create(wall_sensors(), options, std::make_unique<KeepingSink>(pictures_));
  ASSERT_TRUE((*writer)->add(set_at(0s, kRed)).ok());
  ASSERT_TRUE((*writer)->finish().ok());
  EXPECT_EQ(middle(0), kRed);
}

TEST_F(FilmTest, refuses_a_size_that_is_none) {
  FilmOptions options;
  options.size = {0, 48};
  EXPECT_FALSE(
      FilmWriter::create(wall_sensors(), options, std::make_unique<KeepingSink>(pictures_)).ok());
}

}  // namespace
}  // namespace roomcast::recording
