// SPDX-License-Identifier: Apache-2.0
// RoomAligner: keeps the sensors of a running room placed. A client of the hub like any other: it
// gets the bundles that sensors send, and says where they stand. Threading: has threads of its own;
// one waits for the network, one thinks.
#pragma once

#include <memory>
#include <string>

#include "roomcast/core/log.h"
#include "roomcast/core/result.h"

namespace roomcast::alignment {

struct RoomAlignerOptions {
  std::string hub_url;
  std::string room;   // empty: the hub's only one
  std::string token;  // an admin's
  LogSink log;        // from both threads
};

class RoomAligner {
 public:
  /// Joins. kInvalidArgument: not a hub's address. It goes on trying when there is no hub yet, or
  /// no more.
  static Result<std::unique_ptr<RoomAligner>> open(RoomAlignerOptions options);
  /// Leaves; waits for a thought to end, which may take seconds.
  ~RoomAligner();

 private:
  class Link;
  explicit RoomAligner(std::unique_ptr<Link> link);
  std::unique_ptr<Link> link_;
};

}  // namespace roomcast::alignment
