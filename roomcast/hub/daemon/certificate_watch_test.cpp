// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/certificate_watch.h"

#include <condition_variable>
#include <fstream>
#include <mutex>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::hub::daemon {
namespace {

using namespace std::chrono_literals;

class CertificateWatchTest : public testing::Test {
 protected:
  CertificateWatchTest() { write("a.example"); }

  net::Fingerprint write(const std::string& host) {
    const auto certificate = *net::Certificate::make_self_signed({host});
    EXPECT_TRUE(certificate.save(file).ok());
    // File timestamps are coarse, so each write gets a distinctly later one.
    std::filesystem::last_write_time(
        file, std::filesystem::file_time_type::clock::now() + std::chrono::seconds(++writes));
    return certificate.fingerprint();
  }

  CertificateWatch watch() {
    return {file,
            file,
            [this](const net::Certificate& certificate) -> Status {
              const std::lock_guard lock(mutex);
              taken.push_back(certificate.fingerprint());
              changed.notify_all();
              return {};
            },
            asked,
            [this](LogLevel level, std::string_view line) {
              const std::lock_guard lock(mutex);
              if (level == LogLevel::kWarning) complaint = line;
              changed.notify_all();
            },
            2ms};
  }

  bool wait_until(const std::function<bool()>& done) {
    std::unique_lock lock(mutex);
    return changed.wait_for(lock, 10s, done);
  }

  TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "certificate.pem";
  int writes = 0;
  std::atomic<bool> asked = false;
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<net::Fingerprint> taken;
  std::string complaint;
};

TEST_F(CertificateWatchTest, a_renewed_certificate_is_passed_on) {
  const CertificateWatch watching = watch();
  const auto renewed = write("b.example");
  ASSERT_TRUE(wait_until([&] { return !taken.empty() && taken.back() == renewed; }));
}

TEST_F(CertificateWatchTest, a_signal_reloads_it) {
  const CertificateWatch watching = watch();
  asked = true;
  EXPECT_TRUE(wait_until([&] { return !taken.empty(); }));
}

TEST_F(CertificateWatchTest, an_unreadable_certificate_leaves_the_old_one) {
  const CertificateWatch watching = watch();
  std::ofstream(file) << "nonsense";
  std::filesystem::last_write_time(file, std::filesystem::file_time_type::clock::now() + 1h);
  ASSERT_TRUE(wait_until([&] { return !complaint.empty(); }));
  EXPECT_NE(complaint.find("the old certificate is kept"), std::string::npos);
  EXPECT_TRUE(taken.empty());
}

}  // namespace
}  // namespace roomcast::hub::daemon
