// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/hub_models.h"

#include <system_error>
#include <vector>

#include "roomcast/net/http_request.h"

namespace roomcast::hub::daemon {
namespace {

/// Folders of which the name is a room's. While one is written, others with an ending are beside
/// it.
std::vector<std::string> rooms_in(const std::filesystem::path& folder) {
  std::vector<std::string> rooms;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const std::string room = net::percent_decoded(name);
    if (entry.is_directory(error) && entry.path().extension().empty() &&
        net::percent_encoded(room) == name)
      rooms.push_back(room);
  }
  return rooms;
}

}  // namespace

void HubModels::start_kept() {
  if (!folder_) return;
  for (const std::string& room : rooms_in(*folder_)) start(room);
}

void HubModels::start(const std::string& room) {
  const OwnHub::Access access = hub_.access();
  const std::lock_guard lock(mutex_);
  auto& modeler = modelers_[room];
  if (modeler) return;  // it connects again by itself
  modeler = std::make_unique<recording::RoomModeler>(recording::RoomModelerOptions{
      .hub_url = access.url,
      .room = room,
      .token = access.token,
      .folder = folder_ ? *folder_ / net::percent_encoded(room) : std::filesystem::path(),
      .log = log_});
}

std::shared_ptr<const std::string> HubModels::changes_after(const std::string& room,
                                                            std::uint64_t known) const {
  const std::lock_guard lock(mutex_);
  const auto found = modelers_.find(room);
  return found == modelers_.end() ? nullptr : found->second->changes_after(known);
}

}  // namespace roomcast::hub::daemon
