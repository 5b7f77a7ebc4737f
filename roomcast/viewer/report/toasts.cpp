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

/// A notice that becomes an error is a new problem, a sentence that counts seconds is not.
HostTime Toasts::since(const RoomProblem& problem, HostTime now) const {
  for (const Lasting& known : problems_) {
    if (known.problem.about == problem.about && known.problem.severity == problem.severity)
      return known.since;
  }
  return now;
}

void Toasts::set_problems(std::vector<RoomProblem> problems, HostTime now) {
  const auto is_about = [&](const std::string& about) {
    return std::ranges::find(problems, about, &RoomProblem::about) != problems.end();
  };
  for (const Lasting& known : problems_) {
    if (!is_about(known.problem.about) && !is_about("hub"))
      add(Toast::Kind::kGood, good_news(known.problem), now);
  }
  std::vector<Lasting> lasting;
  for (RoomProblem& problem : problems) {
    const HostTime begin = since(problem, now);
    lasting.push_back({std::move(problem), begin});
  }
  problems_ = std::move(lasting);
}

std::vector<Toast> Toasts::current(HostTime now) const {
  std::vector<Toast> toasts;
  for (const auto& [problem, since] : problems_)
    toasts.push_back({kind_of(problem), problem.sentence});
  append_passing(toasts, now);
  return toasts;
}

std::vector<Toast> Toasts::before_eyes(HostTime now) const {
  std::vector<Toast> toasts;
  for (const auto& [problem, since] : problems_) {
    if (problem.severity == RoomProblem::Severity::kError || now < since + kShownFor)
      toasts.push_back({kind_of(problem), problem.sentence});
  }
  append_passing(toasts, now);
  return toasts;
}

void Toasts::append_passing(std::vector<Toast>& toasts, HostTime now) const {
  for (const Passing& passing : passing_) {
    if (now < passing.until) toasts.push_back(passing.toast);
  }
  if (toasts.size() > kMax) toasts.resize(kMax);
}

}  // namespace roomcast::viewer
