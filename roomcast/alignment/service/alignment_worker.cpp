// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/alignment_worker.h"

#include <chrono>
#include <utility>

#include <sys/resource.h>
#include <unistd.h>

#include "roomcast/alignment/service/bundle_message.h"

namespace roomcast::alignment {
namespace {

using namespace std::chrono_literals;

/// Sensors often join together; one solve for all is cheaper than one for each.
constexpr auto kWaitForMore = 500ms;
/// Delay for sightings alone: a walk has to last some seconds anyway.
constexpr auto kWaitForSightings = 2s;
constexpr int kNiceness = 10;
constexpr int kMaxSightings = 500;  // per sensor, heads and tags together

}  // namespace

AlignmentWorker::AlignmentWorker(std::function<void(AlignmentUpdate)> on_update)
    : on_update_(std::move(on_update)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

template <class Change>
void AlignmentWorker::change_news(Change change) {
  {
    const std::lock_guard lock(mutex_);
    change(news_);
  }
  changed_.notify_all();
}

void AlignmentWorker::add(const std::string& sensor, const SensorCalibration& calibration,
                          wire::pb::CalibrationBundle bundle) {
  change_news([&](News& news) { news.bundles[sensor] = {calibration, std::move(bundle)}; });
}

void AlignmentWorker::forget(const std::string& sensor) {
  change_news([&](News& news) {
    news.bundles.erase(sensor);
    news.sightings.erase(sensor);
    news.instants.erase(sensor);
    news.nudges.erase(sensor);
    news.moved.insert(sensor);
  });
}

void AlignmentWorker::see(const std::string& sensor, const wire::pb::Sightings& sightings) {
  change_news([&](News& news) {
    auto& seen = news.sightings[sensor];
    if (seen.heads_size() + seen.tags_size() < kMaxSightings) seen.MergeFrom(sightings);
  });
}

void AlignmentWorker::see(const std::string& sensor, const SensorCalibration& calibration,
                          wire::pb::DepthInstant instant) {
  change_news([&](News& news) {
    Instants& seen = news.instants[sensor];
    seen.calibration = calibration;
    if (seen.messages.size() < InstantStore::kMaxInstants)
      seen.messages.push_back(std::move(instant));
  });
}

void AlignmentWorker::nudge(const std::string& sensor, const RigidTransform& world_from_depth) {
  change_news([&](News& news) { news.nudges[sensor] = world_from_depth; });
}

void AlignmentWorker::set_known(KnownRoom known, bool has_unplaced) {
  change_news([&](News& news) {
    news.known = std::move(known);
    news.has_unplaced = has_unplaced;
  });
}

void AlignmentWorker::run(const std::stop_token& stop) {
  // On Linux this sets the niceness of this thread only. Frames have priority over alignment.
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNiceness);
  while (auto news = wait_for_news(stop)) {
    take(*news);
    if (news->has_instants_only() && !solver_.has_new_instants()) continue;
    AlignmentUpdate update{solver_.solve(news->known), {}};
    update.wanted.set_heads(solver_.wants_sightings());
    update.wanted.set_tags(solver_.wants_sightings());
    update.wanted.set_instants(solver_.wants_instants());
    for (auto& placement : update.placements)
      placement.bundle_number = bundle_numbers_[placement.sensor];
    if (!stop.stop_requested()) on_update_(std::move(update));
  }
}

std::optional<AlignmentWorker::News> AlignmentWorker::wait_for_news(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  if (!changed_.wait(lock, stop, [this] { return news_.should_run(); })) return std::nullopt;
  if (!news_.is_urgent())
    changed_.wait_for(lock, stop, kWaitForSightings, [this] { return news_.is_urgent(); });
  if (news_.nudges.empty()) changed_.wait_for(lock, stop, kWaitForMore, [] { return false; });
  if (stop.stop_requested()) return std::nullopt;
  News news = news_;
  news_.moved.clear();
  news_.bundles.clear();
  news_.sightings.clear();
  news_.instants.clear();
  news_.nudges.clear();
  return news;
}

void AlignmentWorker::take(const News& news) {
  for (const auto& sensor : news.moved) solver_.forget(sensor);
  for (const auto& [sensor, bundle] : news.bundles) take_bundle(sensor, bundle);
  for (const auto& [sensor, sightings] : news.sightings) solver_.see(sensor, sightings);
  for (const auto& [sensor, instants] : news.instants) take_instants(sensor, instants);
  for (const auto& [sensor, guess] : news.nudges) solver_.nudge(sensor, guess);
}

void AlignmentWorker::take_bundle(const std::string& sensor, const Bundle& bundle) {
  bundle_numbers_[sensor] = bundle.message.number();
  const auto read = bundle_from_message(bundle.message, sensor, bundle.calibration);
  if (!read) return solver_.refuse(sensor, read.error().message);
  solver_.add(*read);
}

void AlignmentWorker::take_instants(const std::string& sensor, const Instants& instants) {
  for (const wire::pb::DepthInstant& message : instants.messages) {
    auto instant = instant_from_message(message, instants.calibration.depth);
    const bool is_scaled = message.depth_scale() != 0;
    if (instant && is_scaled) solver_.see(sensor, *std::move(instant), message.depth_scale());
  }
}

}  // namespace roomcast::alignment
