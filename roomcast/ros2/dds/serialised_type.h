// SPDX-License-Identifier: Apache-2.0
// A type of Cyclone DDS whose samples are serialised messages, which it neither reads nor changes:
// an implementation of its ddsi_sertype and ddsi_serdata, as ROS 2's own layer over Cyclone DDS has
// one. Thread-safe: Cyclone's threads call it.
#pragma once

#include <memory>
#include <string>

#include <dds/ddsi/ddsi_serdata.h>

#include "roomcast/ros2/dds/participant.h"

namespace roomcast::ros2 {

/// A new type without key; the caller hands it to dds_create_topic_sertype, which owns it then.
[[nodiscard]] ddsi_sertype* new_serialised_type(const std::string& type_name);

/// A sample to be written, with one reference. `message` has a multiple of four bytes.
[[nodiscard]] ddsi_serdata* new_sample(const ddsi_sertype& type, Message message);

/// The message of a sample of such a type.
[[nodiscard]] Message message_of(const ddsi_serdata& sample);

}  // namespace roomcast::ros2
