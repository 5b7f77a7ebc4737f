// SPDX-License-Identifier: Apache-2.0
// Summary of a study by conditions: each participant has one value of each measure (answers, what
// the participant got, how they moved and spoke); mean, spread and confidence interval are over the
// participants. Of paired comparisons it says how often the photograph was chosen. Method: mean
// with the interval of Student's t (Student 1908); shares with the score interval (Wilson 1927),
// which takes answers for independent of each other. Threading: no state.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/study/study_folder.h"

namespace roomcast::study {

struct Summary {
  std::size_t count = 0;
  double mean = 0;
  double deviation = 0;   // standard deviation; 0 for one value
  double half_width = 0;  // of the 95 % interval of the mean; 0 for one value
};

/// Of none: all 0.
[[nodiscard]] Summary summary_of(const std::vector<double>& values);

struct Measure {
  std::string name;   // "presence.there", "latency_ms"
  std::string title;  // for people
  std::string unit;   // empty: none
  /// condition -> participant -> value
  std::map<std::string, std::map<std::string, double>> values = {};
};

/// How often the photograph was chosen, over all participants and pairs.
struct ComparisonSummary {
  std::string name;
  std::size_t answers = 0, correct = 0;
  double low_share = 0, high_share = 1;  // 95 % interval of the share of correct answers
};

struct ConditionSummary {
  std::string study, title;
  std::vector<std::string> conditions;  // in the order of the plan
  std::vector<Measure> measures;        // without those of which nothing is known
  std::vector<ComparisonSummary> comparisons;
  std::size_t participants = 0;  // of whom something is known
};

[[nodiscard]] ComparisonSummary comparison_summary(std::string name, std::size_t answers,
                                                   std::size_t correct);

/// An answer that is asked for after each condition belongs to the one that has just ended. Answers
/// that are no numbers, and sessions in which no condition began, count for nothing. A measure that
/// a participant has several values of in a condition (a scale asked twice) is their mean; latency,
/// rate and bytes are the median of the condition's seconds. Also the errors of StudyFolder;
/// kNotFound if the folder has no copy of the plan.
[[nodiscard]] Result<ConditionSummary> summarise(const StudyFolder& study);

}  // namespace roomcast::study
