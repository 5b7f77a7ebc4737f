// SPDX-License-Identifier: Apache-2.0
// Toasts: sentences that are shown for a while. A problem's stays until the problem is gone, and
// then it is said that it is. Pure.
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

  /// Something that has just happened.
  void say(Toast::Kind kind, std::string sentence, HostTime now);
  /// All that is wrong now.
  void problems_are(std::vector<RoomProblem> problems, HostTime now);

  /// Problems first; at most kMax.
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
