// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/capture/video_recorder.h"

#include <cstdlib>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/viewer/capture/open_video.h"
#include "roomcast/viewer/report/host_time_fixture.h"

namespace roomcast::viewer {
namespace {

using namespace std::chrono_literals;

ColorImage gray(std::uint8_t level) {
  return {4, 3, Rgb8{level, level, level}};
}

class NotingSink final : public VideoSink {
 public:
  explicit NotingSink(std::vector<int>& levels) : levels_(levels) {}
  Status write(ColorView frame) override {
    if (levels_.size() >= fails_after) return Error{ErrorCode::kUnavailable, "the disk is full"};
    levels_.push_back(frame.at(0, 0).r);
    return {};
  }
  Status finish() override { return {}; }

  std::size_t fails_after = 1000;

 private:
  std::vector<int>& levels_;
};

TEST(FramePace, is_as_steady_as_its_video) {
  FramePace pace(30);
  EXPECT_EQ(pace.due(at(0s)), 1);
  EXPECT_EQ(pace.due(at(20ms)), 0) << "too soon";
  EXPECT_EQ(pace.due(at(40ms)), 1);
  EXPECT_EQ(pace.due(at(1s)), 29) << "nothing was shown for a while";
  EXPECT_EQ(pace.due(at(10h)), VideoRecorder::kLongestStill);
}

TEST(VideoRecorder, writes_the_offered_pictures_in_order) {
  std::vector<int> levels;
  VideoRecorder recorder(std::make_unique<NotingSink>(levels));
  ASSERT_TRUE(recorder.wants_frame(at(0s)));
  recorder.offer(gray(1));
  EXPECT_FALSE(recorder.wants_frame(at(1ms)));
  ASSERT_TRUE(recorder.wants_frame(at(101ms)));
  recorder.offer(gray(2));
  EXPECT_TRUE(recorder.finish().ok());
  EXPECT_EQ(levels, (std::vector<int>{1, 2, 2, 2}));
}

TEST(VideoRecorder, reports_why_writing_failed) {
  std::vector<int> levels;
  auto sink = std::make_unique<NotingSink>(levels);
  sink->fails_after = 1;
  VideoRecorder recorder(std::move(sink));
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(recorder.wants_frame(at(i * 1s)));
    recorder.offer(gray(1));
  }
  const Status finished = recorder.finish();
  ASSERT_FALSE(finished.ok());
  EXPECT_EQ(finished.error().message, "the disk is full");
  EXPECT_TRUE(recorder.has_failed());
  EXPECT_EQ(levels.size(), 1U);
}

TEST(PngSequence, numbers_its_pictures) {
  const TemporaryFolder folder;
  std::vector<std::string> names;
  auto sequence = open_png_sequence(folder.path() / "video", [&](const auto& path, ColorView) {
    names.push_back(path.filename().string());
    return Status{};
  });
  EXPECT_TRUE(sequence->write(gray(0)).ok());
  EXPECT_TRUE(sequence->write(gray(0)).ok());
  EXPECT_TRUE(sequence->finish().ok());
  EXPECT_EQ(names, (std::vector<std::string>{"frame-000001.png", "frame-000002.png"}));
}

/// A fake ffmpeg on the PATH: keeps its arguments and its input.
class FakeFfmpeg {
 public:
  explicit FakeFfmpeg(const std::string& script) {
    const auto file = folder_.path() / "ffmpeg";
    std::ofstream(file) << "#!/bin/sh\n" << script;
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    ::setenv("PATH", (folder_.path().string() + ":" + before_).c_str(), 1);
  }
  ~FakeFfmpeg() { ::setenv("PATH", before_.c_str(), 1); }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const {
    return folder_.path() / name;
  }

 private:
  TemporaryFolder folder_;
  std::string before_ = std::getenv("PATH");
};

TEST(Ffmpeg, is_given_every_pixel_and_is_waited_for) {
  const FakeFfmpeg ffmpeg(
      "for last; do :; done\ncat > \"$last\"\necho \"$@\" > \"$last.arguments\"\n");
  EXPECT_TRUE(is_on_path("ffmpeg"));
  const auto file = ffmpeg.file("it's a video.mp4");
  auto sink = open_ffmpeg(file, {4, 3}, 30);
  ASSERT_TRUE(sink.ok());
  EXPECT_TRUE((*sink)->write(gray(7)).ok());
  EXPECT_TRUE((*sink)->write(gray(9)).ok());
  EXPECT_TRUE((*sink)->finish().ok());
  std::ifstream written(file, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(written), {});
  EXPECT_EQ(bytes, std::string(36, '\7') + std::string(36, '\11'));
  std::ifstream kept(file.string() + ".arguments");
  const std::string arguments(std::istreambuf_iterator<char>(kept), {});
  EXPECT_NE(arguments.find("-video_size 4x3 -framerate 30"), std::string::npos);
}

TEST(OpenVideo, is_a_file_where_there_is_ffmpeg_and_else_a_folder) {
  const TemporaryFolder folder;
  {
    const FakeFfmpeg ffmpeg("cat > /dev/null\n");
    auto video = open_video(folder.path(), "roomcast-lab", {4, 3}, {});
    ASSERT_TRUE(video.ok());
    EXPECT_EQ(video->path.filename(), "roomcast-lab-0001.mp4");
    EXPECT_TRUE(video->note.empty());
    EXPECT_TRUE(video->sink->finish().ok());
  }
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.path().c_str(), 1);  // without ffmpeg
  auto video = open_video(folder.path(), "roomcast-lab", {4, 3}, {});
  ::setenv("PATH", path.c_str(), 1);
  ASSERT_TRUE(video.ok());
  EXPECT_EQ(video->path.filename(), "roomcast-lab-0001-video");
  EXPECT_NE(video->note.find("ffmpeg is not installed"), std::string::npos);
}

TEST(Ffmpeg, that_ends_early_is_an_error_and_not_our_end) {
  const FakeFfmpeg ffmpeg("exit 3\n");
  auto sink = open_ffmpeg(ffmpeg.file("video.mp4"), {4, 3}, 30);
  ASSERT_TRUE(sink.ok());
  Status written;
  for (int i = 0; i < 100'000 && written; ++i) written = (*sink)->write(gray(7));
  EXPECT_FALSE(written.ok());
  EXPECT_FALSE((*sink)->finish().ok());
}

TEST(Ffmpeg, is_looked_for_on_the_path) {
  EXPECT_FALSE(is_on_path("no-such-program-of-roomcast"));
}

}  // namespace
}  // namespace roomcast::viewer
