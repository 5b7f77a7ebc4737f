// SPDX-License-Identifier: Apache-2.0
// alignment_pairs.json: pairs of views that are to be aligned, with what is known about them.
//
//   {"pairs": [{"a": 759, "b": 787, "T_b_from_a": [[4 rows of 4 numbers]], "overlap": 0.6}, ...]}
//
// a and b are frame numbers of a TUM recording, or names of a rig's sensors. Reference pose and
// overlap may be missing. Metres. Thread-safe (no state).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::cli {

struct ListedPair {
  std::string a, b;
  std::optional<RigidTransform> b_from_a;
  std::optional<double> overlap;
};

inline constexpr std::size_t kMaxListedPairs = 100'000;

/// kNotFound when the file is missing; kMalformed, naming what is wrong, for anything else than the
/// above.
[[nodiscard]] Result<std::vector<ListedPair>> read_pair_list(const std::filesystem::path& path);

}  // namespace roomcast::cli
