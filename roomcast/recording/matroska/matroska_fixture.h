// SPDX-License-Identifier: Apache-2.0
// For tests: writes Matroska files, element by element.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/core/clock.h"

namespace roomcast::recording::matroska {

using FixtureBytes = std::vector<std::uint8_t>;

inline void append_big(FixtureBytes& out, std::uint64_t value, int bytes) {
  for (int i = bytes - 1; i >= 0; --i) out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

inline FixtureBytes element(std::uint32_t id, const FixtureBytes& content) {
  FixtureBytes out;
  int id_bytes = 1;
  while (id_bytes < 4 && id >> (8 * id_bytes) != 0) ++id_bytes;
  append_big(out, id, id_bytes);
  append_big(out, content.size() | std::uint64_t{1} << 56U, 8);
  out.insert(out.end(), content.begin(), content.end());
  return out;
}
inline FixtureBytes number(std::uint32_t id, std::uint64_t value) {
  FixtureBytes content;
  append_big(content, value, 8);
  return element(id, content);
}
inline FixtureBytes text(std::uint32_t id, std::string_view value) {
  return element(id, {value.begin(), value.end()});
}
inline FixtureBytes joined(const std::vector<FixtureBytes>& parts) {
  FixtureBytes out;
  for (const FixtureBytes& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}

inline FixtureBytes head() {
  return element(0x1A45DFA3,
                 joined({number(0x4286, 1), number(0x42F7, 1), number(0x42F2, 4), number(0x42F3, 8),
                         text(0x4282, "matroska"), number(0x4287, 2), number(0x4285, 2)}));
}

/// Times are in units of 1 us. `date`: nanoseconds since 2001.
inline FixtureBytes info(std::int64_t date) {
  return element(0x1549A966, joined({number(0x2AD7B1, 1000), text(0x4D80, "test"),
                                     text(0x5741, "k4arecord-test"),
                                     number(0x4461, static_cast<std::uint64_t>(date))}));
}

inline FixtureBytes video_track(std::uint64_t id, std::string_view name, std::string_view four,
                                int width, int height) {
  FixtureBytes header(40);  // BITMAPINFOHEADER
  header[0] = 40;
  header[4] = static_cast<std::uint8_t>(width), header[5] = static_cast<std::uint8_t>(width >> 8);
  header[8] = static_cast<std::uint8_t>(height), header[9] = static_cast<std::uint8_t>(height >> 8);
  header[12] = 1;
  for (std::size_t i = 0; i < 4; ++i) header[16 + i] = static_cast<std::uint8_t>(four[i]);
  return element(
      0xAE, joined({number(0xD7, id), number(0x73C5, id), number(0x83, 1), text(0x536E, name),
                    text(0x86, "V_MS/VFW/FOURCC"), element(0x63A2, header),
                    element(0xE0, joined({number(0xB0, static_cast<std::uint64_t>(width)),
                                          number(0xBA, static_cast<std::uint64_t>(height))}))}));
}

inline FixtureBytes tag(std::string_view name, std::string_view value) {
  return element(0x7373,
                 joined({element(0x63C0, {}),
                         element(0x67C8, joined({text(0x45A3, name), text(0x4487, value)}))}));
}

inline FixtureBytes attachment(std::string_view name, std::string_view content) {
  return element(0x61A7,
                 joined({text(0x466E, name), text(0x4660, "application/octet-stream"),
                         element(0x465C, {content.begin(), content.end()}), number(0x46AE, 7)}));
}

inline FixtureBytes simple_block(std::uint8_t track, std::int16_t time,
                                 const FixtureBytes& picture) {
  FixtureBytes content = {static_cast<std::uint8_t>(0x80U | track)};
  append_big(content, static_cast<std::uint16_t>(time), 2);
  content.push_back(0x80);
  content.insert(content.end(), picture.begin(), picture.end());
  return element(0xA3, content);
}
/// The same as a block in a group.
inline FixtureBytes block_group(std::uint8_t track, std::int16_t time,
                                const FixtureBytes& picture) {
  FixtureBytes block = simple_block(track, time, picture);
  block[0] = 0xA1;
  return element(0xA0, block);
}

inline FixtureBytes cluster(std::uint64_t time, const std::vector<FixtureBytes>& blocks) {
  return element(0x1F43B675, joined({number(0xE7, time), joined(blocks)}));
}

inline FixtureBytes file_of(const std::vector<FixtureBytes>& top_level) {
  return joined({head(), element(0x18538067, joined(top_level))});
}

}  // namespace roomcast::recording::matroska
