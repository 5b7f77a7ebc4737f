// SPDX-License-Identifier: Apache-2.0
// EmbedSites: the web sites whose pages may show a room in a frame (RoomSettings::embed_from).
// Threading: any thread.
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace roomcast::hub {

class EmbedSites {
 public:
  void set(const std::string& room, std::vector<std::string> sites) {
    const std::scoped_lock lock(mutex_);
    if (sites.empty()) {
      sites_.erase(room);
    } else {
      sites_[room] = std::move(sites);
    }
  }
  /// Empty: none may.
  [[nodiscard]] std::vector<std::string> of(const std::string& room) const {
    const std::scoped_lock lock(mutex_);
    const auto found = sites_.find(room);
    return found == sites_.end() ? std::vector<std::string>() : found->second;
  }

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::vector<std::string>> sites_;
};

}  // namespace roomcast::hub
