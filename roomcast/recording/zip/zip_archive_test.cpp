// SPDX-License-Identifier: Apache-2.0
// Real ZIP files, by Info-ZIP, are in fuzz/corpus/zip.
#include "roomcast/recording/zip/zip_archive.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "roomcast/recording/zip/zip_fixture.h"

namespace roomcast::recording {
namespace {

using ZipBytes = ZipWriter::Bytes;

std::string text_of(const ZipArchive& archive, const std::string& name) {
  const ZipEntry* const entry = archive.find(name);
  if (entry == nullptr) return "no such file";
  ZipBytes out;
  const Status status = archive.extract(*entry, 1 << 20, out);
  return status ? std::string(out.begin(), out.end()) : status.error().message;
}

ZipWriter two_files() {
  ZipWriter writer;
  writer.add("a/one", "first").add("two", std::string(5000, 'x'), true);
  return writer;
}

TEST(ZipArchive, files_are_read_stored_and_deflated) {
  for (const ZipBytes& bytes :
       {two_files().done(), two_files().done("PK\5\6 is a comment"), two_files().done_in_64()}) {
    const auto archive = ZipArchive::read(bytes_in_memory(bytes));
    ASSERT_TRUE(archive.ok()) << archive.error().message;
    EXPECT_EQ(archive->entries().size(), 2u);
    EXPECT_EQ(text_of(*archive, "a/one"), "first");
    EXPECT_EQ(text_of(*archive, "two"), std::string(5000, 'x'));
    EXPECT_EQ(text_of(*archive, "three"), "no such file");
  }
}

TEST(ZipArchive, another_program_is_understood) {
  for (const char* name : {"deflated.zip", "stored.zip"}) {
    const auto path = std::filesystem::path(ROOMCAST_SOURCE_DIR) / "fuzz/corpus/zip" / name;
    auto source = open_file(path);
    ASSERT_TRUE(source.ok());
    const auto archive = ZipArchive::read(*std::move(source));
    ASSERT_TRUE(archive.ok()) << archive.error().message;
    EXPECT_EQ(text_of(*archive, "rgbd/0.txt"), "zero zero zero zero zero zero zero zero\n");
  }
}

TEST(ZipArchive, what_is_cut_is_refused) {
  const ZipBytes bytes = two_files().done();
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(
        ZipArchive::read(
            bytes_in_memory({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)}))
            .ok())
        << size;
}

TEST(ZipArchive, damaged_files_are_refused_one_by_one) {
  ZipBytes bytes = two_files().done();
  bytes[30 + 5] ^= 1U;  // the first letter of "first"
  const auto archive = ZipArchive::read(bytes_in_memory(bytes));
  ASSERT_TRUE(archive.ok());
  EXPECT_EQ(text_of(*archive, "a/one"), "a file in it is damaged");
  EXPECT_EQ(text_of(*archive, "two"), std::string(5000, 'x'));
}

TEST(ZipArchive, large_files_are_refused_before_memory_is_taken) {
  const auto archive = ZipArchive::read(bytes_in_memory(two_files().done()));
  ZipBytes out;
  const Status status = archive->extract(*archive->find("two"), 4999, out);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kTooLarge);
}

}  // namespace
}  // namespace roomcast::recording
