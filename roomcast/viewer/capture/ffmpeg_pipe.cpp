// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "roomcast/core/child_program.h"
#include "roomcast/viewer/capture/video_sink.h"

namespace roomcast::viewer {
namespace {

Error ffmpeg_failed(const std::string& what) {
  return {ErrorCode::kUnavailable, "the video could not be written: " + what};
}

std::vector<std::string> ffmpeg_command(const std::filesystem::path& file, PictureSize size,
                                        int fps) {
  return {"ffmpeg", "-loglevel", "error", "-nostdin", "-y", "-f", "rawvideo", "-pixel_format",
          "rgb24", "-video_size", fmt::format("{}x{}", size.width, size.height), "-framerate",
          std::to_string(fps), "-i", "pipe:0",
          // Players need even sides and this pixel format.
          "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", file.string()};
}

/// For its lifetime, writing to a program that has ended gives an error instead of ending this
/// process.
class NoBrokenPipeSignal {
 public:
  NoBrokenPipeSignal() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~NoBrokenPipeSignal() {
    const timespec at_once{};
    while (sigtimedwait(&pipe_, nullptr, &at_once) > 0) {
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoBrokenPipeSignal(const NoBrokenPipeSignal&) = delete;
  NoBrokenPipeSignal& operator=(const NoBrokenPipeSignal&) = delete;

 private:
  sigset_t pipe_{}, before_{};
};

class FfmpegPipe final : public VideoSink {
 public:
  FfmpegPipe(pid_t pid, int pipe) : pid_(pid), pipe_(pipe) {}
  ~FfmpegPipe() override { static_cast<void>(finish()); }

  Status write(ColorView frame) override {
    const NoBrokenPipeSignal guard;
    for (int y = 0; y < frame.height; ++y) {
      if (auto status =
              write_bytes(frame.row(y), sizeof(Rgb8) * static_cast<std::size_t>(frame.width));
          !status)
        return status;
    }
    return {};
  }

  Status finish() override {
    if (pid_ == 0) return {};
    ::close(pipe_);
    const int state = wait_for_program(std::exchange(pid_, 0));
    if (WIFEXITED(state) && WEXITSTATUS(state) == 0) return {};
    return ffmpeg_failed("ffmpeg ended with a fault");
  }

 private:
  Status write_bytes(const void* data, std::size_t size) const {
    const auto* next = static_cast<const char*>(data);
    while (size > 0) {
      const ssize_t written = ::write(pipe_, next, size);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return ffmpeg_failed("ffmpeg has ended early");
      next += written;
      size -= static_cast<std::size_t>(written);
    }
    return {};
  }

  pid_t pid_;
  int pipe_;
};

}  // namespace

bool is_on_path(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

Result<std::unique_ptr<VideoSink>> open_ffmpeg(const std::filesystem::path& file, PictureSize size,
                                               int fps) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return ffmpeg_failed("there is no pipe to be had");
  const auto pid =
      start_program(ffmpeg_command(file, size, fps), {.input = ends[0], .shares_stderr = true});
  ::close(ends[0]);
  if (pid) return std::unique_ptr<VideoSink>(std::make_unique<FfmpegPipe>(*pid, ends[1]));
  ::close(ends[1]);
  return ffmpeg_failed("ffmpeg does not start");
}

}  // namespace roomcast::viewer
