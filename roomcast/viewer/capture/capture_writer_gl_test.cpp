// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/render/gl/gl_fixture.h"
#include "roomcast/viewer/capture/capture_writer.h"

namespace roomcast::viewer {
namespace {

using namespace std::chrono_literals;

class CaptureWriterTest : public render::GlTest {
 protected:
  void SetUp() override {
    render::GlTest::SetUp();
    ::setenv("PATH", folder.path().c_str(), 1);  // without ffmpeg
    picture.emplace(*render::OffscreenTarget::create(8, 6));
    picture->clear({1, 2, 3});
  }
  void TearDown() override {
    ::setenv("PATH", path.c_str(), 1);
    picture.reset();
    render::GlTest::TearDown();
  }

  Status write(const std::filesystem::path& file, ColorView shown) {
    if (disk_is_full) return Error{ErrorCode::kUnavailable, "the disk is full"};
    EXPECT_EQ(shown.at(0, 0), (Rgb8{1, 2, 3}));
    written.push_back(file.filename().string());
    return {};
  }

  const std::string path = std::getenv("PATH");
  TemporaryFolder folder;
  std::vector<std::string> written;
  bool disk_is_full = false;
  std::optional<render::OffscreenTarget> picture;
  CaptureWriter writer{folder.path(),
                       [this](const auto& file, ColorView shown) { return write(file, shown); }};
};

TEST_F(CaptureWriterTest, reports_where_a_screenshot_is) {
  const Toast toast = writer.save(*picture, "lab");
  EXPECT_EQ(toast.kind, Toast::Kind::kGood);
  EXPECT_NE(toast.sentence.find("roomcast-lab-0001.png"), std::string::npos);
  EXPECT_EQ(written, std::vector<std::string>{"roomcast-lab-0001.png"});
}

TEST_F(CaptureWriterTest, reports_why_a_screenshot_failed) {
  disk_is_full = true;
  const Toast toast = writer.save(*picture, "lab");
  EXPECT_EQ(toast.kind, Toast::Kind::kError);
  EXPECT_EQ(toast.sentence, "the disk is full");
}

TEST_F(CaptureWriterTest, records_until_it_is_stopped) {
  EXPECT_NE(writer.start_video(*picture, "lab").sentence.find("ffmpeg"), std::string::npos);
  EXPECT_TRUE(writer.is_recording());
  EXPECT_TRUE(writer.record(*picture, HostTime(1h)));
  EXPECT_TRUE(writer.record(*picture, HostTime(1h + 34ms)));
  EXPECT_EQ(writer.stop_video().kind, Toast::Kind::kGood);
  EXPECT_FALSE(writer.is_recording());
  EXPECT_EQ(written, (std::vector<std::string>{"frame-000001.png", "frame-000002.png"}));
}

TEST_F(CaptureWriterTest, a_video_does_not_change_its_size) {
  writer.start_video(*picture, "lab");
  auto larger = render::OffscreenTarget::create(10, 6);
  EXPECT_FALSE(writer.record(*larger, HostTime(1h)));
  EXPECT_EQ(writer.stop_video().kind, Toast::Kind::kGood);
}

}  // namespace
}  // namespace roomcast::viewer
