// SPDX-License-Identifier: Apache-2.0
// RoomEvents: what happened in a room lately, for those who run it: who came and went, who was
// refused and why, what an admin changed. Bounded: the oldest are forgotten, and equal refusals
// count as one, so that a client that tries again and again hides nothing. Single-threaded.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "roomcast/hub/access/claims.h"

namespace roomcast::hub {

struct RoomEvent {
  std::string kind;  // "joined"; all kinds: docs/spec/admin.openapi.yaml
  std::string role =
      {};  // "sensor", "viewer", "hub", "aligner", "modeler"; empty: it is about no client
  std::string name = {};      // of the client, or of what was changed
  std::string peer = {};      // the client's address
  std::string token_id = {};  // of the token that it showed
  std::string by = {};  // the admin who did it, by the name in the token; empty: nobody's deed
  std::string sentence = {};  // for people
  // Set by RoomEvents.
  std::uint64_t id = 0;      // stays the same while equal refusals are added
  std::uint64_t number = 0;  // grows with each addition
  UnixSeconds at = 0;        // of the newest
  std::uint32_t times = 1;
};

class RoomEvents {
 public:
  static constexpr std::size_t kMaxEvents = 1000;
  static constexpr std::size_t kMaxRefusals = 300;  // of these
  static constexpr std::size_t kMaxPage = 200;
  static constexpr std::size_t kMaxSentence = 300;  // bytes

  void add(RoomEvent event, UnixSeconds at);

  struct Page {
    std::vector<RoomEvent> events = {};  // by their numbers, at most kMaxPage
    std::uint64_t newest = 0;            // number of the newest of all; 0: there are none
  };
  /// Those with a higher number than `after`, from the lowest on.
  [[nodiscard]] Page after(std::uint64_t after) const;

 private:
  [[nodiscard]] bool merge(const RoomEvent& event, UnixSeconds at);
  void forget_the_oldest();

  std::deque<RoomEvent> events_;  // by their numbers
  std::size_t refusals_ = 0;
  std::uint64_t newest_ = 0;
};

}  // namespace roomcast::hub
