// SPDX-License-Identifier: Apache-2.0
#include "bench/align/align_bench.h"

#include <algorithm>
#include <ctime>
#include <optional>
#include <utility>

#include "bench/align/align_tally.h"
#include "bench/align/fpfh_ransac.h"
#include "bench/align/sift_pnp.h"
#include "roomcast/alignment/homography/homography_pose.h"
#include "roomcast/alignment/rig/rig_aligner.h"

namespace roomcast::bench {
namespace {

using alignment::SensorView;

/// The peer methods return a pose for every pair for which they find one; they have no acceptance
/// test.
using Answer = AlignAnswer;
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
  const auto pose = alignment::homography_pose(*a, *b);
  return pose ? Answer(pose->a_from_b) : std::nullopt;
}

Answer by_pnp(const View& a, const View& b) {
  return sift_pnp_pose(*a, *b);
}

Answer by_shape(const View& a, const View& b) {
  return fpfh_ransac_pose(*a, *b);
}

Answer by_roomcast(const View& a, const View& b) {
  alignment::RigAligner aligner;
  aligner.add(a);
  aligner.add(b);
  const auto b_from_a = aligner.solve().pairs.at(0).b_from_a;
  return b_from_a ? Answer(b_from_a->inverse()) : std::nullopt;
}

Answers whole_rig_by_roomcast(const AlignInput& input) {
  alignment::RigAligner aligner;
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
          {"FPFH + RANSAC + ICP", false, pair_by_pair(by_shape)},
          {"roomcast, pair alone", false, pair_by_pair(by_roomcast)},
          {"roomcast, whole rig", true, whole_rig_by_roomcast}};
}

std::vector<AlignRow> run_method(const NamedMethod& method, const AlignInput& input) {
  const std::clock_t start = std::clock();
  const Answers answers = method.run(input);
  const double cpu_s = double(std::clock() - start) / CLOCKS_PER_SEC;
  AlignTally tally;
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
