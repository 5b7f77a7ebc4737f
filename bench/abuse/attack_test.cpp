// SPDX-License-Identifier: Apache-2.0
#include "bench/abuse/attack.h"

#include <chrono>
#include <functional>

#include <gtest/gtest.h>

#include "roomcast/hub/server/hub_server.h"

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

class AttackTest : public testing::Test {
 protected:
  AttackTest() {
    hub::HubOptions options;
    options.port = 0;
    hub = std::move(*hub::HubServer::open(options));
    thread = std::jthread([this](const std::stop_token& stop) { hub->run(stop); });
  }
  static bool happens(const std::function<bool()>& done) {
    const auto give_up = std::chrono::steady_clock::now() + 10s;
    while (!done() && std::chrono::steady_clock::now() < give_up) std::this_thread::sleep_for(2ms);
    return done();
  }

  std::unique_ptr<hub::HubServer> hub;
  std::jthread thread;
};

TEST_F(AttackTest, of_each_kind_reaches_the_hub) {
  for (const AttackKind kind :
       {AttackKind::kHalfOpen, AttackKind::kGarbage, AttackKind::kSlowloris}) {
    const Attack attack(kind, hub->port(), 5);
    EXPECT_TRUE(happens([&] { return attack.counts().tried >= 5; })) << name_of(kind);
  }
}

TEST_F(AttackTest, with_bad_tokens_is_answered_and_has_an_end) {
  const Attack attack(AttackKind::kBadTokens, hub->port(), 20);
  EXPECT_TRUE(happens([&] { return attack.is_over(); }));
  EXPECT_EQ(attack.counts().served, 20U);
}

}  // namespace
}  // namespace roomcast::bench
