// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/hub_aligners.h"

#include <gtest/gtest.h>

#include "roomcast/net/hub_url.h"

namespace roomcast::hub::daemon {
namespace {

TEST(HubAligners, a_hub_that_listens_everywhere_is_reached_on_loopback) {
  OwnHub options;
  options.port = 7600;
  options.listen_address = "0.0.0.0";
  EXPECT_EQ(own_hub_url(options), "ws://127.0.0.1:7600");
  options.listen_address = "::";
  EXPECT_EQ(own_hub_url(options), "ws://[::1]:7600");
  options.listen_address = "192.168.1.5";
  EXPECT_EQ(own_hub_url(options), "ws://192.168.1.5:7600");
}

TEST(HubAligners, an_encrypted_hub_is_trusted_by_its_certificate) {
  OwnHub options;
  options.port = 7600;
  options.certificate.emplace();
  const auto url = net::parse_hub_url(own_hub_url(options));
  ASSERT_TRUE(url.ok()) << url.error().message;
  EXPECT_EQ(url->pinned, options.certificate);
}

}  // namespace
}  // namespace roomcast::hub::daemon
