// SPDX-License-Identifier: Apache-2.0
// For tests: writes ZIP files, stored or deflated.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <zlib.h>

namespace roomcast::recording {

class ZipWriter {
 public:
  using Bytes = std::vector<std::uint8_t>;

  ZipWriter& add(const std::string& name, const Bytes& content, bool deflated = false) {
    const Bytes packed = deflated ? deflate_raw(content) : content;
    const auto crc =
        static_cast<std::uint32_t>(crc32(0, content.data(), static_cast<uInt>(content.size())));
    const std::size_t offset = file_.size();
    number(file_, 0x04034B50, 4);
    fields(file_, deflated, crc, packed.size(), content.size(), name);
    number(file_, 0, 2);
    text(file_, name);
    file_.insert(file_.end(), packed.begin(), packed.end());
    number(directory_, 0x02014B50, 4);
    number(directory_, 20, 2);
    fields(directory_, deflated, crc, packed.size(), content.size(), name);
    for (int i = 0; i < 3; ++i) number(directory_, 0, 2);  // extra, comment, part
    number(directory_, 0, 2);
    number(directory_, 0, 4);
    number(directory_, offset, 4);
    text(directory_, name);
    ++entries_;
    return *this;
  }
  ZipWriter& add(const std::string& name, const std::string& content, bool deflated = false) {
    return add(name, Bytes(content.begin(), content.end()), deflated);
  }

  [[nodiscard]] Bytes done(const std::string& comment = "") const {
    Bytes out = file_;
    out.insert(out.end(), directory_.begin(), directory_.end());
    number(out, 0x06054B50, 4);
    number(out, 0, 4);  // parts
    number(out, entries_, 2);
    number(out, entries_, 2);
    number(out, directory_.size(), 4);
    number(out, file_.size(), 4);
    number(out, comment.size(), 2);
    text(out, comment);
    return out;
  }

  /// The same as files larger than 4 GB have it: the directory's place behind a locator.
  [[nodiscard]] Bytes done_in_64() const {
    Bytes out = file_;
    out.insert(out.end(), directory_.begin(), directory_.end());
    const std::size_t at = out.size();
    number(out, 0x06064B50, 4);
    number(out, 44, 8);
    number(out, 45, 2);
    number(out, 45, 2);
    number(out, 0, 8);
    number(out, entries_, 8);
    number(out, entries_, 8);
    number(out, directory_.size(), 8);
    number(out, file_.size(), 8);
    number(out, 0x07064B50, 4);
    number(out, 0, 4);
    number(out, at, 8);
    number(out, 1, 4);
    number(out, 0x06054B50, 4);
    number(out, 0, 4);
    number(out, 0xFFFF, 2);
    number(out, 0xFFFF, 2);
    number(out, 0xFFFFFFFF, 4);
    number(out, 0xFFFFFFFF, 4);
    number(out, 0, 2);
    return out;
  }

 private:
  static void number(Bytes& out, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  static void text(Bytes& out, const std::string& text) {
    out.insert(out.end(), text.begin(), text.end());
  }
  static void fields(Bytes& out, bool deflated, std::uint32_t crc, std::size_t packed,
                     std::size_t size, const std::string& name) {
    number(out, 20, 2);
    number(out, 0, 2);
    number(out, deflated ? 8 : 0, 2);
    number(out, 0, 4);  // time
    number(out, crc, 4);
    number(out, packed, 4);
    number(out, size, 4);
    number(out, name.size(), 2);
  }
  static Bytes deflate_raw(const Bytes& content) {
    z_stream stream{};
    EXPECT_EQ(deflateInit2(&stream, 6, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
    Bytes out(deflateBound(&stream, static_cast<uLong>(content.size())) + 16);
    stream.next_in = const_cast<Bytef*>(content.data());
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = out.data();
    stream.avail_out = static_cast<uInt>(out.size());
    EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    out.erase(out.end() - static_cast<std::ptrdiff_t>(stream.avail_out), out.end());
    deflateEnd(&stream);
    return out;
  }

  Bytes file_, directory_;
  std::size_t entries_ = 0;
};

}  // namespace roomcast::recording
