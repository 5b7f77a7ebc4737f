// SPDX-License-Identifier: Apache-2.0
// ShownPresence: the people at other hubs as last reported to a room here. Pure.
#pragma once

#include <optional>

#include "roomcast/wire/control.pb.h"

namespace roomcast::hub::federation {

class ShownPresence {
 public:
  /// The message that reports these people to the room; nothing if it has them already.
  [[nodiscard]] std::optional<wire::pb::Control> update(const wire::pb::PeopleHere& people) {
    if (people.SerializeAsString() == shown_.SerializeAsString()) return std::nullopt;
    shown_ = people;
    wire::pb::Control control;
    *control.mutable_people_here() = people;
    return control;
  }
  /// The room has no people of other hubs any more.
  void forget() { shown_.Clear(); }

 private:
  wire::pb::PeopleHere shown_;
};

}  // namespace roomcast::hub::federation
