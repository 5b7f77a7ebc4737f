// SPDX-License-Identifier: Apache-2.0
// The files of fuzz/corpus/lzfse were made by Apple's reference encoder; what is in them is made
// here again.
#include "roomcast/recording/lzfse/lzfse.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

namespace roomcast::recording {
namespace {

using LzBytes = std::vector<std::uint8_t>;

LzBytes encoded(const char* name) {
  const auto path = std::filesystem::path(ROOMCAST_SOURCE_DIR) / "fuzz/corpus/lzfse" / name;
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

template <class Number>
void append_number(LzBytes& out, Number number) {
  out.resize(out.size() + sizeof(number));
  std::memcpy(out.data() + out.size() - sizeof(number), &number, sizeof(number));
}

/// 96 x 64 depths as floats: a slanted, curved wall with noise and gaps.
LzBytes wall() {
  LzBytes out;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 96; ++x) {
      const int depth = 1000 + 3 * x + y * y / 8 + ((x * 7919 + y * 104729) >> 4) % 5;
      append_number(out, (x + y) % 17 == 0 ? 0.F : static_cast<float>(depth) / 1024);
    }
  }
  return out;
}

LzBytes steps() {
  LzBytes out;
  for (int i = 0; i < 1200; ++i)
    append_number(out, static_cast<std::uint16_t>(1000 + i % 13 + (i * i >> 7) % 3));
  return out;
}

LzBytes cubes() {
  LzBytes out;
  for (int i = 0; i < 200; ++i) out.push_back(static_cast<std::uint8_t>(i * i * i >> 3));
  return out;
}

struct LzfseCase {
  const char* file;
  const char* block;
  LzBytes content;
};

std::vector<LzfseCase> lzfse_cases() {
  return {{"entropy", "bvx2", wall()}, {"lzvn", "bvxn", steps()}, {"plain", "bvx-", cubes()}};
}

TEST(Lzfse, what_the_reference_has_encoded_is_decoded) {
  for (const LzfseCase& one : lzfse_cases()) {
    const LzBytes bytes = encoded(one.file);
    ASSERT_EQ(std::memcmp(bytes.data(), one.block, 4), 0) << one.file;
    LzBytes out;
    ASSERT_TRUE(decode_lzfse(bytes, one.content.size(), out)) << one.file;
    EXPECT_TRUE(out == one.content) << one.file;
  }
}

TEST(Lzfse, blocks_follow_one_another) {
  LzBytes bytes = encoded("entropy"), more = encoded("lzvn"), content = wall(), out;
  bytes.resize(bytes.size() - 4);  // without its end
  bytes.insert(bytes.end(), more.begin(), more.end());
  const LzBytes rest = steps();
  content.insert(content.end(), rest.begin(), rest.end());
  ASSERT_TRUE(decode_lzfse(bytes, content.size(), out));
  EXPECT_TRUE(out == content);
}

TEST(Lzfse, another_size_is_refused) {
  for (const LzfseCase& one : lzfse_cases()) {
    LzBytes out;
    EXPECT_FALSE(decode_lzfse(encoded(one.file), one.content.size() - 1, out));
    EXPECT_FALSE(decode_lzfse(encoded(one.file), one.content.size() + 1, out));
    EXPECT_FALSE(decode_lzfse(encoded(one.file), 0, out));
  }
}

TEST(Lzfse, what_is_cut_or_of_another_kind_is_refused) {
  for (const LzfseCase& one : lzfse_cases()) {
    const LzBytes bytes = encoded(one.file);
    LzBytes out;
    for (std::size_t size = 0; size < bytes.size(); ++size)
      ASSERT_FALSE(decode_lzfse(std::span(bytes).first(size), one.content.size(), out)) << size;
    LzBytes other = bytes;
    other[3] = 'z';
    EXPECT_FALSE(decode_lzfse(other, one.content.size(), out));
  }
}

TEST(Lzfse, damaged_bytes_never_leave_the_size) {
  for (const LzfseCase& one : lzfse_cases()) {
    const LzBytes bytes = encoded(one.file);
    for (std::size_t at = 0; at < bytes.size(); at += 1 + bytes.size() / 400) {
      for (const int flip : {1, 0x80, 0xFF}) {
        LzBytes damaged = bytes, out;
        damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ flip);
        if (decode_lzfse(damaged, one.content.size(), out)) {
          EXPECT_EQ(out.size(), one.content.size());
        } else {
          EXPECT_LE(out.size(), one.content.size());
        }
      }
    }
  }
}

}  // namespace
}  // namespace roomcast::recording
