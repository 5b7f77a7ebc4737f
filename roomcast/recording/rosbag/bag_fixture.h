// SPDX-License-Identifier: Apache-2.0
// For tests: writes ROS 1 bags by the format's description.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <bzlib.h>
#include <lz4frame.h>

#include "roomcast/core/clock.h"

namespace roomcast::recording::rosbag {

using BagBytes = std::vector<std::uint8_t>;

inline std::string little(std::uint64_t value, int bytes) {
  std::string out;
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i));
  return out;
}
inline std::string sized(std::string_view text) {
  return little(text.size(), 4) + std::string(text);
}
inline std::string time_text(nanoseconds time) {
  return little(static_cast<std::uint64_t>(time.count() / 1'000'000'000), 4) +
         little(static_cast<std::uint64_t>(time.count() % 1'000'000'000), 4);
}
using BagFields = std::vector<std::pair<std::string, std::string>>;
inline std::string fields_text(const BagFields& fields) {
  std::string out;
  for (const auto& [name, value] : fields) out += sized(name + "=" + value);
  return out;
}
inline std::string bag_record(char op, BagFields fields, std::string_view data) {
  fields.emplace_back("op", std::string(1, op));
  return sized(fields_text(fields)) + sized(data);
}

/// Collects messages in one chunk after the other.
class BagWriter {
 public:
  explicit BagWriter(std::string compression = "none") : compression_(std::move(compression)) {}

  void message(const std::string& topic, const std::string& type, nanoseconds time,
               std::string_view data) {
    const auto [found, is_new] = connections_.emplace(
        topic, std::pair(static_cast<std::uint32_t>(connections_.size()), type));
    const std::uint32_t id = found->second.first;
    if (is_new) chunk_ += connection_record(topic);
    index_[id] += time_text(time) + little(chunk_.size(), 4);
    ++counts_[id];
    chunk_ += bag_record(2, {{"conn", little(id, 4)}, {"time", time_text(time)}}, data);
  }

  void end_chunk() {
    if (chunk_.empty()) return;
    body_ += bag_record(5, {{"compression", compression_}, {"size", little(chunk_.size(), 4)}},
                        compressed(chunk_));
    for (const auto& [id, entries] : index_) {
      body_ += bag_record(
          4, {{"ver", little(1, 4)}, {"conn", little(id, 4)}, {"count", little(counts_[id], 4)}},
          entries);
    }
    chunk_.clear(), index_.clear(), counts_.clear();
  }

  [[nodiscard]] BagBytes finished() {
    end_chunk();
    std::string out = "#ROSBAG V2.0\n" +
                      bag_record(3,
                                 {{"index_pos", little(0, 8)},
                                  {"chunk_count", little(0, 4)},
                                  {"conn_count", little(connections_.size(), 4)}},
                                 std::string(200, ' ')) +
                      body_;
    for (const auto& [topic, unused] : connections_) out += connection_record(topic);
    return {out.begin(), out.end()};
  }

 private:
  [[nodiscard]] std::string connection_record(const std::string& topic) const {
    const auto& [id, type] = connections_.at(topic);
    return bag_record(
        7, {{"conn", little(id, 4)}, {"topic", topic}},
        fields_text(
            {{"topic", topic}, {"type", type}, {"md5sum", "*"}, {"message_definition", ""}}));
  }
  [[nodiscard]] std::string compressed(const std::string& plain) const {
    std::string out(plain.size() + plain.size() / 50 + 4096, '\0');
    if (compression_ == "lz4") {
      out.resize(LZ4F_compressFrame(out.data(), out.size(), plain.data(), plain.size(), nullptr));
      return out;
    }
    if (compression_ != "bz2") return plain;
    auto size = static_cast<unsigned>(out.size());
    BZ2_bzBuffToBuffCompress(out.data(), &size, const_cast<char*>(plain.data()),
                             static_cast<unsigned>(plain.size()), 1, 0, 0);
    out.resize(size);
    return out;
  }

  std::string compression_, body_, chunk_;
  std::map<std::string, std::pair<std::uint32_t, std::string>> connections_;
  std::map<std::uint32_t, std::string> index_;
  std::map<std::uint32_t, std::uint32_t> counts_;
};

}  // namespace roomcast::recording::rosbag
