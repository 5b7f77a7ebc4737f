// SPDX-License-Identifier: Apache-2.0
// The key is that of RFC 8032, section 7.1, test 2, in the format of the nkeys tool; the signature
// is from the same test.
#include "roomcast/hub/federation/nats/nats_credentials.h"

#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::hub::federation {
namespace {

constexpr char kSeed[] = "SUAEZTIITMUP7FW2TW3MGRXMCFHA6W4KGGPTLK5GETNIZ5XNJ64KN63OVI";
constexpr char kSeedOfAccount[] = "SAAEZTIITMUP7FW2TW3MGRXMCFHA6W4KGGPTLK5GETNIZ5XNJ64KN645MY";

std::string credentials(const std::string& jwt, const std::string& seed) {
  return "-----BEGIN NATS USER JWT-----\n" + jwt +
         "\n------END NATS USER JWT------\n\n"
         "************************* IMPORTANT *************************\n"
         "NKEY Seed printed below can be used to sign and prove identity.\n\n"
         "-----BEGIN USER NKEY SEED-----\r\n" +
         seed + "\r\n------END USER NKEY SEED------\n";
}

TEST(NatsCredentials, signs_with_its_key) {
  const auto own = NatsCredentials::parse(credentials("e30.e30.c2ln", kSeed));
  ASSERT_TRUE(own);
  EXPECT_EQ(own->user_jwt(), "e30.e30.c2ln");
  EXPECT_EQ(own->sign("r"),
            "kqAJqfDUyrhyDoILX2QlQKKye1QWUD-Ps3YiI-"
            "vbadoIWsHkPhWZbkWPNhPQ8R2MOHsurrQwKu6wDSkWErsMAA");
}

TEST(NatsCredentials, refuses_damaged_and_foreign_credentials) {
  std::string damaged = kSeed;
  damaged[20] = damaged[20] == 'A' ? 'B' : 'A';
  for (const std::string& text :
       {std::string(), std::string("nothing"), credentials("", kSeed), credentials("a.b.c", ""),
        credentials("a.b.c", damaged), credentials("a.b.c", kSeedOfAccount),
        credentials("a.b.c", std::string(kSeed) + "A"), credentials("a.b.c", "SUA!"),
        credentials("a.b.c", kSeed).substr(0, 150)}) {
    const auto refused = NatsCredentials::parse(text);
    ASSERT_FALSE(refused) << text;
    EXPECT_EQ(refused.error().code, ErrorCode::kMalformed);
  }
}

TEST(NatsCredentials, errors_name_the_file) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "hub.creds").string();
  EXPECT_EQ(NatsCredentials::load(file).error().code, ErrorCode::kNotFound);
  std::ofstream(file) << "nothing";
  const auto refused = NatsCredentials::load(file);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message,
            file + " holds no credentials of a NATS user, or damaged ones");
  std::ofstream(file) << credentials("a.b.c", kSeed);
  EXPECT_TRUE(NatsCredentials::load(file));
}

}  // namespace
}  // namespace roomcast::hub::federation
