// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/recorded_input.h"

#include <cstdio>
#include <deque>
#include <vector>

#include "bench/codec/measure/temporal_mean.h"
#include "roomcast/geometry/registration.h"
#include "roomcast/io/image_file.h"
#include "roomcast/sensor/source_factory.h"

namespace roomcast::bench {
namespace {

namespace fs = std::filesystem;

/// The folder with a recording's ground truth; any part of it may be missing.
class TruthFolder {
 public:
  TruthFolder(fs::path folder, const SensorCalibration& calibration)
      : folder_(std::move(folder)), calibration_(calibration) {}

  [[nodiscard]] bool has_color() const {
    std::error_code ignored;
    return !folder_.empty() && fs::is_directory(folder_ / "color", ignored);
  }
  /// Leaves the image empty where there is no file.
  Status read_depth(std::uint64_t index, DepthImage& depth_mm) {
    const fs::path file = folder_ / file_name(index, "png");
    depth_mm = {};
    std::error_code ignored;
    if (folder_.empty() || !fs::exists(file, ignored)) return {};
    return reader_.read_depth(file, {calibration_.depth.width, calibration_.depth.height},
                              depth_mm);
  }
  Status read_color(std::uint64_t index, ColorImage& color) {
    return reader_.read_color(folder_ / "color" / file_name(index, "jpg"),
                              {calibration_.color.width, calibration_.color.height}, color);
  }

 private:
  static std::string file_name(std::uint64_t index, const char* kind) {
    char name[32];
    std::snprintf(name, sizeof name, "%06llu.%s", static_cast<unsigned long long>(index), kind);
    return name;
  }

  const fs::path folder_;
  const SensorCalibration calibration_;
  io::ImageFileReader reader_;
};

class RecordedInput final : public BenchInput {
 public:
  RecordedInput(std::string name, std::unique_ptr<source::FrameSource> source,
                Registration registration, const fs::path& truth)
      : name_(std::move(name)),
        source_(std::move(source)),
        registration_(std::move(registration)),
        truth_(truth, source_->description().calibration) {}

  std::string name() const override { return name_; }
  double fps() const override { return source_->description().fps; }
  ColorReference color_reference() const override {
    return truth_.has_color() ? ColorReference::kClean : ColorReference::kDenoised;
  }

  Result<bool> next(BenchFrame& frame, BenchTruth& truth) override {
    if (Status s = look_ahead(); !s.ok()) return s.error();
    if (at_ == frames_.size()) return false;
    const Recorded& now = frames_[at_];
    frame = now.frame;
    if (Status s = truth_.read_depth(now.index, truth.depth_mm); !s.ok()) return s.error();
    if (Status s = make_reference(now, truth.color); !s.ok()) return s.error();
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

  /// Reads until kMeanReach frames after the next one are available, or the recording ends.
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

  Status make_reference(const Recorded& now, ColorImage& out) {
    out = {};
    if (now.frame.color.empty()) return {};
    if (!truth_.has_color()) {
      denoise(now.frame, out);
      return {};
    }
    if (Status s = truth_.read_color(now.index, clean_); !s.ok()) return s;
    if (Status s = registration_.run(now.frame.depth_mm, clean_, registered_); !s.ok()) return s;
    out = registered_.color;
    return {};
  }

  void denoise(const BenchFrame& now, ColorImage& out) const {
    std::vector<SeenColor> around;
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      const BenchFrame& other = frames_[i].frame;
      if (i != at_ && !other.color.empty()) around.push_back({other.color, other.seen});
    }
    temporal_mean({now.color, now.seen}, around, out);
  }

  const std::string name_;
  std::unique_ptr<source::FrameSource> source_;
  Registration registration_;
  TruthFolder truth_;
  source::CapturedFrame captured_;
  ColorImage clean_;
  RegisteredColor registered_;
  std::deque<Recorded> frames_;  // up to kMeanReach before and after the next one
  std::size_t at_ = 0;           // index of the next one
  bool ended_ = false;
};

}  // namespace

Result<std::unique_ptr<BenchInput>> open_recorded_input(const std::string& source,
                                                        const fs::path& truth) {
  auto opened =
      sensor::open_source(source, {.pace = source::Pace::kAsFastAsPossible, .loop = false});
  if (!opened.ok()) return opened.error();
  auto registration = Registration::create((*opened)->description().calibration);
  if (!registration.ok()) return registration.error();
  return std::unique_ptr<BenchInput>(
      std::make_unique<RecordedInput>(source, std::move(*opened), std::move(*registration), truth));
}

}  // namespace roomcast::bench
