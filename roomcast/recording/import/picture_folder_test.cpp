// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/picture_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/io/camera_json.h"
#include "roomcast/recording/dataset/recording_fixture.h"

namespace roomcast::recording {
namespace {

const std::string kSensor = R"([[sensor]]
name = "left"
depth = "d"
color = "c"
fps = 10
depth_camera = {width = 3, height = 2, fx = 5, fy = 5, cx = 1, cy = 0.5, k1 = 0.1}
color_camera = {width = 4, height = 2, fx = 6, fy = 6, cx = 1.5, cy = 0.5}
color_from_depth = [1, 0, 0, -0.05,  0, 1, 0, 0,  0, 0, 1, 0,  0, 0, 0, 1]
depth_scale_to_metre = 0.0002
)";

class PictureFolder : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"d", "c"}) std::filesystem::create_directories(folder_ / name);
    for (int i = 0; i < 3; ++i) {
      const std::string number = std::to_string(7 + i);
      const DepthImage depth(3, 2, static_cast<std::uint16_t>(5000 + 500 * i));
      const ColorImage color(4, 2, {static_cast<std::uint8_t>(50 * i), 0, 0});
      ASSERT_TRUE(io::write_depth_png(folder_ / ("d/" + number + ".png"), depth).ok());
      ASSERT_TRUE(io::write_color_png(folder_ / ("c/" + number + ".png"), color).ok());
    }
    put_text(folder_ / "recording.toml", kSensor);
  }
  Error refused() {
    const auto files = open_picture_folder(folder_.path());
    EXPECT_FALSE(files.ok());
    return files.ok() ? Error{} : files.error();
  }
  void replace(const std::string& what, const std::string& by) {
    std::string text = kSensor;
    text.replace(text.find(what), what.size(), by);
    put_text(folder_ / "recording.toml", text);
  }

  TemporaryFolder folder_;
};

TEST_F(PictureFolder, its_pictures_are_read_in_the_order_of_their_names) {
  const auto files = open_picture_folder(folder_.path());
  ASSERT_TRUE(files.ok()) << files.error().message;
  SensorFile& file = *(*files)[0];
  EXPECT_EQ(file.info().description.name, "left");
  EXPECT_EQ(file.info().times[2], std::chrono::milliseconds(200));
  EXPECT_EQ(file.info().description.calibration.depth.k1, 0.1);
  DepthImage depth;
  ColorImage color;
  ASSERT_TRUE(file.read_depth(2, depth).ok());
  ASSERT_TRUE(file.read_color(2, color).ok());
  EXPECT_EQ(depth.at(0, 0), 1200);  // 6000 * 0.2 mm
  EXPECT_EQ(color.at(3, 1).r, 100);
}

TEST_F(PictureFolder, times_may_be_in_a_file) {
  replace("fps = 10", "times = \"times.txt\"");
  put_text(folder_ / "times.txt", "# seconds\n1700000000.5\n1700000000.6\r\n1700000000.9\n");
  const auto files = open_picture_folder(folder_ / "recording.toml");
  ASSERT_TRUE(files.ok()) << files.error().message;
  EXPECT_EQ((*files)[0]->info().times[2], nanoseconds(1'700'000'000'900'000'000));
  EXPECT_TRUE((*files)[0]->info().clock.utc_minus_device);
  put_text(folder_ / "times.txt", "1\n3\n2\n");
  EXPECT_THAT(refused().message, testing::HasSubstr("times.txt"));
  put_text(folder_ / "times.txt", "1\n");
  EXPECT_THAT(refused().message, testing::HasSubstr("1 times for 3"));
}

TEST_F(PictureFolder, cameras_may_be_those_of_a_camera_json) {
  std::string text = kSensor.substr(0, kSensor.find("depth_camera")) + "camera = \"camera.json\"\n";
  put_text(folder_ / "recording.toml", text);
  EXPECT_EQ(refused().code, ErrorCode::kNotFound);
  SensorCalibration calibration = small_calibration();
  calibration.depth = {3, 2, 3, 3, 1, 0.5};
  put_text(folder_ / "camera.json", io::camera_json_text(calibration));
  EXPECT_TRUE(open_picture_folder(folder_.path()).ok());
}

TEST_F(PictureFolder, what_is_wrong_is_named) {
  replace("fps = 10", "fps = \"fast\"");
  EXPECT_THAT(refused().message, testing::HasSubstr("sensor 1.fps must be"));
  replace("width = 3", "width = 0");
  EXPECT_THAT(refused().message, testing::HasSubstr("depth_camera.width"));
  replace("depth = \"d\"", "depth = \"../d\"");
  EXPECT_THAT(refused().message, testing::HasSubstr("inside"));
  replace("[1, 0, 0, -0.05,", "[9, 0, 0, -0.05,");
  EXPECT_THAT(refused().message, testing::HasSubstr("color_from_depth"));
  replace("[[sensor]]", "[sensor]");
  EXPECT_THAT(refused().message, testing::HasSubstr("[[sensor]]"));
  replace("name", "name = = ");
  EXPECT_THAT(refused().message, testing::HasSubstr("line 2"));
  replace("depth = \"d\"", "depth = \"e\"");
  EXPECT_EQ(refused().code, ErrorCode::kNotFound);
  std::filesystem::remove(folder_ / "c/7.png");
  put_text(folder_ / "recording.toml", kSensor);
  EXPECT_THAT(refused().message, testing::HasSubstr("3 depth pictures, but 2"));
  std::filesystem::remove(folder_ / "recording.toml");
  EXPECT_EQ(refused().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::recording
