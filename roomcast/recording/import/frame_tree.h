// SPDX-License-Identifier: Apache-2.0
// FrameTree: the coordinate frames of a recording, as they are static: /tf_static of ROS.
// Single-threaded.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::recording {

class FrameTree {
 public:
  /// A later parent of the same frame replaces the former. Leading slashes of names are ignored.
  void add(const std::string& parent, const std::string& child,
           const RigidTransform& parent_from_child);

  /// `to`_from_`from`; nothing if no chain of frames joins them.
  [[nodiscard]] std::optional<RigidTransform> between(const std::string& to,
                                                      const std::string& from) const;

  /// The frame at the end of the chain of parents; nothing for a frame without a parent, or
  /// in a loop.
  [[nodiscard]] std::optional<std::string> root_above(const std::string& frame) const;

 private:
  struct Link {
    std::string parent;
    RigidTransform parent_from_child;
  };
  /// Each frame from `name` up to its root, with its transform from `name`.
  [[nodiscard]] std::map<std::string, RigidTransform> ancestors(std::string name) const;

  std::map<std::string, Link> links_;
};

}  // namespace roomcast::recording
