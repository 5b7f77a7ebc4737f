// SPDX-License-Identifier: Apache-2.0
// AlignmentWorker: estimates sensor poses on a thread of its own, at low priority, when new
// bundles, sightings or nudges have arrived. A newer bundle, nudge or roster replaces an older one
// that is still waiting. Threading: the methods are thread-safe; `on_update` is called on the
// worker's thread.
#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "roomcast/alignment/service/placement_solver.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::alignment {

struct AlignmentUpdate {
  std::vector<Placement> placements;
  wire::pb::SightingRequest wanted;
};

class AlignmentWorker {
 public:
  explicit AlignmentWorker(std::function<void(AlignmentUpdate)> on_update);
  /// Waits for the running solve to end, which may take seconds.
  ~AlignmentWorker() = default;

  void add(const std::string& sensor, const SensorCalibration& calibration,
           wire::pb::CalibrationBundle bundle);
  /// Discards all data of the sensor, because it was moved.
  void forget(const std::string& sensor);
  void see(const std::string& sensor, const wire::pb::Sightings& sightings);
  void see(const std::string& sensor, const SensorCalibration& calibration,
           wire::pb::DepthInstant instant);
  void nudge(const std::string& sensor, const RigidTransform& world_from_depth);
  /// The state of the roster. `has_unplaced`: a connected sensor has no pose.
  void set_known(KnownRoom known, bool has_unplaced);

 private:
  struct Bundle {
    SensorCalibration calibration;
    wire::pb::CalibrationBundle message;
  };
  struct Instants {
    SensorCalibration calibration;
    std::vector<wire::pb::DepthInstant> messages;
  };
  /// Input since the last solve.
  struct News {
    std::set<std::string> moved;  // sensors to forget before the rest is applied
    std::map<std::string, Bundle> bundles;
    std::map<std::string, wire::pb::Sightings> sightings;
    std::map<std::string, Instants> instants;
    KnownPoses nudges;
    KnownRoom known;
    bool has_unplaced = false;

    [[nodiscard]] bool is_urgent() const {
      return (!bundles.empty() && has_unplaced) || !nudges.empty();
    }
    [[nodiscard]] bool should_run() const {
      return is_urgent() || !sightings.empty() || !instants.empty();
    }
    [[nodiscard]] bool has_instants_only() const {
      return !is_urgent() && sightings.empty() && moved.empty() && bundles.empty();
    }
  };

  template <class Change>
  void change_news(Change change);
  void run(const std::stop_token& stop);
  [[nodiscard]] std::optional<News> wait_for_news(const std::stop_token& stop);
  void take(const News& news);
  void take_bundle(const std::string& sensor, const Bundle& bundle);
  void take_instants(const std::string& sensor, const Instants& instants);

  const std::function<void(AlignmentUpdate)> on_update_;
  PlacementSolver solver_;  // this and the following: used by the thread only
  std::map<std::string, std::uint32_t> bundle_numbers_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  News news_;
  std::jthread thread_;  // declared last: joined first
};

}  // namespace roomcast::alignment
