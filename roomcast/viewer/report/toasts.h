// SPDX-License-Identifier: Apache-2.0
// Toasts: sentences shown for a while. A problem's sentence stays until the problem is gone; then a
// toast reports that. Pure.
#pragma once

#include <chrono>
#include <span>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/viewer/report/room_problems.h"

namespace roomcast::viewer {

struct Toast {
  enum class Kind { kError, kNotice, kGood };
  Kind kind = Kind::kNotice;
  std::string sentence;
  friend bool operator==(const Toast&, const Toast&) = default;
};

class Toasts {
 public:
  static constexpr std::chrono::seconds kShownFor{5};
  static constexpr std::size_t kMax = 6;

  /// Adds a sentence about an event.
  void add(Toast::Kind kind, std::string sentence, HostTime now);
  /// Replaces the list of current problems.
  void set_problems(std::vector<RoomProblem> problems, HostTime now);

  /// Problems before other sentences; at most kMax.
  [[nodiscard]] std::vector<Toast> current(HostTime now) const;
  /// For a wearer's eyes, which lasting sentences would disturb: of the problems, errors for as
  /// long as they last and notices only at first.
  [[nodiscard]] std::vector<Toast> before_eyes(HostTime now) const;

 private:
  struct Passing {
    Toast toast;
    HostTime until{};
  };
  struct Lasting {
    RoomProblem problem;
    HostTime since{};
  };
  [[nodiscard]] HostTime since(const RoomProblem& problem, HostTime now) const;
  void append_passing(std::vector<Toast>& toasts, HostTime now) const;

  std::vector<Lasting> problems_;
  std::vector<Passing> passing_;
};

}  // namespace roomcast::viewer
