// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/status_line.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <unistd.h>

#include "roomcast/cli/print.h"

namespace roomcast::cli {
namespace {

using Seconds = std::chrono::duration<double>;

std::string time_left(int done, int total, Seconds elapsed) {
  constexpr double kTooEarly_s = 0.5;
  if (done <= 0 || done >= total || elapsed.count() < kTooEarly_s) return "";
  const double left = elapsed.count() * (total - done) / done;
  const int seconds = std::max(1, static_cast<int>(std::lround(std::min(left, 1e6))));
  if (seconds < 100) return fmt::format(", {} s left", seconds);
  return fmt::format(", {} min {:02} s left", seconds / 60, seconds % 60);
}

}  // namespace

std::string progress_text(std::string_view doing, int done, int total, Seconds elapsed) {
  constexpr int kWidth = 20;
  const int shown = std::clamp(done, 0, total);
  const int filled = total > 0 ? static_cast<int>(std::int64_t{kWidth} * shown / total) : kWidth;
  return fmt::format("{} [{:#<{}}{:-<{}}] {} of {}{}", doing, "", filled, "", kWidth - filled,
                     shown, total, time_left(done, total, elapsed));
}

StatusLine::StatusLine() : on_terminal_(isatty(STDERR_FILENO) == 1) {}

StatusLine::~StatusLine() {
  if (shown_) (void)write_raw(stderr, "\n");
}

void StatusLine::show(std::string_view text) {
  if (!on_terminal_) return;
  // Back to the line's start, and clear what is behind the text.
  (void)write_raw(stderr, fmt::format("\r{}\x1b[K", printable(text)));
  shown_ = true;
}

void StatusLine::show_progress(std::string_view doing, int done, int total) {
  constexpr auto kOften = std::chrono::milliseconds(100);
  if (!on_terminal_) return;
  const Clock::time_point now = Clock::now();
  const bool another = doing != doing_;
  if (another) {
    doing_ = doing;
    began_ = now;
  }
  if (!another && done < total && now - shown_at_ < kOften) return;
  shown_at_ = now;
  show(progress_text(doing, done, total, now - began_));
}

}  // namespace roomcast::cli
