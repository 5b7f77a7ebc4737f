// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/tls/certificate.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <openssl/x509v3.h>
#include <sys/stat.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/net/tls/tls_context.h"
#include "roomcast/net/tls/tls_fixture.h"

namespace roomcast::net {
namespace {

namespace fs = std::filesystem;

class CertificateTest : public ::testing::Test {
 protected:
  fs::path write(const std::string& name, const std::string& text) {
    std::ofstream(directory_ / name) << text;
    return directory_ / name;
  }
  static void expect_error(const Result<Certificate>& result, ErrorCode code,
                           const std::string& part) {
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, code);
    EXPECT_NE(result.error().message.find(part), std::string::npos) << result.error().message;
  }

  const TemporaryFolder directory_;
};

TEST_F(CertificateTest, self_signed_is_for_its_hosts_only) {
  const auto certificate = Certificate::make_self_signed({"hub.local", "192.168.1.5", "::1"});
  ASSERT_TRUE(certificate.ok()) << certificate.error().message;
  X509* leaf = certificate->leaf();
  EXPECT_EQ(X509_check_host(leaf, "hub.local", 0, 0, nullptr), 1);
  EXPECT_EQ(X509_check_ip_asc(leaf, "192.168.1.5", 0), 1);
  EXPECT_EQ(X509_check_ip_asc(leaf, "::1", 0), 1);
  EXPECT_EQ(X509_check_host(leaf, "other.local", 0, 0, nullptr), 0);
  EXPECT_EQ(X509_check_ip_asc(leaf, "192.168.1.6", 0), 0);
}

TEST_F(CertificateTest, every_self_signed_one_is_different) {
  EXPECT_NE(self_signed().fingerprint(), self_signed().fingerprint());
}

TEST_F(CertificateTest, a_host_cannot_smuggle_in_another_extension) {
  const auto certificate = Certificate::make_self_signed({"a,DNS:bank.example\ncritical"});
  if (!certificate.ok()) return;
  EXPECT_EQ(X509_check_host(certificate->leaf(), "bank.example", 0, 0, nullptr), 0);
}

TEST_F(CertificateTest, comes_back_from_a_file_that_only_its_owner_may_read) {
  const auto certificate = self_signed();
  const fs::path file = directory_ / "hub.pem";
  ASSERT_TRUE(certificate.save(file).ok());
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  const auto loaded = Certificate::load(file, file);
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  EXPECT_EQ(loaded->fingerprint(), certificate.fingerprint());
}

TEST_F(CertificateTest, names_the_fault_of_each_file) {
  ASSERT_TRUE(self_signed().save(directory_ / "one.pem").ok());
  ASSERT_TRUE(self_signed().save(directory_ / "other.pem").ok());
  const auto one = directory_ / "one.pem", other = directory_ / "other.pem";
  const auto text = write("text.pem", "not a certificate\n");
  expect_error(Certificate::load(directory_ / "none.pem", one), ErrorCode::kNotFound, "none.pem");
  expect_error(Certificate::load(text, one), ErrorCode::kMalformed, "no certificate");
  expect_error(Certificate::load(one, text), ErrorCode::kMalformed, "no private key");
  expect_error(Certificate::load(one, other), ErrorCode::kMalformed, "does not belong to");
}

TEST_F(CertificateTest, that_is_no_file_is_refused_at_once) {
  ASSERT_EQ(::mkfifo((directory_ / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(Certificate::load(directory_ / "pipe", directory_ / "pipe").error().code,
            ErrorCode::kMalformed);
  EXPECT_EQ(Certificate::load("/dev/zero", "/dev/zero").error().code, ErrorCode::kTooLarge);
  TlsClientFiles files;
  files.authorities_file = "/dev/zero";
  EXPECT_FALSE(TlsClientContext::create(files).ok());
}

TEST_F(CertificateTest, that_cannot_be_written_is_an_error) {
  const auto status = self_signed().save(directory_ / "no" / "such" / "folder.pem");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kUnavailable);
}

}  // namespace
}  // namespace roomcast::net
