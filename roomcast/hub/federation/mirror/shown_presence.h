// SPDX-License-Identifier: Apache-2.0
// ShownPresence: what a room here was last told of people at other hubs. Pure.
#pragma once

#include <optional>

#include "roomcast/wire/control.pb.h"

namespace roomcast::hub::federation {

class ShownPresence {
 public:
  /// What to tell the room now that these are there; nothing: it knows.
  [[nodiscard]] std::optional<wire::pb::Control> news(const wire::pb::PeopleHere& people) {
    if (people.SerializeAsString() == shown_.SerializeAsString()) return std::nullopt;
    shown_ = people;
    wire::pb::Control control;
    *control.mutable_people_here() = people;
    return control;
  }
  /// It knows of nobody.
  void forget() { shown_.Clear(); }

 private:
  wire::pb::PeopleHere shown_;
};

}  // namespace roomcast::hub::federation
