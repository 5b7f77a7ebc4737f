// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/web_site.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

using testing::HasSubstr;

std::string site_fault(std::string_view text) {
  const auto site = parse_web_site(text);
  return site ? "" : site.error().message;
}

TEST(WebSite, is_written_as_browsers_do) {
  EXPECT_EQ(*parse_web_site("https://Example.org"), "https://example.org");
  EXPECT_EQ(*parse_web_site("HTTPS://example.org:443"), "https://example.org");
  EXPECT_EQ(*parse_web_site("https://example.org:8443"), "https://example.org:8443");
  EXPECT_EQ(*parse_web_site("http://127.0.0.1:80"), "http://127.0.0.1");
  EXPECT_EQ(*parse_web_site("http://localhost:5173"), "http://localhost:5173");
  EXPECT_EQ(*parse_web_site("https://example.org:80"), "https://example.org:80");
}

TEST(WebSite, nonsense_is_refused_with_a_sentence) {
  EXPECT_THAT(site_fault("example.org"), HasSubstr("with https:// or http://"));
  EXPECT_THAT(site_fault("*"), HasSubstr("with https:// or http://"));
  EXPECT_THAT(site_fault("null"), HasSubstr("no web site"));
  EXPECT_THAT(site_fault(""), HasSubstr("no web site"));
  EXPECT_THAT(site_fault("wss://example.org"), HasSubstr("with https:// or http://"));
  EXPECT_THAT(site_fault("https://*.example.org"), HasSubstr("name each site"));
  EXPECT_THAT(site_fault("https://example.org/"), HasSubstr("without a path"));
  EXPECT_THAT(site_fault("https://example.org?a"), HasSubstr("without a path"));
  EXPECT_THAT(site_fault("https://[::1]:80"), HasSubstr("IPv6"));
  EXPECT_THAT(site_fault("https://"), HasSubstr("write https://example.org"));
  EXPECT_THAT(site_fault("https://example.org:99999"), HasSubstr("write https://example.org"));
}

TEST(WebSite, what_means_something_in_a_policy_is_refused) {
  for (const char* text : {"https://a.org; script-src *", "https://a.org 'self'", "https://a.org,b",
                           "https://a.org\r\nX: y", "https://'self'", "https://user@a.org"})
    EXPECT_NE(site_fault(text), "") << text;
}

}  // namespace
}  // namespace roomcast::net
