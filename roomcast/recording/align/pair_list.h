// SPDX-License-Identifier: Apache-2.0
// Reader of alignment_pairs.json: pairs of views to align, with their known pose and overlap.
//
//   {"pairs": [{"a": 759, "b": 787, "T_b_from_a": [[4 rows of 4 numbers]], "overlap": 0.6}, ...]}
//
// a and b are frame numbers of a TUM recording, or names of a rig's sensors. The reference pose and
// the overlap are optional. Metres. Thread-safe (no state).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::recording {

struct ListedPair {
  std::string a, b;
  std::optional<RigidTransform> b_from_a;
  std::optional<double> overlap;
};

inline constexpr std::size_t kMaxListedPairs = 100'000;

/// kNotFound: the file is missing. kMalformed, naming the fault: the file is not as above.
[[nodiscard]] Result<std::vector<ListedPair>> read_pair_list(const std::filesystem::path& path);

}  // namespace roomcast::recording
