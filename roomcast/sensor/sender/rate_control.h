// SPDX-License-Identifier: Apache-2.0
// RateControl: keeps a sensor's bytes at a target rate. A leaky bucket models what still waits for
// the line, which the kernel empties at an even pace. Each frame gets the bytes that bring the
// bucket to a small reserve, so that the line is never idle and frames never wait for long. When
// even the coarsest quality takes too many bytes, the frame rate is halved. Pure; time is an
// argument. Single-threaded.
// Source of the bucket: the leaky bucket as a queue (Turner 1986), as in the hypothetical reference
// decoders of ITU-T H.264, annex C.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/clock.h"

namespace roomcast::sensor {

class RateControl {
 public:
  struct Options {
    double bytes_per_s = 0;  // that TCP carries, headers of TCP and IP not counted
    double fps = 30;         // of the source, until its frames have shown their own rate
    /// What still waits when the next frame is due, so that it may be late: the larger of both.
    double reserve_s = 0.06, reserve_frames = 0.6;
  };
  /// The kernel's pace is above the target, so that saved bytes can still be spent.
  static constexpr double kPaceMargin = 1.03;
  /// Frames are sent at the source's rate, or at this fraction of it.
  static constexpr int kMaxDivisor = 8;

  explicit RateControl(const Options& options);

  /// What the line carries from now on, and what really waits for it. Call before next_frame().
  void follow_line(double bytes_per_s, double waiting_bytes) {
    options_.bytes_per_s = bytes_per_s;
    line_waiting_bytes_ = waiting_bytes;
  }

  /// Another target from now on. Call before next_frame().
  void set_rate(double bytes_per_s) { options_.bytes_per_s = bytes_per_s; }

  struct Plan {
    codec::FrameTarget target;
    bool wants_key = false;
  };
  /// Call for each frame of the source. Nothing: do not send it. `control_bytes`: all that was sent
  /// besides frames since the program began.
  [[nodiscard]] std::optional<Plan> next_frame(HostTime now, std::uint64_t control_bytes);
  /// The frame of the last plan was sent.
  void sent(std::size_t bytes, const codec::EncodedFrameInfo& info);

  /// Time that a byte sent now would wait for the line, by the model; below 0: bytes are saved.
  [[nodiscard]] double waiting_s() const { return waiting_bytes_ / options_.bytes_per_s; }
  /// Every so many frames of the source one is sent.
  [[nodiscard]] int divisor() const { return 1 << halved_at_.size(); }

 private:
  void drain(HostTime now);
  void learn_interval(HostTime now);
  [[nodiscard]] double frame_interval_s() const { return source_interval_s_ * divisor(); }
  [[nodiscard]] double reserve_s() const;
  [[nodiscard]] bool is_due();
  void choose_divisor(HostTime now);

  Options options_;
  double source_interval_s_;
  std::optional<HostTime> last_frame_;  // of the source
  double waiting_bytes_ = 0;
  std::optional<double> line_waiting_bytes_;  // known, not modelled
  std::uint64_t control_bytes_ = 0;
  std::vector<double> halved_at_;  // bytes_per_s at each halving of the frame rate
  int since_sent_ = 0;             // frames of the source
  bool is_squeezed_ = false;       // the newest plan: earlier frames took its share
  int quantizer_ = 0;              // of the newest frame; 0: unknown
  std::optional<HostTime> coarse_since_, fine_since_;
  std::optional<HostTime> next_key_;
};

}  // namespace roomcast::sensor
