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

 private:
  struct Passing {
    Toast toast;
    HostTime until{};
  };
  std::vector<RoomProblem> problems_;
  std::vector<Passing> passing_;
};

}  // namespace roomcast::viewer
