// SPDX-License-Identifier: Apache-2.0
// StatusLine: one line on a terminal that is written over; nothing at all where stderr is not a
// terminal. For long work it shows a bar with the time that is left.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace roomcast::cli {

class StatusLine {
 public:
  StatusLine();
  ~StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  void show(std::string_view text);

  /// `done` of `total` steps of something ("writing frames"). Another name starts the clock anew.
  /// Cheap enough to be called after every step.
  void show_progress(std::string_view doing, int done, int total);

 private:
  using Clock = std::chrono::steady_clock;

  const bool on_terminal_;
  bool shown_ = false;
  std::string doing_;
  Clock::time_point began_, shown_at_;
};

/// "writing frames [######--------------] 135 of 450, 12 s left"; without the time while it cannot
/// be told: before the first step, and in the first moments.
[[nodiscard]] std::string progress_text(std::string_view doing, int done, int total,
                                        std::chrono::duration<double> elapsed);

}  // namespace roomcast::cli
