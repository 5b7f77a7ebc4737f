// SPDX-License-Identifier: Apache-2.0
// Finding: one statement of `roomcast doctor` about this computer or its surroundings. Plain data.
#pragma once

#include <string>
#include <string_view>

namespace roomcast::doctor {

enum class Verdict {
  kOk,
  kNotice,   // roomcast works, but something is missing or slow
  kProblem,  // something that most people need does not work
};

[[nodiscard]] constexpr std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kOk:
      return "ok";
    case Verdict::kNotice:
      return "notice";
    case Verdict::kProblem:
      return "problem";
  }
  return "problem";
}

struct Finding {
  std::string topic;  // "graphics"
  Verdict verdict = Verdict::kOk;
  std::string sentence;     // for people
  std::string remedy = {};  // what to do, as a sentence; empty: nothing needs to be done
};

}  // namespace roomcast::doctor
