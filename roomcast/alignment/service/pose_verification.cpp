// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/pose_verification.h"

#include <iterator>
#include <utility>

namespace roomcast::alignment {
namespace {

using alignment::StoredPoseVerdict;

std::string what_disagrees(alignment::Contradiction contradiction, const std::string& other) {
  if (contradiction == alignment::Contradiction::kMovement)
    return "what moves is not where " + other + " sees it";
  const bool by_colors = contradiction == alignment::Contradiction::kColors;
  return std::string("its ") + (by_colors ? "colours" : "surfaces") + " do not fit those of " +
         other;
}

class StoredPoseVerifier {
 public:
  StoredPoseVerifier(const KnownPoses& stored, KnownPoses known, const PosePairCheck& check_pair)
      : known_(std::move(known)), check_pair_(check_pair) {
    checks_.inconclusive = stored;
  }

  StoredPoseChecks run() {
    do {
      while (check_against_known()) {
      }
    } while (check_pairs());
    return std::move(checks_);
  }

 private:
  struct Verdict {
    double expected_error_mm = 0;  // of the best confirmation
    bool confirmed = false, contradicted = false;
    std::string by;  // the sensor that contradicts it
    alignment::Contradiction contradiction = alignment::Contradiction::kNone;
  };

  /// True: a pose was confirmed or contradicted. A confirmed sensor then serves to check others.
  bool check_against_known() {
    for (const auto& [sensor, pose] : checks_.inconclusive) {
      const Verdict verdict = verdict_by_known(sensor, pose);
      if (verdict.confirmed == verdict.contradicted) continue;  // inconclusive or conflicting
      if (verdict.confirmed) {
        confirm(sensor, verdict.expected_error_mm);
      } else {
        contradict(sensor, verdict);
      }
      return true;
    }
    return false;
  }

  [[nodiscard]] Verdict verdict_by_known(const std::string& sensor,
                                         const RigidTransform& pose) const {
    Verdict verdict;
    for (const auto& [other, world_from_other] : known_) {
      if (other == sensor) continue;
      const auto check = check_pair_({other, world_from_other}, {sensor, pose});
      if (check.verdict == StoredPoseVerdict::kContradicted) {
        if (!verdict.contradicted) verdict.by = other;
        verdict.contradicted = true;
        verdict.contradiction = check.contradiction;
      }
      if (check.verdict != StoredPoseVerdict::kConfirmed) continue;
      const bool better = check.expected_error_mm < verdict.expected_error_mm;
      if (better || !verdict.confirmed) verdict.expected_error_mm = check.expected_error_mm;
      verdict.confirmed = true;
    }
    return verdict;
  }

  bool check_pairs() {
    for (auto one = checks_.inconclusive.begin(); one != checks_.inconclusive.end(); ++one) {
      for (auto other = std::next(one); other != checks_.inconclusive.end(); ++other) {
        const auto check = check_pair_({one->first, one->second}, {other->first, other->second});
        if (check.verdict != StoredPoseVerdict::kConfirmed) continue;
        const std::string first = one->first, second = other->first;
        confirm(first, check.expected_error_mm);
        confirm(second, check.expected_error_mm);
        return true;
      }
    }
    return false;
  }

  void confirm(std::string sensor, double expected_error_mm) {
    const RigidTransform pose = checks_.inconclusive.at(sensor);
    checks_.confirmed[sensor] = placed_at(sensor, pose, expected_error_mm);
    known_[sensor] = pose;
    checks_.inconclusive.erase(sensor);
  }

  void contradict(std::string sensor, const Verdict& verdict) {
    Placement& placement = checks_.contradicted[sensor];
    placement = not_placed(sensor, "It was moved while it was away: " +
                                       what_disagrees(verdict.contradiction, verdict.by) +
                                       " at its stored pose.");
    placement.withdrawn = true;
    checks_.inconclusive.erase(sensor);
  }

  StoredPoseChecks checks_;
  KnownPoses known_;
  const PosePairCheck& check_pair_;
};

}  // namespace

StoredPoseChecks verify_stored_poses(const KnownPoses& stored, const KnownPoses& known,
                                     const PosePairCheck& check_pair) {
  return StoredPoseVerifier(stored, known, check_pair).run();
}

}  // namespace roomcast::alignment
