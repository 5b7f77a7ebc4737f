// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/cluster/subjects.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "roomcast/net/random_bytes.h"

namespace roomcast::hub::federation {
namespace {

constexpr std::string_view kRoomPrefix = "roomcast.room.";
constexpr std::string_view kInboxPrefix = "roomcast.hub.";
constexpr char kHexDigits[] = "0123456789abcdef";

bool is_plain(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
         c == '_';
}

/// A room's name as one word of a subject; special characters are escaped as "=20".
std::string word_of(std::string_view room) {
  std::string word;
  for (const char c : room) {
    if (is_plain(c)) {
      word += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    word += {'=', kHexDigits[byte >> 4], kHexDigits[byte & 15]};
  }
  return word;
}

template <class Number>
bool read_hex(std::string_view text, Number& number) {
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
  return fault == std::errc() && end == text.data() + text.size() && !text.empty();
}

std::optional<std::string> room_of(std::string_view word) {
  std::string room;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (word[i] != '=') {
      room += word[i];
      continue;
    }
    unsigned byte = 0;
    if (i + 2 >= word.size() || !read_hex(word.substr(i + 1, 2), byte)) return std::nullopt;
    room += static_cast<char>(byte);
    i += 2;
  }
  return room;
}

/// Removes the first word and the following dot from `text`.
std::string_view take_word(std::string_view& text) {
  const auto word = text.substr(0, text.find('.'));
  text.remove_prefix(std::min(word.size() + 1, text.size()));
  return word;
}

}  // namespace

HubId new_hub_id() {
  HubId id;
  while (id.value == 0) {
    std::array<std::uint8_t, sizeof id.value> bytes{};
    net::fill_with_random_bytes(bytes);
    for (const auto byte : bytes) id.value = id.value << 8 | byte;
  }
  return id;
}

std::string to_string(HubId hub) {
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += kHexDigits[hub.value >> shift & 15];
  return text;
}

std::string inbox_subject(HubId hub) {
  return std::string(kInboxPrefix) + to_string(hub);
}

std::string news_subject(std::string_view room) {
  return std::string(kRoomPrefix) + word_of(room) + ".news";
}

std::string frames_subject(std::string_view room, HubId from) {
  return std::string(kRoomPrefix) + word_of(room) + ".frames." + to_string(from);
}

std::string all_frames_subject(std::string_view room) {
  return std::string(kRoomPrefix) + word_of(room) + ".frames.*";
}

std::string poses_subject(std::string_view room) {
  return std::string(kRoomPrefix) + word_of(room) + ".poses";
}

std::optional<ReadSubject> read_subject(std::string_view subject) {
  if (subject == kHeartbeatSubject) return ReadSubject{Subject::kHeartbeat};
  if (subject == kRevokedSubject) return ReadSubject{Subject::kRevoked};
  if (subject.starts_with(kInboxPrefix)) return ReadSubject{Subject::kInbox};
  if (!subject.starts_with(kRoomPrefix)) return std::nullopt;
  subject.remove_prefix(kRoomPrefix.size());
  auto room = room_of(take_word(subject));
  if (!room) return std::nullopt;
  if (subject == "news") return ReadSubject{Subject::kNews, *std::move(room)};
  if (subject == "poses") return ReadSubject{Subject::kPoses, *std::move(room)};
  ReadSubject frames{Subject::kFrames, *std::move(room)};
  if (take_word(subject) != "frames" || !read_hex(subject, frames.hub.value)) return std::nullopt;
  return frames;
}

}  // namespace roomcast::hub::federation
