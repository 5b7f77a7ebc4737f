// SPDX-License-Identifier: Apache-2.0
// For tests: serialises ROS messages, as ROS 1 and as CDR.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/recording/ros/message_reader.h"

namespace roomcast::recording::ros {

class MessageWriter {
 public:
  explicit MessageWriter(Serialisation as) : as_(as) {
    if (as == Serialisation::kRos2) out_ = std::string("\0\1\0\0", 4);
  }

  MessageWriter& number(std::uint64_t value, std::size_t bytes) {
    while (as_ == Serialisation::kRos2 && (out_.size() - 4) % bytes != 0) out_ += '\0';
    for (std::size_t i = 0; i < bytes; ++i) out_ += static_cast<char>(value >> (8 * i));
    return *this;
  }
  MessageWriter& u32(std::uint64_t value) { return number(value, 4); }
  MessageWriter& f64(double value) { return number(std::bit_cast<std::uint64_t>(value), 8); }
  MessageWriter& text(std::string_view value) {
    const bool ends = as_ == Serialisation::kRos2;
    u32(value.size() + (ends ? 1 : 0));
    out_ += value;
    if (ends) out_ += '\0';
    return *this;
  }
  MessageWriter& bytes(std::string_view value) {
    u32(value.size());
    out_ += value;
    return *this;
  }
  MessageWriter& header(nanoseconds stamp, std::string_view frame) {
    if (as_ == Serialisation::kRos1) u32(7);
    u32(static_cast<std::uint64_t>(stamp.count() / 1'000'000'000));
    u32(static_cast<std::uint64_t>(stamp.count() % 1'000'000'000));
    return text(frame);
  }
  [[nodiscard]] const std::string& done() const { return out_; }

 private:
  Serialisation as_;
  std::string out_;
};

inline std::string image_message(Serialisation as, nanoseconds stamp, std::string_view frame,
                                 int width, int height, std::string_view encoding, int step,
                                 std::string_view data) {
  return MessageWriter(as)
      .header(stamp, frame)
      .u32(static_cast<std::uint64_t>(height))
      .u32(static_cast<std::uint64_t>(width))
      .text(encoding)
      .number(0, 1)
      .u32(static_cast<std::uint64_t>(step))
      .bytes(data)
      .done();
}

inline std::string compressed_message(Serialisation as, nanoseconds stamp, std::string_view frame,
                                      std::string_view format, std::string_view data) {
  return MessageWriter(as).header(stamp, frame).text(format).bytes(data).done();
}

inline std::string camera_info_message(Serialisation as, std::string_view frame, int width,
                                       int height, double focal, std::string_view model,
                                       const std::vector<double>& d) {
  MessageWriter message(as);
  message.header(nanoseconds(0), frame)
      .u32(static_cast<std::uint64_t>(height))
      .u32(static_cast<std::uint64_t>(width))
      .text(model)
      .u32(d.size());
  for (const double term : d) message.f64(term);
  const double cx = (width - 1) / 2.0, cy = (height - 1) / 2.0;
  for (const double v : {focal, 0., cx, 0., focal, cy, 0., 0., 1.}) message.f64(v);
  for (const double v : {1., 0., 0., 0., 1., 0., 0., 0., 1.}) message.f64(v);
  for (const double v : {focal, 0., cx, 0., 0., focal, cy, 0., 0., 0., 1., 0.}) message.f64(v);
  return message.done();
}

struct FixtureTransform {
  std::string parent, child;
  std::array<double, 3> translation;
};
inline std::string transforms_message(Serialisation as,
                                      const std::vector<FixtureTransform>& transforms) {
  MessageWriter message(as);
  message.u32(transforms.size());
  for (const FixtureTransform& transform : transforms) {
    message.header(nanoseconds(0), transform.parent).text(transform.child);
    for (const double v : transform.translation) message.f64(v);
    for (const double v : {0., 0., 0., 1.}) message.f64(v);
  }
  return message.done();
}

}  // namespace roomcast::recording::ros
