// SPDX-License-Identifier: Apache-2.0
// ComparisonPictures: the pictures of a study's paired comparisons: for each comparison two
// folders, in which files of the same name, PNG or JPEG, are a pair. Found once; read when they are
// shown. Threading: immutable.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/study/plan.h"

namespace roomcast::study {

inline constexpr std::size_t kMaxPairs = 200;  // of a comparison
inline constexpr std::size_t kMaxPictureBytes = 16U << 20U;

class ComparisonPictures {
 public:
  struct Picture {
    std::string content_type;
    std::string bytes;
  };

  /// `folder`: that of the plan. kNotFound: a folder is not there, or two have no name in common.
  /// kTooLarge: more than kMaxPairs.
  static Result<ComparisonPictures> find(const StudyPlan& plan,
                                         const std::filesystem::path& folder);

  /// Names of the files without their ending, sorted; empty for an unknown comparison.
  [[nodiscard]] std::vector<std::string> pairs(const std::string& comparison) const;
  /// kNotFound: there is no such pair; errors of io::read_file(). kMalformed: neither PNG nor JPEG.
  [[nodiscard]] Result<Picture> read(const std::string& comparison, std::size_t pair,
                                     bool is_real) const;

 private:
  struct Pair {
    std::string name;
    std::filesystem::path real, drawn;
  };
  std::map<std::string, std::vector<Pair>> pairs_;  // by comparison
};

}  // namespace roomcast::study
