// SPDX-License-Identifier: Apache-2.0
// SendQueue: what waits to be written to one connection. Control messages go first; then frame
// sets, of which at most kMaxQueuedSets' worth waits without a byte written. When more comes, the
// oldest loses the frames on which nothing builds, and when none has such frames the oldest goes
// whole. So a slow viewer loses its own frames, upper layers before anything else, and delays
// nobody. Frames that the receiver could not decode, because a frame they need was left out, are
// left out too. docs/spec/wire.md §2 (last paragraph) and §3 "Back-pressure". Pure.
#pragma once

#include <cstdint>
#include <vector>

#include <boost/container/small_vector.hpp>

#include "roomcast/core/ids.h"
#include "roomcast/hub/room/frame_set.h"
#include "roomcast/net/framed_message.h"

namespace roomcast::hub {

class SendQueue {
 public:
  /// False when kMaxQueuedControlMessages wait already: the receiver has to be cut off.
  [[nodiscard]] bool push_control(net::FramedMessagePtr message);
  void push_set(FrameSetPtr set);

  /// What to write next; null when there is nothing.
  [[nodiscard]] net::FramedMessagePtr next();

  /// The sensor starts anew: only its key frames can be decoded now.
  void forget(SensorId sensor);

  /// Sensors of which frames had to be left out, and which should send a key frame. Each once per
  /// gap.
  [[nodiscard]] std::vector<SensorId> take_key_needs();

  /// That went whole.
  [[nodiscard]] std::uint64_t dropped_sets() const { return dropped_sets_; }

 private:
  struct QueuedSet {
    FrameSetPtr set;
    std::size_t next_frame = 0;
    bool base_only = false;  // without its upper layers
  };
  struct Chain {
    bool broken = true;          // nothing to build on: only a key frame helps
    std::uint32_t base_seq = 0;  // the newest layer-0 frame that was delivered
    bool key_asked = false;
  };

  [[nodiscard]] bool may_deliver(const wire::FrameHeader& header);

  void make_room();
  bool thin_out_one();
  static std::size_t base_frames(const FrameSet& set);
  static double worth(const QueuedSet& queued);
  [[nodiscard]] Chain& chain_of(SensorId sensor);

  // A hub has hundreds of these and visits all of them for every set: no memory elsewhere for what
  // is short.
  boost::container::small_vector<net::FramedMessagePtr, 2> control_;
  boost::container::small_vector<QueuedSet, 4> sets_;
  boost::container::small_vector<Chain, 4> chains_;  // by sensor id
  std::vector<SensorId> key_needs_;
  std::uint64_t dropped_sets_ = 0;
};

}  // namespace roomcast::hub
