// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/ros/cdr_writer.h"

#include <bit>
#include <utility>

namespace roomcast::recording::ros {
namespace {

constexpr std::size_t kHeadBytes = 4, kDdsUnit = 4;
constexpr std::int64_t kNanoseconds = 1'000'000'000;

}  // namespace

CdrWriter::CdrWriter(std::size_t expected_bytes) {
  out_.reserve(kHeadBytes + expected_bytes + kDdsUnit);
  for (const std::uint8_t byte : {0, 1, 0, 0}) out_.push_back(byte);  // CDR, little-endian
}

CdrWriter& CdrWriter::integer(std::uint64_t value, std::size_t size) {
  while ((out_.size() - kHeadBytes) % size != 0) out_.push_back(0);
  for (std::size_t i = 0; i < size; ++i)
    out_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  return *this;
}

CdrWriter& CdrWriter::f64(double value) {
  return integer(std::bit_cast<std::uint64_t>(value), sizeof(value));
}

CdrWriter& CdrWriter::text(std::string_view value) {
  u32(value.size() + 1);
  out_.insert(out_.end(), value.begin(), value.end());
  out_.push_back(0);
  return *this;
}

CdrWriter& CdrWriter::header(nanoseconds stamp, std::string_view frame_id) {
  u32(static_cast<std::uint64_t>(stamp.count() / kNanoseconds));
  u32(static_cast<std::uint64_t>(stamp.count() % kNanoseconds));
  return text(frame_id);
}

std::span<std::uint8_t> CdrWriter::bytes(std::size_t size) {
  u32(size);
  out_.resize(out_.size() + size);
  return std::span(out_).last(size);
}

std::vector<std::uint8_t> CdrWriter::done() {
  out_.resize((out_.size() + kDdsUnit - 1) / kDdsUnit * kDdsUnit);
  return std::move(out_);
}

}  // namespace roomcast::recording::ros
