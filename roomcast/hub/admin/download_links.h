// SPDX-License-Identifier: Apache-2.0
// DownloadLinks: addresses under which a browser fetches one file, once and soon: a link cannot
// carry a token, and tokens are never in an address. Threading: single-threaded.
#pragma once

#include <chrono>
#include <deque>
#include <optional>
#include <string>

#include "roomcast/core/clock.h"
#include "roomcast/hub/runtime/kept_recordings.h"

namespace roomcast::hub {

class DownloadLinks {
 public:
  static constexpr std::chrono::seconds kValid{60};
  static constexpr std::size_t kMaxLinks = 100;  // the oldest one gives way

  struct File {
    RecordingScope scope;
    std::string name;
  };

  /// Returns the link's key: 128 random bits.
  std::string make(File file, HostTime now);
  /// The key is worth nothing afterwards. Nothing: it is unknown, used, or too old.
  std::optional<File> take(const std::string& key, HostTime now);

 private:
  struct Link {
    std::string key;
    File file;
    HostTime until;
  };
  std::deque<Link> links_;  // oldest first
};

}  // namespace roomcast::hub
