// SPDX-License-Identifier: Apache-2.0
#include "bench/align/harsh_kinds.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace roomcast::bench {
namespace {

using simulator::Harshness;

constexpr std::array<std::string_view, 7> kDevelopmentRooms = {
    "livingroom", "lab", "studio", "mirror-tiles", "shelf-rows", "half-turn-hall", "glossy-floor"};
constexpr std::array<std::string_view, 7> kJudgedRooms = {
    "office", "meeting", "bare", "corners", "desk-rows", "open-plan", "dark-floor"};
constexpr std::array<Harshness, 3> kSensorKinds = {Harshness::kTimeOfFlight,
                                                   Harshness::kStructuredLight, Harshness::kMixed};

/// Seeds of the suite are far from each other and from those of other suites.
constexpr std::uint64_t kFirstSeed = 7'000'000'000, kSeedsOfRun = 10'000'000;

}  // namespace

std::string_view name_of(HarshPart part) {
  return part == HarshPart::kDevelopment ? "development" : "judged";
}

std::optional<HarshPart> harsh_part_named(std::string_view name) {
  for (const HarshPart part : {HarshPart::kDevelopment, HarshPart::kJudged}) {
    if (name_of(part) == name) return part;
  }
  return std::nullopt;
}

std::string HarshKind::name() const {
  return room + "/" + std::string(simulator::name_of(sensors));
}

std::vector<HarshKind> harsh_kinds(std::optional<HarshPart> part, std::uint64_t seed) {
  std::vector<HarshKind> kinds;
  std::uint64_t next = kFirstSeed + kSeedsOfRun * seed;
  for (const HarshPart of : {HarshPart::kDevelopment, HarshPart::kJudged}) {
    for (const auto& room : of == HarshPart::kDevelopment ? kDevelopmentRooms : kJudgedRooms) {
      for (const Harshness sensors : kSensorKinds) {
        if (!part || *part == of) kinds.push_back({std::string(room), sensors, of, next});
        next += 2 * kHarshRigsPerKind;
      }
    }
  }
  return kinds;
}

std::vector<HarshKind> chosen_kinds(const std::vector<HarshKind>& kinds,
                                    const std::vector<std::string>& wanted) {
  std::vector<HarshKind> chosen;
  std::ranges::copy_if(kinds, std::back_inserter(chosen), [&](const HarshKind& kind) {
    return wanted.empty() || std::ranges::any_of(wanted, [&](const std::string& name) {
             return name == kind.room || name == simulator::name_of(kind.sensors) ||
                    name == kind.name();
           });
  });
  return chosen;
}

}  // namespace roomcast::bench
