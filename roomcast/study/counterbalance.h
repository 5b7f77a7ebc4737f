// SPDX-License-Identifier: Apache-2.0
// The order of conditions for each participant. Balanced: the rows of a Latin square in which every
// condition follows every other one equally often (E. J. Williams, "Experimental designs balanced
// for the estimation of residual effects of treatments", 1949): n rows for an even number of
// conditions, 2n for an odd one. Participants take the rows in turn. Pure.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "roomcast/study/plan.h"

namespace roomcast::study {

/// How many participants make a whole square; 1: any number.
[[nodiscard]] std::size_t participants_per_square(std::size_t conditions, ConditionOrder order);

/// Indices of the conditions for participant number 0, 1, ... The random order depends on the
/// study's name and the number alone.
[[nodiscard]] std::vector<std::size_t> order_for(std::size_t participant, std::size_t conditions,
                                                 ConditionOrder order, std::string_view study);

}  // namespace roomcast::study
