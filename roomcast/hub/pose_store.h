// SPDX-License-Identifier: Apache-2.0
// PoseStore: where sensors were found to stand, kept in an SQLite file, so that a room is whole
// again right after its hub starts. Poses that sensors bring themselves are not kept. A write does
// not wait for the disk (write-ahead log, no sync): after a power cut the newest may be missing,
// which alignment then finds again. Single-threaded.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/hub/known_pose.h"

struct sqlite3;

namespace roomcast::hub {

class PoseStore {
 public:
  /// Makes the file where there is none. kUnavailable: it cannot be opened or is no such file; the
  /// sentence says which.
  static Result<std::unique_ptr<PoseStore>> open(const std::filesystem::path& file);
  ~PoseStore();
  PoseStore(const PoseStore&) = delete;
  PoseStore& operator=(const PoseStore&) = delete;

  /// Of one room. Entries that make no sense are left out.
  [[nodiscard]] Result<std::vector<KnownPose>> load(const std::string& room) const;

  /// Adds or replaces.
  [[nodiscard]] Status save(const std::string& room, std::span<const KnownPose> poses);

 private:
  explicit PoseStore(sqlite3* database) : database_(database) {}
  [[nodiscard]] Status run(const char* sql);
  sqlite3* database_;
};

}  // namespace roomcast::hub
