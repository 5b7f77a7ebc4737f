// SPDX-License-Identifier: Apache-2.0
// Recordings of ROS 2 (rosbag2) as a RosStore, with messages in CDR: MCAP files (with chunks) and
// SQLite databases (.db3: the tables topics and messages). Single-threaded.
#pragma once

#include <filesystem>
#include <memory>

#include "roomcast/recording/import/ros_store.h"

namespace roomcast::recording {

/// Errors of mcap::Reader::open, which name the file; kUnsupported: messages are not CDR.
[[nodiscard]] Result<std::shared_ptr<RosStore>> open_mcap_store(const std::filesystem::path& path);

/// kNotFound; kMalformed: not such a database; kUnsupported, kTooLarge. Messages name the file.
[[nodiscard]] Result<std::shared_ptr<RosStore>> open_sqlite_store(
    const std::filesystem::path& path);

}  // namespace roomcast::recording
