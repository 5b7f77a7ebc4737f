// SPDX-License-Identifier: Apache-2.0
// RoomAligner: keeps the sensors of a running room placed. It is an ordinary client of the hub: it
// receives the sensors' bundles and sends their poses. Threading: has two threads of its own, one
// for the network and one for alignment.
#pragma once

#include <memory>
#include <string>

#include "roomcast/core/log.h"
#include "roomcast/core/result.h"

namespace roomcast::alignment {

struct RoomAlignerOptions {
  std::string hub_url;
  std::string room;   // empty: the hub's only room
  std::string token;  // an admin's
  LogSink log;        // from both threads
};

class RoomAligner {
 public:
  /// Joins. kInvalidArgument: not a hub's address. Retries if no hub is there yet, and after the
  /// connection is lost.
  static Result<std::unique_ptr<RoomAligner>> open(RoomAlignerOptions options);
  /// Leaves; waits for a running solve to end, which may take seconds.
  ~RoomAligner();

 private:
  class Link;
  explicit RoomAligner(std::unique_ptr<Link> link);
  std::unique_ptr<Link> link_;
};

}  // namespace roomcast::alignment
