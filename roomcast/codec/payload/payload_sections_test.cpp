// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/payload/payload_sections.h"

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

using Bytes = std::vector<std::uint8_t>;

void append(Bytes& payload, std::uint8_t kind, std::uint8_t codec, const Bytes& content) {
  const std::size_t begin = begin_section(static_cast<SectionKind>(kind), codec, payload);
  payload.insert(payload.end(), content.begin(), content.end());
  end_section(begin, payload);
}

Bytes payload_of(std::initializer_list<std::uint8_t> kinds) {
  Bytes payload;
  for (const std::uint8_t kind : kinds) append(payload, kind, 1, {kind, 0xEE});
  return payload;
}

ErrorCode refusal(const Bytes& payload) {
  const auto sections = parse_sections(payload, 64, 64);
  return sections.ok() ? ErrorCode::kClosed : sections.error().code;
}

TEST(PayloadSections, are_written_as_the_specification_says) {
  EXPECT_EQ(payload_of({3}), (Bytes{3, 1, 0, 0, 2, 0, 0, 0, 3, 0xEE}));
}

TEST(PayloadSections, are_found) {
  const Bytes payload = payload_of({1, 2, 3});
  const auto sections = parse_sections(payload, 64, 64);
  ASSERT_TRUE(sections.ok());
  EXPECT_TRUE(sections->has_color);
  EXPECT_EQ(sections->depth[0], 1);
  EXPECT_EQ(sections->color[0], 2);
  EXPECT_EQ(sections->color_mask[0], 3);
  EXPECT_EQ(sections->color_mask.size(), 2u);
  const Bytes depth_alone = payload_of({1});
  EXPECT_FALSE(parse_sections(depth_alone, 64, 64)->has_color);
}

TEST(PayloadSections, parse_refuses_a_payload_cut_anywhere) {
  const Bytes payload = payload_of({1, 2, 3});
  for (std::size_t length = 0; length < payload.size(); ++length) {
    if (length == 10) continue;  // depth alone is a valid frame
    EXPECT_EQ(
        refusal(Bytes(payload.begin(), payload.begin() + static_cast<std::ptrdiff_t>(length))),
        ErrorCode::kMalformed)
        << length;
  }
}

TEST(PayloadSections, parse_refuses_missing_doubled_and_misplaced_sections) {
  for (const auto& kinds : std::initializer_list<std::initializer_list<std::uint8_t>>{
           {}, {2, 3}, {1, 2}, {1, 3}, {1, 1}, {1, 3, 2}, {2, 1, 3}, {1, 2, 2, 3}}) {
    EXPECT_EQ(refusal(payload_of(kinds)), ErrorCode::kMalformed);
  }
}

TEST(PayloadSections, parse_calls_other_kinds_and_codecs_unsupported) {
  for (const std::uint8_t kind : {0, 4, 33, 255}) {
    EXPECT_EQ(refusal(payload_of({1, kind})), ErrorCode::kUnsupported);
  }
  Bytes payload;
  append(payload, 1, 99, {});
  EXPECT_EQ(refusal(payload), ErrorCode::kUnsupported);
}

TEST(PayloadSections, parse_refuses_a_length_beyond_the_payload) {
  Bytes payload = payload_of({1});
  for (const std::uint8_t high : {0x7F, 0x80, 0xFF}) {
    payload[7] = high;
    EXPECT_EQ(refusal(payload), ErrorCode::kMalformed);
  }
}

TEST(PayloadSections, parse_refuses_a_payload_longer_than_the_limit) {
  Bytes payload;
  append(payload, 1, 1, Bytes(max_payload_length(64, 64) - kSectionHeaderLength));
  EXPECT_EQ(refusal(payload), ErrorCode::kClosed) << "the limit itself is allowed";
  payload.clear();
  append(payload, 1, 1, Bytes(max_payload_length(64, 64) - kSectionHeaderLength + 1));
  EXPECT_EQ(refusal(payload), ErrorCode::kTooLarge);
}

}  // namespace
}  // namespace roomcast::codec
