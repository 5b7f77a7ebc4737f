// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/report/toasts.h"

#include <algorithm>
#include <utility>

namespace roomcast::viewer {
namespace {

std::string good_news(const RoomProblem& solved) {
  if (solved.about == "hub") return "The hub is back.";
  if (solved.about == "room") return "There is something to see again.";
  return "Sensor " + solved.about + " is all right.";
}

Toast::Kind kind_of(const RoomProblem& problem) {
  return problem.severity == RoomProblem::Severity::kError ? Toast::Kind::kError
                                                           : Toast::Kind::kNotice;
}

}  // namespace

void Toasts::add(Toast::Kind kind, std::string sentence, HostTime now) {
  passing_.push_back({{kind, std::move(sentence)}, now + kShownFor});
  if (passing_.size() > kMax) passing_.erase(passing_.begin());
}

void Toasts::set_problems(std::vector<RoomProblem> problems, HostTime now) {
  const bool hub_is_lost =
      std::ranges::find(problems, "hub", &RoomProblem::about) != problems.end();
  for (const RoomProblem& known : problems_) {
    const bool persists =
        std::ranges::find(problems, known.about, &RoomProblem::about) != problems.end();
    if (!persists && !hub_is_lost) add(Toast::Kind::kGood, good_news(known), now);
  }
  problems_ = std::move(problems);
}

std::vector<Toast> Toasts::current(HostTime now) const {
  std::vector<Toast> toasts;
  for (const RoomProblem& problem : problems_)
    toasts.push_back({kind_of(problem), problem.sentence});
  for (const Passing& passing : passing_) {
    if (now < passing.until) toasts.push_back(passing.toast);
  }
  if (toasts.size() > kMax) toasts.resize(kMax);
  return toasts;
}

}  // namespace roomcast::viewer
