// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/own_hub.h"

#include <gtest/gtest.h>

#include "roomcast/net/hub_url.h"

namespace roomcast::hub::daemon {
namespace {

std::string url_at(const std::string& listen_address) {
  OwnHub hub;
  hub.opened({.listen_address = listen_address, .port = 7600}, "token");
  EXPECT_EQ(hub.access().token, "token");
  return hub.access().url;
}

TEST(OwnHub, a_hub_that_listens_everywhere_is_reached_on_loopback) {
  EXPECT_EQ(url_at("0.0.0.0"), "ws://127.0.0.1:7600");
  EXPECT_EQ(url_at("::"), "ws://[::1]:7600");
  EXPECT_EQ(url_at("192.168.1.5"), "ws://192.168.1.5:7600");
}

TEST(OwnHub, an_encrypted_hub_is_trusted_by_its_certificate_and_by_a_renewed_one) {
  OwnHub hub;
  net::Fingerprint certificate{};
  hub.opened({.port = 7600, .certificate = certificate}, "token");
  auto url = net::parse_hub_url(hub.access().url);
  ASSERT_TRUE(url.ok()) << url.error().message;
  EXPECT_EQ(url->pinned, certificate);
  certificate[0] = 7;
  hub.trust(certificate);
  url = net::parse_hub_url(hub.access().url);
  ASSERT_TRUE(url.ok()) << url.error().message;
  EXPECT_EQ(url->pinned, certificate);
}

}  // namespace
}  // namespace roomcast::hub::daemon
