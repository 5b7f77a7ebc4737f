// SPDX-License-Identifier: Apache-2.0
// The kinds of rigs of the harsh suite, a kind of room times a kind of sensor, in two fixed parts.
// Thresholds are chosen on the development part only; figures are taken from the judged part only.
// A room belongs to one part with all its sensors, so that nothing of a judged room is known. Every
// kind has seeds of its own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/simulator/sensing/sensing_options.h"

namespace roomcast::bench {

enum class HarshPart { kDevelopment, kJudged };

/// "development" or "judged".
[[nodiscard]] std::string_view name_of(HarshPart part);
[[nodiscard]] std::optional<HarshPart> harsh_part_named(std::string_view name);

struct HarshKind {
  std::string room;
  simulator::Harshness sensors = simulator::Harshness::kMixed;
  HarshPart part = HarshPart::kDevelopment;
  std::uint64_t seed = 0;  // of its first rig; at most kHarshRigsPerKind are drawn

  /// "shelf-rows/structured".
  [[nodiscard]] std::string name() const;
};

inline constexpr int kHarshRigsPerKind = 10'000;

/// All kinds of a part, or of both. `seed` selects other rigs of the same kinds.
[[nodiscard]] std::vector<HarshKind> harsh_kinds(std::optional<HarshPart> part, std::uint64_t seed);

/// Those whose room, sensors or name is in `wanted`; all if that is empty.
[[nodiscard]] std::vector<HarshKind> chosen_kinds(const std::vector<HarshKind>& kinds,
                                                  const std::vector<std::string>& wanted);

}  // namespace roomcast::bench
