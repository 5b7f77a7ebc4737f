// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/hub_certificate.h"

#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::hub::daemon {
namespace {

namespace fs = std::filesystem;

class HubCertificate : public ::testing::Test {
 protected:
  [[nodiscard]] HubCertificateOptions self_signed() const {
    HubCertificateOptions options;
    options.self_signed = true;
    options.data_folder = folder_ / "new";
    return options;
  }

  const TemporaryFolder scratch_;
  const fs::path folder_ = scratch_ / "certificates";
};

TEST_F(HubCertificate, is_absent_by_default) {
  const auto certificate = find_hub_certificate({});
  ASSERT_TRUE(certificate.ok());
  EXPECT_FALSE(certificate->has_value());
}

TEST_F(HubCertificate, self_signed_stays_the_same_across_restarts) {
  const auto first = find_hub_certificate(self_signed());
  ASSERT_TRUE(first.ok()) << first.error().message;
  const auto second = find_hub_certificate(self_signed());
  ASSERT_TRUE(second.ok()) << second.error().message;
  EXPECT_EQ((*first)->fingerprint(), (*second)->fingerprint());
}

TEST_F(HubCertificate, a_damaged_self_signed_certificate_is_an_error) {
  ASSERT_TRUE(find_hub_certificate(self_signed()).ok());
  std::ofstream(folder_ / "new" / "self-signed.pem") << "gone";
  const auto certificate = find_hub_certificate(self_signed());
  ASSERT_FALSE(certificate.ok());
  EXPECT_EQ(certificate.error().code, ErrorCode::kMalformed);
}

TEST_F(HubCertificate, reading_creates_no_self_signed_certificate) {
  auto options = self_signed();
  options.only_look = true;
  const auto none = find_hub_certificate(options);
  ASSERT_TRUE(none.ok()) << none.error().message;
  EXPECT_FALSE(none->has_value());
  EXPECT_FALSE(fs::exists(folder_));
  ASSERT_TRUE(find_hub_certificate(self_signed()).ok());
  EXPECT_TRUE(find_hub_certificate(options)->has_value());
}

TEST_F(HubCertificate, contradicting_options_are_wrong_usage) {
  auto both = self_signed();
  both.certificate_file = "a.pem";
  both.key_file = "a.pem";
  HubCertificateOptions half;
  half.certificate_file = "a.pem";
  for (const auto& options : {both, half}) {
    const auto certificate = find_hub_certificate(options);
    ASSERT_FALSE(certificate.ok());
    EXPECT_EQ(certificate.error().code, ErrorCode::kInvalidArgument);
  }
}

}  // namespace
}  // namespace roomcast::hub::daemon
