// SPDX-License-Identifier: Apache-2.0
// StatusLine: one terminal line that is overwritten, with a progress bar and the remaining time for
// long work. Prints nothing where stderr is not a terminal.
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

  /// Shows `done` of `total` steps of `doing` ("writing frames"). A different `doing` restarts the
  /// clock. Cheap enough to call after every step.
  void show_progress(std::string_view doing, int done, int total);

 private:
  using Clock = std::chrono::steady_clock;

  const bool on_terminal_;
  bool shown_ = false;
  std::string doing_;
  Clock::time_point began_, shown_at_;
};

/// "writing frames [######--------------] 135 of 450, 12 s left". The remaining time is left out
/// before the first step and in the first moments, when it cannot be estimated.
[[nodiscard]] std::string progress_text(std::string_view doing, int done, int total,
                                        std::chrono::duration<double> elapsed);

}  // namespace roomcast::cli
