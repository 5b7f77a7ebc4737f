// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <fmt/format.h>

#include "roomcast/viewer/capture/video_sink.h"

namespace roomcast::viewer {
namespace {

class PngSequence final : public VideoSink {
 public:
  PngSequence(std::filesystem::path folder, io::PictureWriter write)
      : folder_(std::move(folder)), write_(std::move(write)) {}

  Status write(ColorView frame) override {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    return write_(folder_ / fmt::format("frame-{:06}.png", ++count_), frame);
  }
  Status finish() override { return {}; }

 private:
  std::filesystem::path folder_;
  io::PictureWriter write_;
  int count_ = 0;
};

}  // namespace

std::unique_ptr<VideoSink> open_png_sequence(const std::filesystem::path& folder,
                                             io::PictureWriter write) {
  return std::make_unique<PngSequence>(folder, std::move(write));
}

}  // namespace roomcast::viewer
