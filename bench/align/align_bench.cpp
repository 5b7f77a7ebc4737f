// SPDX-License-Identifier: Apache-2.0
#include "bench/align/align_bench.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "bench/align/sift_pnp.h"
#include "roomcast/align/homography/homography_pose.h"
#include "roomcast/align/pair/pose_difference.h"
#include "roomcast/align/rig/rig_aligner.h"

namespace roomcast::bench {
namespace {

using align::SensorView;

/// What a method says of a case. The methods of others accept whatever they find.
using Answer = std::optional<RigidTransform>;
using Answers = std::vector<Answer>;
using Method = std::function<Answers(const AlignInput&)>;

template <class AlignPair>
Method pair_by_pair(AlignPair align_pair) {
  return [align_pair](const AlignInput& input) {
    Answers answers;
    for (const AlignCase& pair : input.cases) {
      answers.push_back(align_pair(input.views[pair.a], input.views[pair.b]));
    }
    return answers;
  };
}

using View = std::shared_ptr<const SensorView>;

Answer by_homography(const View& a, const View& b) {
  const auto pose = align::homography_pose(*a, *b);
  return pose ? Answer(pose->a_from_b) : std::nullopt;
}

Answer by_pnp(const View& a, const View& b) {
  return sift_pnp_pose(*a, *b);
}

Answer by_roomcast(const View& a, const View& b) {
  align::RigAligner aligner;
  aligner.add(a);
  aligner.add(b);
  const auto b_from_a = aligner.solve().pairs.at(0).b_from_a;
  return b_from_a ? Answer(b_from_a->inverse()) : std::nullopt;
}

Answers whole_rig_by_roomcast(const AlignInput& input) {
  align::RigAligner aligner;
  for (const View& view : input.views) aligner.add(view);
  const auto report = aligner.solve();
  Answers answers;
  for (const AlignCase& pair : input.cases) {
    const auto& a = report.sensors[pair.a].world_from_depth;
    const auto& b = report.sensors[pair.b].world_from_depth;
    answers.push_back(a && b ? Answer(a->inverse() * *b) : std::nullopt);
  }
  return answers;
}

struct NamedMethod {
  std::string name;
  bool whole_rig_only;
  Method run;
};

std::vector<NamedMethod> methods() {
  return {{"homography (paper)", false, pair_by_pair(by_homography)},
          {"SIFT + PnP", false, pair_by_pair(by_pnp)},
          {"roomcast, pair alone", false, pair_by_pair(by_roomcast)},
          {"roomcast, whole rig", true, whole_rig_by_roomcast}};
}

std::string overlap_class(double overlap) {
  if (overlap > 0.6) return ">60 %";
  if (overlap > 0.3) return "30-60 %";
  return overlap > 0.1 ? "10-30 %" : "<10 %";
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Rows of one method on one input, one for each class of overlap.
class Tally {
 public:
  void add(const AlignCase& pair, const Answer& answer) {
    Class& of_overlap = classes_[overlap_class(pair.overlap)];
    ++of_overlap.row.pairs;
    if (!answer) return;
    ++of_overlap.row.accepted;
    const auto error = align::difference(answer->inverse(), pair.a_from_b.inverse(), {0, 0, 0});
    const double angle_deg = error.angle_rad * 180 / std::numbers::pi;
    const bool right = angle_deg < kRightAngle_deg && error.distance_m < kRightDistance_m;
    of_overlap.row.right += right;
    of_overlap.row.accepted_wrong += !right;
    if (!right) return;
    of_overlap.rotations_deg.push_back(angle_deg);
    of_overlap.translations_mm.push_back(1000 * error.distance_m);
  }

  [[nodiscard]] std::vector<AlignRow> rows(const std::string& input, const std::string& method,
                                           double cpu_s_per_pair) const {
    std::vector<AlignRow> rows;
    for (const char* overlap : {">60 %", "30-60 %", "10-30 %", "<10 %"}) {
      const auto found = classes_.find(overlap);
      if (found == classes_.end()) continue;
      AlignRow row = found->second.row;
      row.input = input;
      row.method = method;
      row.overlap = overlap;
      row.median_rotation_deg = median(found->second.rotations_deg);
      row.median_translation_mm = median(found->second.translations_mm);
      row.cpu_s_per_pair = cpu_s_per_pair;
      rows.push_back(std::move(row));
    }
    return rows;
  }

 private:
  struct Class {
    AlignRow row;
    std::vector<double> rotations_deg, translations_mm;
  };
  std::map<std::string, Class> classes_;
};

std::vector<AlignRow> run_method(const NamedMethod& method, const AlignInput& input) {
  const std::clock_t start = std::clock();
  const Answers answers = method.run(input);
  const double cpu_s = double(std::clock() - start) / CLOCKS_PER_SEC;
  Tally tally;
  for (std::size_t i = 0; i < answers.size(); ++i) tally.add(input.cases[i], answers[i]);
  return tally.rows(input.name, method.name,
                    cpu_s / static_cast<double>(std::max<std::size_t>(1, answers.size())));
}

}  // namespace

std::vector<AlignRow> run_align_bench(const std::vector<AlignInput>& inputs,
                                      const BenchProgress& progress) {
  std::vector<AlignRow> rows;
  for (const AlignInput& input : inputs) {
    for (const NamedMethod& method : methods()) {
      if (method.whole_rig_only && !input.whole_rig) continue;
      if (progress) progress(input.name + ": " + method.name);
      const auto of_method = run_method(method, input);
      rows.insert(rows.end(), of_method.begin(), of_method.end());
    }
  }
  return rows;
}

}  // namespace roomcast::bench
