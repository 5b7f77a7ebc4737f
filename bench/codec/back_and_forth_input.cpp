// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/back_and_forth_input.h"

#include <vector>

#include "bench/codec/measure/still_surfaces.h"

namespace roomcast::bench {
namespace {

struct KnownFrame {
  BenchFrame frame;
  BenchTruth truth;
};

class BackAndForthInput final : public BenchInput {
 public:
  BackAndForthInput(std::unique_ptr<BenchInput> recording, double fps,
                    std::vector<KnownFrame> frames)
      : recording_(std::move(recording)), fps_(fps), frames_(std::move(frames)) {
    std::vector<DepthView> depth;
    for (const KnownFrame& known : frames_) depth.push_back(known.frame.depth_mm);
    still_mm_ = median_of_still(depth);
  }

  std::string name() const override { return recording_->name() + ", back and forth"; }
  double fps() const override { return fps_; }
  ColorReference color_reference() const override { return recording_->color_reference(); }

  Result<bool> next(BenchFrame& frame, BenchTruth& truth) override {
    frame = frames_[at_].frame;
    truth = frames_[at_].truth;
    truth.still_mm = still_mm_;
    if (frames_.size() == 1) return true;
    if (at_ + 1 == frames_.size()) forward_ = false;
    if (at_ == 0) forward_ = true;
    at_ = forward_ ? at_ + 1 : at_ - 1;
    return true;
  }

 private:
  const std::unique_ptr<BenchInput> recording_;
  const double fps_;
  const std::vector<KnownFrame> frames_;
  DepthImage still_mm_;
  std::size_t at_ = 0;  // index of the next one
  bool forward_ = true;
};

}  // namespace

Result<std::unique_ptr<BenchInput>> play_back_and_forth(std::unique_ptr<BenchInput> recording,
                                                        double fps) {
  std::vector<KnownFrame> frames;
  while (frames.size() < kMaxFramesBackAndForth) {
    KnownFrame known;
    const auto more = recording->next(known.frame, known.truth);
    if (!more.ok()) return more.error();
    if (!*more) break;
    if (!frames.empty() &&
        !same_size(known.frame.depth_mm.view(), frames[0].frame.depth_mm.view())) {
      return Error{ErrorCode::kInvalidArgument,
                   "The frames of " + recording->name() + " differ in size."};
    }
    frames.push_back(std::move(known));
  }
  if (frames.empty()) {
    return Error{ErrorCode::kInvalidArgument, recording->name() + " has no frame to measure."};
  }
  return std::unique_ptr<BenchInput>(
      std::make_unique<BackAndForthInput>(std::move(recording), fps, std::move(frames)));
}

}  // namespace roomcast::bench
