// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/hub_aligners.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace roomcast::hub::daemon {
namespace {

TEST(HubAligners, an_aligner_that_cannot_begin_is_a_warning) {
  OwnHub own;
  own.opened({.listen_address = "no host", .port = 7600}, "token");
  std::vector<std::string> warnings;
  HubAligners aligners(own, [&warnings](LogLevel level, std::string_view line) {
    if (level == LogLevel::kWarning) warnings.emplace_back(line);
  });
  aligners.start("room");
  EXPECT_EQ(warnings.size(), 1U);
  aligners.stop("room");  // there is none
}

}  // namespace
}  // namespace roomcast::hub::daemon
