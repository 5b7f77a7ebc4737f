// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/pose_verification.h"

#include <iterator>
#include <utility>

namespace roomcast::alignment {
namespace {

using alignment::StoredPoseVerdict;

class Recollecting {
 public:
  Recollecting(const KnownPoses& remembered, KnownPoses known, const PosePairCheck& witness)
      : known_(std::move(known)), witness_(witness) {
    told_.untold = remembered;
  }

  StoredPoseChecks finish() {
    do {
      while (check_against_known()) {
      }
    } while (check_pairs());
    return std::move(told_);
  }

 private:
  struct Verdict {
    double expected_error_mm = 0;  // of the best confirmation
    bool confirmed = false, contradicted = false;
    std::string by;  // the sensor that contradicts it
    alignment::Contradiction contradiction = alignment::Contradiction::kNone;
  };

  /// Returns true if a pose was confirmed or contradicted. A confirmed sensor then serves to check
  /// others.
  bool check_against_known() {
    for (const auto& [sensor, pose] : told_.untold) {
      const Verdict verdict = beside_known(sensor, pose);
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

  [[nodiscard]] Verdict beside_known(const std::string& sensor, const RigidTransform& pose) const {
    Verdict verdict;
    for (const auto& [other, world_from_other] : known_) {
      if (other == sensor) continue;
      const auto told = witness_({other, world_from_other}, {sensor, pose});
      if (told.verdict == StoredPoseVerdict::kContradicted) {
        if (!verdict.contradicted) verdict.by = other;
        verdict.contradicted = true;
        verdict.contradiction = told.contradiction;
      }
      if (told.verdict != StoredPoseVerdict::kConfirmed) continue;
      const bool better = told.expected_error_mm < verdict.expected_error_mm;
      if (better || !verdict.confirmed) verdict.expected_error_mm = told.expected_error_mm;
      verdict.confirmed = true;
    }
    return verdict;
  }

  bool check_pairs() {
    for (auto one = told_.untold.begin(); one != told_.untold.end(); ++one) {
      for (auto other = std::next(one); other != told_.untold.end(); ++other) {
        const auto told = witness_({one->first, one->second}, {other->first, other->second});
        if (told.verdict != StoredPoseVerdict::kConfirmed) continue;
        const std::string first = one->first, second = other->first;
        confirm(first, told.expected_error_mm);
        confirm(second, told.expected_error_mm);
        return true;
      }
    }
    return false;
  }

  void confirm(std::string sensor, double expected_error_mm) {
    Placement& placement = told_.confirmed[sensor];
    placement.sensor = sensor;
    placement.world_from_depth = told_.untold.at(sensor);
    placement.expected_error_mm = expected_error_mm;
    known_[sensor] = told_.untold.at(sensor);
    told_.untold.erase(sensor);
  }

  void contradict(std::string sensor, const Verdict& verdict) {
    Placement& placement = told_.contradicted[sensor];
    placement.sensor = sensor;
    placement.withdrawn = true;
    placement.note =
        std::string("It was moved while it was away: its ") +
        (verdict.contradiction == alignment::Contradiction::kColors ? "colours" : "surfaces") +
        " do not fit those of " + verdict.by + " at its stored pose.";
    told_.untold.erase(sensor);
  }

  StoredPoseChecks told_;
  KnownPoses known_;
  const PosePairCheck& witness_;
};

}  // namespace

StoredPoseChecks verify_stored_poses(const KnownPoses& remembered, const KnownPoses& known,
                                     const PosePairCheck& witness) {
  return Recollecting(remembered, known, witness).finish();
}

}  // namespace roomcast::alignment
