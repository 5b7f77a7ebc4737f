// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/recorded_input.h"

#include <cstdio>
#include <deque>
#include <vector>

#include "bench/codec/measure/temporal_mean.h"
#include "roomcast/geometry/registration.h"
#include "roomcast/source/image_file.h"
#include "roomcast/source/source_factory.h"

namespace roomcast::bench {
namespace {

namespace fs = std::filesystem;

class RecordedInput final : public BenchInput {
 public:
  RecordedInput(std::string name, std::unique_ptr<FrameSource> source, Registration registration,
                fs::path truth)
      : name_(std::move(name)),
        source_(std::move(source)),
        registration_(std::move(registration)),
        truth_(std::move(truth)) {}

  std::string name() const override { return name_; }
  double fps() const override { return source_->description().fps; }
  ColorReference color_reference() const override { return ColorReference::kDenoised; }

  Result<bool> next(BenchFrame& frame, BenchTruth& truth) override {
    if (Status s = look_ahead(); !s.ok()) return s.error();
    if (at_ == frames_.size()) return false;
    const Recorded& now = frames_[at_];
    frame = now.frame;
    denoise(truth.color);
    if (Status s = read_truth(now.index, truth.depth_mm); !s.ok()) return s.error();
    if (at_ == kMeanReach) {
      frames_.pop_front();
    } else {
      ++at_;
    }
    return true;
  }

 private:
  struct Recorded {
    std::uint64_t index = 0;
    BenchFrame frame;
  };

  /// Reads until kMeanReach frames after the next one are known, or the recording ends.
  Status look_ahead() {
    while (!ended_ && frames_.size() <= at_ + kMeanReach) {
      auto more = source_->next(captured_, {});
      if (!more.ok()) return more.error();
      ended_ = !*more;
      if (ended_) break;
      Recorded& newest = frames_.emplace_back();
      newest.index = captured_.index;
      newest.frame.depth_mm = captured_.depth_mm;
      if (captured_.color.empty()) continue;
      if (Status s = registration_.run(captured_.depth_mm, captured_.color, registered_); !s.ok())
        return s;
      newest.frame.color = registered_.color;
      newest.frame.seen = registered_.seen;
    }
    return {};
  }

  void denoise(ColorImage& out) const {
    const BenchFrame& now = frames_[at_].frame;
    if (now.color.empty()) {
      out = {};
      return;
    }
    std::vector<SeenColor> around;
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      const BenchFrame& other = frames_[i].frame;
      if (i != at_ && !other.color.empty()) around.push_back({other.color, other.seen});
    }
    temporal_mean({now.color, now.seen}, around, out);
  }

  Status read_truth(std::uint64_t index, DepthImage& depth_mm) {
    char file[32];
    std::snprintf(file, sizeof file, "%06llu.png", static_cast<unsigned long long>(index));
    std::error_code ignored;
    if (truth_.empty() || !fs::exists(truth_ / file, ignored)) {
      depth_mm = {};
      return {};
    }
    const CameraIntrinsics& camera = source_->description().calibration.depth;
    return reader_.read_depth(truth_ / file, {camera.width, camera.height}, depth_mm);
  }

  const std::string name_;
  std::unique_ptr<FrameSource> source_;
  Registration registration_;
  const fs::path truth_;
  ImageFileReader reader_;
  CapturedFrame captured_;
  RegisteredColor registered_;
  std::deque<Recorded> frames_;  // up to kMeanReach before and after the next
  std::size_t at_ = 0;           // the next one
  bool ended_ = false;
};

}  // namespace

Result<std::unique_ptr<BenchInput>> open_recorded_input(const std::string& source,
                                                        const fs::path& truth) {
  auto opened = open_source(source, {.pace = Pace::kAsFastAsPossible, .loop = false});
  if (!opened.ok()) return opened.error();
  auto registration = Registration::create((*opened)->description().calibration);
  if (!registration.ok()) return registration.error();
  return std::unique_ptr<BenchInput>(
      std::make_unique<RecordedInput>(source, std::move(*opened), std::move(*registration), truth));
}

}  // namespace roomcast::bench
