// SPDX-License-Identifier: Apache-2.0
// Where a participant's head was, as a camera's path through a recording of the room: with it the
// recording is filmed as it was seen. Threading: no state.
#pragma once

#include <string>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/study/study_folder.h"

namespace roomcast::study {

struct PathKey {
  double time_s = 0;  // since the condition's film begins
  double at_m[3] = {}, look_m[3] = {};
};

/// A condition of a session, as far as it is in the recording.
struct SeenCondition {
  std::string name;
  double from_s = 0, to_s = 0;  // of the recording
  std::string mode;             // as the plan says; empty: as the page chose
  double fps = 0;               // 0: all
  std::vector<PathKey> keys;
};

/// `began`: when the recording began, since 1970; `length`: of the recording. Times are earlier by
/// the latency that a condition adds, so that a film shows what was seen. Conditions of which less
/// than a second is in the recording, or that have no poses, are left out. kNotFound: none is left.
/// Also the errors of StudyFolder.
[[nodiscard]] Result<std::vector<SeenCondition>> seen_conditions(const StudyFolder& study,
                                                                 const std::string& participant,
                                                                 nanoseconds began,
                                                                 nanoseconds length);

/// For `roomcast export --format video --path`.
[[nodiscard]] std::string path_json(const std::vector<PathKey>& keys);

}  // namespace roomcast::study
