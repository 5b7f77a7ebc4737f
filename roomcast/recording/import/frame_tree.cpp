// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/frame_tree.h"

#include <utility>

namespace roomcast::recording {
namespace {

constexpr std::size_t kMaxFrames = 65'536, kMaxChain = 256;  // a loop ends there

std::string without_slash(const std::string& name) {
  return name.starts_with('/') ? name.substr(1) : name;
}

}  // namespace

void FrameTree::add(const std::string& parent, const std::string& child,
                    const RigidTransform& parent_from_child) {
  if (links_.size() < kMaxFrames)
    links_[without_slash(child)] = {without_slash(parent), parent_from_child};
}

std::map<std::string, RigidTransform> FrameTree::ancestors(std::string name) const {
  std::map<std::string, RigidTransform> found;
  RigidTransform from_start;
  while (found.size() < kMaxChain && found.emplace(name, from_start).second) {
    const auto link = links_.find(name);
    if (link == links_.end()) break;
    from_start = link->second.parent_from_child * from_start;
    name = link->second.parent;
  }
  return found;
}

std::optional<RigidTransform> FrameTree::between(const std::string& to,
                                                 const std::string& from) const {
  const auto above_from = ancestors(without_slash(from));
  for (const auto& [name, common_from_to] : ancestors(without_slash(to))) {
    const auto found = above_from.find(name);
    if (found != above_from.end()) return common_from_to.inverse() * found->second;
  }
  return std::nullopt;
}

std::optional<std::string> FrameTree::root_above(const std::string& frame) const {
  std::string name = without_slash(frame);
  for (std::size_t i = 0; i < kMaxChain; ++i) {
    const auto link = links_.find(name);
    if (link == links_.end()) return i > 0 ? std::optional(name) : std::nullopt;
    name = link->second.parent;
  }
  return std::nullopt;
}

}  // namespace roomcast::recording
