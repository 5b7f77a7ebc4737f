// SPDX-License-Identifier: Apache-2.0
// VoiceRelay: who speaks in a room (viewers and sensors' microphones), whom an admin has muted, and
// which listeners get whose audio packets: those of the nearest speakers. Pure. docs/spec/wire.md
// §6.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

/// Which speakers a listener gets while more speak than a person can listen to.
enum class Hearing { kNearest, kAll };

class VoiceRelay {
 public:
  /// After this time without a packet a speaker has paused.
  static constexpr std::chrono::milliseconds kSilentAfter{500};
  /// The nearest speakers are chosen anew at this interval, and earlier if others speak.
  static constexpr std::chrono::milliseconds kChoiceInterval{500};
  static constexpr std::chrono::milliseconds kMinChoiceInterval{100};

  /// Where a viewer's head or a sensor's microphone is, metres, world frame; nothing: not known.
  using HeadOf = std::function<std::optional<Eigen::Vector3f>(ViewerId)>;

  void add_listener(ViewerId viewer, ConnectionId connection, Hearing hearing = Hearing::kNearest);
  /// The viewer has left, or the sensor was forgotten.
  void forget(ViewerId viewer);
  /// It says nothing more for now. It stays muted if it is.
  void end(ViewerId speaker);
  /// The packets of a muted viewer go to nobody.
  void set_muted(ViewerId viewer, bool muted);

  /// A packet has come. Returns the connections that get it. `ends`: the speaker pauses after it.
  [[nodiscard]] std::vector<ConnectionId> receivers(ViewerId speaker, bool ends, RoomTime now,
                                                    const HeadOf& head_of);

  [[nodiscard]] bool is_speaking(ViewerId viewer) const;
  [[nodiscard]] bool is_muted(ViewerId viewer) const { return muted_.contains(viewer); }
  [[nodiscard]] std::size_t speaker_count() const { return speakers_.size(); }

  /// Who speaks and who is muted, for somebody who has joined.
  [[nodiscard]] wire::pb::Control message() const;
  /// The same, if it has changed and is due, for all listeners(). Speakers without packets for
  /// kSilentAfter are removed.
  [[nodiscard]] std::optional<wire::pb::Control> take(RoomTime now);
  /// The time of the next take(); nothing: nobody speaks and nothing has changed.
  [[nodiscard]] std::optional<RoomTime> next() const;
  [[nodiscard]] std::vector<ConnectionId> listeners() const;

 private:
  struct Speaker {
    ViewerId id;
    RoomTime begun{};
    RoomTime newest{};  // of its packets
  };
  struct Listener {
    ViewerId id;
    ConnectionId connection;
    Hearing hearing = Hearing::kNearest;
    std::vector<ViewerId> heard = {};  // while more speak than one may hear
  };

  void choose(RoomTime now, const HeadOf& head_of);
  [[nodiscard]] std::vector<ViewerId> nearest(ViewerId listener, const HeadOf& head_of) const;

  std::vector<Speaker> speakers_;
  std::vector<Listener> listeners_;
  std::set<ViewerId> muted_;
  bool speakers_changed_ = false;  // since the last choice
  RoomTime chosen_at_{};
  bool has_changed_ = false;  // since the last message
  RoomTime next_message_{};
};

}  // namespace roomcast::hub
