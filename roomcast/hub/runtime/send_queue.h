// SPDX-License-Identifier: Apache-2.0
// SendQueue: the messages that wait to be written to one connection. Control messages go first,
// then audio packets, then frame sets. Of each speaker kMaxQueuedAudioPackets may wait; when more
// come, its oldest is dropped. Audio drops no frames, and frames drop no audio. The sets of which
// no byte is written yet may add up to kMaxQueuedSets whole sets. When more come, the oldest set
// with upper-layer frames loses these, since no frame depends on them; if no set has any, the
// oldest set is dropped, at once if key frames wait behind it, else beyond kMaxQueuedBaseSets. So a
// slow viewer loses its own frames, upper layers first, and delays no other viewer. Frames that
// depend on a dropped frame are dropped too, because the receiver could not decode them. Frames of
// sensors that the viewer does not need are left out; where that, or a drop, takes the last frame
// of a set, a SetEnd follows the others. Of sensors that are held back key frames come only, for
// which the queue asks in turn while the line is idle. docs/spec/wire.md §2 (last paragraph), §3
// "Back-pressure" and "Only what a viewer looks at". Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <boost/container/small_vector.hpp>

#include "roomcast/core/ids.h"
#include "roomcast/hub/room/frame_set.h"
#include "roomcast/hub/room/small_needs.h"
#include "roomcast/hub/runtime/rendition_choice.h"
#include "roomcast/hub/visibility/detail.h"
#include "roomcast/net/framed_message.h"

namespace roomcast::hub {

class SendQueue {
 public:
  /// So many sets of layer 0 may wait where no key frames wait behind them: while the line is busy
  /// with key frames. To drop one would take key frames again.
  static constexpr std::size_t kMaxQueuedBaseSets = 6;
  /// Sets between two key frames of sensors that are held back.
  static constexpr int kSetsPerHeldKey = 60;

  /// False: kMaxQueuedControlMessages wait already, and the receiver must be disconnected.
  [[nodiscard]] bool push_control(net::FramedMessagePtr message);
  void push_set(FrameSetPtr set);
  void push_audio(ViewerId speaker, net::FramedMessagePtr packet);

  /// The next message to write; null: there is none.
  [[nodiscard]] net::FramedMessagePtr next();

  /// The frames to leave out from now on, also of the sets that wait.
  void set_details(SensorDetails details);
  /// The sensor has started again: only its key frames can be decoded now.
  void forget(SensorId sensor);
  /// From now on the receiver may get a sensor's small rendition, where its line takes no more.
  void allow_small() { allows_small_ = true; }

  /// The sensors of which frames were dropped and which must send a key frame. Each is returned
  /// once per gap.
  [[nodiscard]] std::vector<SensorId> take_key_needs();
  /// What the receiver needs of small renditions; nothing: no news.
  [[nodiscard]] std::optional<SmallNeeds> take_small_needs();

  /// The number of sets that were dropped whole.
  [[nodiscard]] std::uint64_t dropped_sets() const { return dropped_sets_; }
  /// The number of audio packets that were dropped.
  [[nodiscard]] std::uint64_t dropped_audio() const { return dropped_audio_; }

 private:
  struct QueuedSet {
    FrameSetPtr set;
    std::size_t next_frame = 0;
    bool base_only = false;  // without its upper layers
    bool must_end = false;   // frames were delivered, and not the last one
  };
  struct QueuedAudio {
    ViewerId speaker;
    net::FramedMessagePtr packet;
  };
  struct Chain {
    bool broken = true;          // no reference frame: only a key frame can be decoded
    std::uint32_t base_seq = 0;  // sequence number of the newest layer-0 frame delivered
    bool key_asked = false;
    bool is_small = false;      // the rendition that is delivered
    bool wants_small = false;   // the rendition that is wanted: it begins with a key frame
    bool has_small = false;     // small frames came
    bool is_known = false;      // frames of this sensor came
    bool is_held_back = false;  // only key frames are delivered
  };

  [[nodiscard]] net::FramedMessagePtr next_of(QueuedSet& queued);
  [[nodiscard]] bool is_wanted(const wire::FrameHeader& header, bool base_only) const;
  [[nodiscard]] bool may_deliver(const wire::FrameHeader& header);
  void follow_line(const FrameSet& offered);
  void choose_renditions();
  void refresh_held_back();
  void miss_keys(const FrameSet& dropped);
  void ask_for_key(Chain& chain, const wire::FrameHeader& header);
  void count_dropped(const QueuedSet& queued);
  bool drop_superseded();
  [[nodiscard]] bool is_superseded(const QueuedSet& queued) const;
  [[nodiscard]] bool may_be_sent(const wire::FrameHeader& header, const QueuedSet& queued) const;
  [[nodiscard]] bool is_held_back(SensorId sensor) const;
  [[nodiscard]] static bool is_about_to_switch(const Chain& chain);

  void drop_excess();
  bool drop_upper_layers_of_one();
  static std::size_t base_frames(const FrameSet& set);
  static double size_in_sets(const QueuedSet& queued);
  [[nodiscard]] Chain& chain_of(SensorId sensor);

  // A hub has hundreds of queues and visits all of them for every set, so short lists are stored in
  // place.
  boost::container::small_vector<net::FramedMessagePtr, 2> control_;
  boost::container::small_vector<QueuedSet, 4> sets_;
  std::vector<QueuedAudio> audio_;
  boost::container::small_vector<Chain, 4> chains_;  // by sensor id
  std::vector<SensorId> key_needs_;
  bool allows_small_ = false;
  RenditionChoice renditions_;
  SmallNeeds small_needs_;
  bool small_changed_ = false;  // small_needs_.wanted and held_back
  int sets_since_held_key_ = 0;
  std::size_t next_held_back_ = 0;
  SensorDetails details_;
  std::uint64_t dropped_sets_ = 0;
  std::uint64_t dropped_audio_ = 0;
};

}  // namespace roomcast::hub
