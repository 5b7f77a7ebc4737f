// SPDX-License-Identifier: Apache-2.0
// Bag: reads ROS 1 bags, version 2.0 (http://wiki.ros.org/Bags/Format/2.0). The file is walked from
// its beginning, so that a bag without its final index, of a killed recorder, is read up to there.
// Files are untrusted: sizes are checked before anything is allocated. Single-threaded.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/bytes/byte_source.h"
#include "roomcast/recording/rosbag/chunk.h"
#include "roomcast/recording/rosbag/record.h"

namespace roomcast::recording::rosbag {

inline constexpr std::size_t kMaxConnections = 65'536, kMaxMessages = 8U << 20U;
inline constexpr std::size_t kMaxHeaderBytes = 64U << 10U, kMaxConnectionBytes = 4U << 20U;

struct Connection {
  std::string topic;
  std::string type;  // "sensor_msgs/Image"
};

/// Where a message is.
struct MessagePlace {
  nanoseconds time{};            // at which it was recorded
  std::uint64_t chunk = 0;       // offset of the chunk's record in the file
  std::uint32_t offset = 0;      // of its record in the decompressed chunk
  std::uint32_t connection = 0;  // ID, in connections()
};

class Bag {
 public:
  /// kMalformed: not a bag, or nothing can be read; kUnsupported: another version; kTooLarge.
  static Result<Bag> read(std::unique_ptr<ByteSource> source);

  [[nodiscard]] const std::map<std::uint32_t, Connection>& connections() const {
    return connections_;
  }
  /// In file order.
  [[nodiscard]] const std::vector<MessagePlace>& messages() const { return messages_; }
  /// Why the end of the bag cannot be read; nothing if it is complete.
  [[nodiscard]] const std::optional<std::string>& damage() const { return damage_; }

  /// The serialised message, valid until the next call. kMalformed, kUnsupported, kTooLarge: its
  /// chunk is damaged; others may be readable.
  [[nodiscard]] Result<ByteView> data(const MessagePlace& place);

 private:
  struct Head;
  explicit Bag(std::unique_ptr<ByteSource> source) : source_(std::move(source)) {}
  [[nodiscard]] Status index_file();
  [[nodiscard]] Result<std::uint64_t> index_record(std::uint64_t offset);
  [[nodiscard]] std::optional<Head> head_at(std::uint64_t offset);
  [[nodiscard]] Status take_connection(const Fields& fields, ByteView data);
  [[nodiscard]] Status take_index(const Head& head);
  [[nodiscard]] Status scan_open_chunk();
  [[nodiscard]] Status scan_chunk(std::uint64_t chunk, bool take_messages);
  void find_missing_connections();
  [[nodiscard]] Status load_chunk(std::uint64_t offset);

  std::unique_ptr<ByteSource> source_;
  std::map<std::uint32_t, Connection> connections_;
  std::vector<MessagePlace> messages_;
  std::optional<std::string> damage_;
  std::optional<std::uint64_t> open_chunk_;  // the last one, while no index record followed it
  std::optional<std::uint64_t> last_chunk_;
  std::optional<std::uint64_t> loaded_chunk_;          // whose content `plain_` is
  std::vector<std::uint8_t> header_, stored_, plain_;  // reused
};

}  // namespace roomcast::recording::rosbag
