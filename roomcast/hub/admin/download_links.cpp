// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/download_links.h"

#include <algorithm>
#include <utility>

#include "roomcast/hub/access/one_time_code.h"

namespace roomcast::hub {

std::string DownloadLinks::make(File file, HostTime now) {
  if (links_.size() >= kMaxLinks) links_.pop_front();
  links_.push_back({.key = make_token_id(), .file = std::move(file), .until = now + kValid});
  return links_.back().key;
}

std::optional<DownloadLinks::File> DownloadLinks::take(const std::string& key, HostTime now) {
  std::erase_if(links_, [&](const Link& link) { return link.until <= now; });
  const auto found = std::ranges::find(links_, key, &Link::key);
  if (found == links_.end()) return std::nullopt;
  File file = std::move(found->file);
  links_.erase(found);
  return file;
}

}  // namespace roomcast::hub
