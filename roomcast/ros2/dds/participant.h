// SPDX-License-Identifier: Apache-2.0
// Participant: this program in a DDS domain, as a ROS 2 program is in one: it writes and reads
// serialised messages on topics with ROS 2's names for them ("rt/camera/depth",
// "sensor_msgs::msg::dds_::Image_"; ROS 2 design, "Topic and Service name mapping to DDS"). Made by
// Eclipse Cyclone DDS. A message is sent from the memory in which it was written. Single-threaded:
// a Participant, its writers and its readers belong to one thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "roomcast/core/result.h"

namespace roomcast::ros2 {

/// Larger messages are neither sent nor taken.
inline constexpr std::size_t kMaxMessageBytes = 256U << 20U;
/// Of DDS: the ports of higher domains do not exist.
inline constexpr int kMaxDomain = 232;

struct ParticipantOptions {
  int domain = 0;               // ROS_DOMAIN_ID
  bool only_localhost = false;  // ROS_LOCALHOST_ONLY: nobody outside this computer takes part

  /// kInvalidArgument.
  [[nodiscard]] Status check() const;
};

/// What the environment variables ROS_DOMAIN_ID and ROS_LOCALHOST_ONLY say. kInvalidArgument.
[[nodiscard]] Result<ParticipantOptions> options_of_environment();

struct Quality {
  bool is_reliable = false;  // lost messages are sent again
  bool is_latched = false;   // readers that come later get the newest ones, too (transient local)
  int depth = 5;             // messages that are kept
};
/// ROS 2's qos_profile_sensor_data, and that of /tf_static.
inline constexpr Quality kSensorData{}, kStaticTransforms{true, true, 1};

struct Topic {
  std::string name;  // "/camera/depth/image_raw"
  std::string type;  // "sensor_msgs/msg/Image"
  Quality quality;
};

/// A serialised message with the four bytes that name its serialisation. Never changes.
using Message = std::shared_ptr<const std::vector<std::uint8_t>>;

class Writer {
 public:
  virtual ~Writer() = default;
  /// kTooLarge, kUnavailable.
  [[nodiscard]] virtual Status write(std::vector<std::uint8_t> message) = 0;
  /// Readers that take part now.
  [[nodiscard]] virtual int reader_count() const = 0;
};

class Reader {
 public:
  virtual ~Reader() = default;
  /// The oldest message that waits; null if none does.
  [[nodiscard]] virtual Message take() = 0;
};

class Participant {
 public:
  virtual ~Participant() = default;
  /// kUnsupported: built without Cyclone DDS; kUnavailable: the domain cannot be joined. Where two
  /// participants of a process are in the same domain, the options of the first hold.
  [[nodiscard]] static Result<std::unique_ptr<Participant>> open(const ParticipantOptions& options);

  /// Writers and readers must not outlive the participant. kInvalidArgument: not a topic's name;
  /// kUnavailable.
  [[nodiscard]] virtual Result<std::unique_ptr<Writer>> writer(const Topic& topic) = 0;
  [[nodiscard]] virtual Result<std::unique_ptr<Reader>> reader(const Topic& topic) = 0;

  /// Until a reader has a message, at most for `patience`.
  virtual void wait(std::chrono::milliseconds patience) = 0;
};

}  // namespace roomcast::ros2
