// SPDX-License-Identifier: Apache-2.0
// Parts of the page of `roomcast bench real`, as HTML. Names come from files and may contain
// anything: they are escaped. Pure; each part is empty where there is nothing to show.
#pragma once

#include <string>
#include <vector>

#include "bench/real/real_bench.h"

namespace roomcast::bench {

[[nodiscard]] std::string placement_html(const alignment::AlignmentReport& alignment);
[[nodiscard]] std::string judgement_html(const RigJudgement& judgement);
[[nodiscard]] std::string conditions_html(const std::vector<SensorCondition>& conditions);
[[nodiscard]] std::string bytes_html(const std::vector<SensorBytes>& bytes);
/// The means of each sensor's pictures.
[[nodiscard]] std::string left_out_html(const std::vector<LeftOutPicture>& pictures);

}  // namespace roomcast::bench
