// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/rig_aligner.h"

#include <utility>

#include <fmt/format.h>

namespace roomcast::alignment {
namespace {

// Progress, 0..1, at which the steps begin.
constexpr double kFinding = 0.5, kPlacing = 0.9;

/// Calls `visit(i, j, done)` for each pair i < j of `count`; `done` is the progress, 0..1.
template <class Visit>
void for_each_two(std::size_t count, Visit visit) {
  const double all = static_cast<double>(count * (count - 1)) / 2;
  double done = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) visit(i, j, done++ / all);
  }
}

}  // namespace

void RigAligner::add(std::shared_ptr<const SensorView> view) {
  remove(view->name);
  views_.push_back(std::move(view));
}

void RigAligner::remove(const std::string& name) {
  std::erase_if(pairs_, [&](const auto& entry) {
    return entry.first.first == name || entry.first.second == name;
  });
  std::erase_if(views_, [&](const auto& view) { return view->name == name; });
  affine_features_.erase(name);
  depth_scales_.erase(name);
}

AlignmentReport RigAligner::solve(const AlignProgress& progress) {
  compare_new_pairs(progress);
  find_new_candidates(progress);
  if (progress) progress("placing all sensors", kPlacing);
  if (scaling_ == DepthScaling::kEstimated && views_.size() > 1 && rescale_views()) {
    compare_new_pairs(progress);
    find_new_candidates(progress);
  }
  AlignmentReport report = placed();
  if (add_affine_matches_to_refused(report, progress)) report = placed();
  report_scales(report);
  return report;
}

bool RigAligner::rescale_views() {
  const std::vector<DepthScale> scales = rig_depth_scales(views_.size(), pairs(), options_);
  bool any = false;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const std::string name = views_[i]->name;
    DepthScale& known = depth_scales_[name];
    known.standard_error = scales[i].standard_error;
    if (scales[i].factor == 1) continue;
    auto remade = with_depth_scale(*views_[i], scales[i].factor);
    if (!remade) continue;
    known.factor *= scales[i].factor;
    std::erase_if(pairs_, [&](const auto& entry) {
      return entry.first.first == name || entry.first.second == name;
    });
    affine_features_.erase(name);
    views_[i] = std::make_shared<const SensorView>(*std::move(remade));
    any = true;
  }
  return any;
}

void RigAligner::report_scales(AlignmentReport& report) const {
  for (SensorReport& sensor : report.sensors) {
    const auto known = depth_scales_.find(sensor.id);
    if (!sensor.placed || known == depth_scales_.end()) continue;
    sensor.depth_scale = known->second.factor;
    sensor.depth_scale_standard_error = known->second.standard_error;
  }
}

AlignmentReport RigAligner::placed() const {
  std::vector<const SensorView*> views;
  for (const auto& view : views_) views.push_back(view.get());
  std::vector<DepthScale> scales;
  for (const SensorView* view : views) {
    const auto known = depth_scales_.find(view->name);
    scales.push_back(known == depth_scales_.end() ? DepthScale{} : known->second);
  }
  return place_rig(views, pairs(), options_, scales);
}

const PairCandidates* RigAligner::pair(const std::string& one, const std::string& other) const {
  auto found = pairs_.find({one, other});
  if (found == pairs_.end()) found = pairs_.find({other, one});
  return found == pairs_.end() ? nullptr : found->second.candidates.get();
}

/// Adds affine matches to pairs that have no plausible candidate and a sensor that would be
/// refused. Returns whether there were any.
bool RigAligner::add_affine_matches_to_refused(const AlignmentReport& report,
                                               const AlignProgress& progress) {
  bool any = false;
  for_each_two(views_.size(), [&](std::size_t i, std::size_t j, double) {
    const SensorView &a = *views_[i], &b = *views_[j];
    Pair& pair = pairs_.at({a.name, b.name});
    const bool is_settled = report.sensors[i].placed && report.sensors[j].placed;
    if (is_settled || pair.has_affine_matches || pair.candidates->same_pictures() ||
        pair.candidates->has_plausible())
      return;
    if (progress) progress(fmt::format("matching {} and {} again", a.name, b.name), kPlacing);
    pair.candidates->add_affine_matches(affine_matches(
        affine_features_of(a), affine_features_of(b), options_.pair.matching, a.options.repeating));
    any = pair.has_affine_matches = true;
  });
  return any;
}

const FeatureSet& RigAligner::affine_features_of(const SensorView& view) {
  const auto [entry, is_new] = affine_features_.try_emplace(view.name);
  if (is_new)
    entry->second = affine_features(view.picture, view.surface, view.options.affine_features,
                                    view.options.lifting, view.options.repeating);
  return entry->second;
}

void RigAligner::compare_new_pairs(const AlignProgress& progress) {
  for_each_two(views_.size(), [&](std::size_t i, std::size_t j, double done) {
    const SensorView &a = *views_[i], &b = *views_[j];
    if (progress) progress(fmt::format("comparing {} with {}", a.name, b.name), kFinding * done);
    const Names names(a.name, b.name);
    if (!pairs_.contains(names))
      pairs_[names].comparison = compare_views(a, b, options_.pair.matching);
  });
}

void RigAligner::find_new_candidates(const AlignProgress& progress) {
  const std::vector<DescriptorAmbiguity> look_alikes = look_alikes_in_rig();
  for_each_two(views_.size(), [&](std::size_t i, std::size_t j, double done) {
    const SensorView &a = *views_[i], &b = *views_[j];
    if (progress) {
      progress(fmt::format("estimating the pose between {} and {}", a.name, b.name),
               kFinding + (kPlacing - kFinding) * done);
    }
    Pair& pair = pairs_.at({a.name, b.name});
    if (pair.candidates) return;
    pair.candidates =
        std::make_unique<PairCandidates>(a, b,
                                         weighted_matches(a, look_alikes[i], b, look_alikes[j],
                                                          pair.comparison, options_.pair.matching),
                                         options_.pair);
    pair.comparison.free_matches();
  });
}

std::vector<DescriptorAmbiguity> RigAligner::look_alikes_in_rig() const {
  std::vector<DescriptorAmbiguity> look_alikes;
  for (const auto& view : views_) look_alikes.push_back(own_ambiguity(*view));
  for_each_two(views_.size(), [&](std::size_t i, std::size_t j, double) {
    const ViewComparison& comparison = pairs_.at({views_[i]->name, views_[j]->name}).comparison;
    add_repeats_of_b(comparison, look_alikes[i]);
    add_repeats_of_a(comparison, look_alikes[j]);
  });
  return look_alikes;
}

std::vector<RigPair> RigAligner::pairs() const {
  std::vector<RigPair> pairs;
  for_each_two(views_.size(), [&](std::size_t i, std::size_t j, double) {
    pairs.push_back({i, j, pairs_.at({views_[i]->name, views_[j]->name}).candidates.get()});
  });
  return pairs;
}

}  // namespace roomcast::alignment
