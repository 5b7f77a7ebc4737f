// SPDX-License-Identifier: Apache-2.0
// ViewCulling: decides which sensors each viewer of a room needs in which detail, by where the
// viewers look and where the sensors see surfaces. A sensor comes back at once when a viewer's
// head, or where it is turning to, makes it needed; it goes after a while only. A viewer that has
// not told its angle of view, and a sensor whose surfaces are not known, get everything. Pure.
// docs/spec/wire.md §3 "Only what a viewer looks at".
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/hub/visibility/detail.h"
#include "roomcast/hub/visibility/head_motion.h"
#include "roomcast/hub/visibility/seen_surface.h"
#include "roomcast/hub/visibility/view_visibility.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

struct CullingOptions {
  VisibilityOptions visibility;
  std::chrono::milliseconds interval{100};    // between two looks at the same viewer
  std::chrono::milliseconds look_ahead{300};  // a key frame is asked for, and comes
  /// Around the cones that sensors are told. In 100 ms, heads turn by up to 9.5 degrees and move by
  /// 46 mm (95 % of the time); most of that is foreseen.
  float beside_told_rad = 0.08F;
  std::chrono::milliseconds keeps_all{500};  // after a sensor was last needed so
  /// Base layers are sent on for so long after a sensor was last needed. It comes back with a key
  /// frame, which all viewers get; so with n viewers, this time is n times as long.
  std::chrono::milliseconds keeps_base{3000};
};

class ViewCulling {
 public:
  explicit ViewCulling(CullingOptions options = {}) : options_(options) {}

  void set_surface(SensorId sensor, SeenSurface surface);
  /// As it was set; null: none is known.
  [[nodiscard]] const SeenSurface* surface_of(SensorId sensor) const;
  /// All viewers get this sensor whole.
  void forget_sensor(SensorId sensor);
  /// Without `view_half_angle`, the viewer gets everything from now on.
  void viewer_moved(ConnectionId viewer, const wire::pb::ViewerPose& pose, RoomTime now);
  void forget_viewer(ConnectionId viewer);

  /// The new details of a viewer.
  struct Change {
    ConnectionId viewer;
    SensorDetails details;
    std::vector<SensorId> resumed;  // they were paused
  };
  [[nodiscard]] std::vector<Change> update(RoomTime now);
  /// The viewers who have told their angle of view; the others get everything.
  [[nodiscard]] std::size_t viewer_count() const { return viewers_.size(); }
  /// The number of these viewers who get all frames of a sensor at present, and layer 0 only.
  struct Wishes {
    std::size_t all = 0, base_only = 0;  // viewers; the rest gets nothing
  };
  [[nodiscard]] Wishes wishes_for(SensorId sensor) const;
  /// In which cones these viewers may see within the next moments, by where their heads are and how
  /// they move, with a margin; none if one of them gets everything, or if there are more viewers
  /// than a WatchedFrom takes cones.
  [[nodiscard]] std::vector<ViewCone> cones(RoomTime now) const;
  /// The time for the next update() if nothing else happens before; nothing: none is needed.
  [[nodiscard]] std::optional<RoomTime> next() const { return next_; }

 private:
  struct Need {
    Detail detail = Detail::kAll;
    RoomTime all{}, base{};  // when it was last needed so
  };
  struct Viewer {
    HeadMotion head;
    ViewAngles angles;
    bool has_changed = true;          // it, or what sensors see
    RoomTime looked_at{};             // by update()
    std::optional<RoomTime> revisit;  // when a detail ends without a change
    std::map<SensorId, Need> needs;
  };

  struct Reduced {
    std::size_t base_only = 0, paused = 0;  // viewers
  };

  void count(SensorId sensor, Detail detail, int viewers);
  void touch(Viewer& viewer, RoomTime now);
  std::optional<Change> look_at(ConnectionId id, Viewer& viewer, RoomTime now);
  Detail next_detail(Need& need, Detail needed, Viewer& viewer, RoomTime now) const;
  [[nodiscard]] std::vector<ViewCone> views_of(const Viewer& viewer, RoomTime now) const;
  void expect(RoomTime time);

  const CullingOptions options_;
  std::map<SensorId, SeenSurface> surfaces_;
  std::map<ConnectionId, Viewer> viewers_;  // that have told their angle of view
  std::map<SensorId, Reduced> reduced_;     // by their needs
  std::optional<RoomTime> next_;
};

}  // namespace roomcast::hub
