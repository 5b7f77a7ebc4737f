// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/static_site.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::net {
namespace {

namespace fs = std::filesystem;

class StaticSiteTest : public ::testing::Test {
 protected:
  StaticSiteTest() { fs::create_directories(folder_); }

  void write(const std::string& name, const std::string& content) {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << content;
  }

  const TemporaryFolder scratch_;
  const fs::path folder_ = scratch_ / "site";
};

TEST_F(StaticSiteTest, serves_files_with_their_type) {
  write("index.html", "<p>room");
  write("assets/main-1a2b.js", "run()");
  write("depth.wasm", std::string("\0asm", 4));
  const auto site = StaticSite::load(folder_);
  ASSERT_TRUE(site.ok()) << site.error().message;
  EXPECT_EQ(site->file_count(), 3U);
  const auto script = site->find("/assets/main-1a2b.js");
  ASSERT_TRUE(script);
  EXPECT_EQ(*script->body, "run()");
  EXPECT_EQ(script->content_type, "text/javascript; charset=utf-8");
  EXPECT_EQ(site->find("/depth.wasm")->content_type, "application/wasm");
  EXPECT_EQ(*site->find("/depth.wasm")->body, std::string("\0asm", 4));
}

TEST_F(StaticSiteTest, a_folder_is_its_index) {
  write("index.html", "top");
  write("console/index.html", "console");
  const auto site = StaticSite::load(folder_);
  ASSERT_TRUE(site.ok());
  EXPECT_EQ(*site->find("/")->body, "top");
  EXPECT_EQ(*site->find("/console/")->body, "console");
  EXPECT_FALSE(site->find("/console"));
}

TEST_F(StaticSiteTest, a_compressed_file_is_served_in_place_of_its_original) {
  write("index.html", "top");
  write("index.html.gz", "squeezed");
  write("archive.gz", "on its own");
  const auto site = StaticSite::load(folder_);
  ASSERT_TRUE(site.ok());
  EXPECT_EQ(*site->find("/")->body, "top");
  EXPECT_EQ(*site->find("/")->gzip, "squeezed");
  EXPECT_FALSE(site->find("/index.html.gz"));
  EXPECT_EQ(*site->find("/archive.gz")->body, "on its own");
  EXPECT_EQ(site->find("/archive.gz")->gzip, nullptr);
}

TEST_F(StaticSiteTest, only_names_with_a_hash_are_kept_for_ever) {
  write("index.html", "top");
  write("assets/main-1a2b.js", "run()");
  const auto site = StaticSite::load(folder_);
  ASSERT_TRUE(site.ok());
  EXPECT_EQ(site->find("/")->cache_control, "no-cache");
  EXPECT_NE(site->find("/assets/main-1a2b.js")->cache_control.find("immutable"), std::string::npos);
}

TEST_F(StaticSiteTest, etags_follow_the_content) {
  write("index.html", "one");
  write("same.html", "one");
  write("other.html", "two");
  const auto site = StaticSite::load(folder_);
  ASSERT_TRUE(site.ok());
  EXPECT_EQ(site->find("/")->etag, site->find("/same.html")->etag);
  EXPECT_NE(site->find("/")->etag, site->find("/other.html")->etag);
  EXPECT_TRUE(site->find("/")->etag.starts_with('"'));
}

TEST_F(StaticSiteTest, files_outside_the_folder_are_not_served) {
  write("index.html", "top");
  const fs::path secret = folder_.string() + "_secret";
  std::ofstream(secret) << "secret";
  fs::create_symlink(secret, folder_ / "link.txt");
  write(".env", "secret");
  write(".git/config", "secret");
  const auto site = StaticSite::load(folder_);
  fs::remove(secret);
  ASSERT_TRUE(site.ok());
  EXPECT_EQ(site->file_count(), 1U);
  for (const char* path :
       {"/link.txt", "/.env", "/.git/config", "/../x", "/..%2fx", "", "index.html", "//index.html",
        "/./index.html", "/assets/../index.html"}) {
    EXPECT_FALSE(site->find(path)) << path;
  }
}

TEST_F(StaticSiteTest, names_a_missing_file) {
  const auto nowhere = StaticSite::load(folder_ / "nowhere");
  ASSERT_FALSE(nowhere.ok());
  EXPECT_EQ(nowhere.error().code, ErrorCode::kNotFound);
  write("main.js", "run()");
  const auto no_index = StaticSite::load(folder_);
  ASSERT_FALSE(no_index.ok());
  EXPECT_NE(no_index.error().message.find("no index.html"), std::string::npos);
}

TEST_F(StaticSiteTest, refuses_a_folder_that_is_too_large) {
  write("index.html", "top");
  write("big.bin", "");
  fs::resize_file(folder_ / "big.bin", StaticSite::kMaxBytes);  // sparse; with index.html too much
  const auto site = StaticSite::load(folder_);
  ASSERT_FALSE(site.ok());
  EXPECT_EQ(site.error().code, ErrorCode::kTooLarge);
}

TEST_F(StaticSiteTest, refuses_a_folder_with_too_many_files) {
  write("index.html", "top");
  for (std::size_t i = 0; i < StaticSite::kMaxFiles; ++i) {
    std::ofstream(folder_ / std::to_string(i));
  }
  const auto site = StaticSite::load(folder_);
  ASSERT_FALSE(site.ok());
  EXPECT_EQ(site.error().code, ErrorCode::kTooLarge);
}

TEST(ContentType, of_unknown_endings_is_just_bytes) {
  EXPECT_EQ(content_type_of("a.html"), "text/html; charset=utf-8");
  EXPECT_EQ(content_type_of("a.woff2"), "font/woff2");
  EXPECT_EQ(content_type_of("a"), "application/octet-stream");
}

}  // namespace
}  // namespace roomcast::net
