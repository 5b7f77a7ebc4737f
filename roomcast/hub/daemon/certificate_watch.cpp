// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/certificate_watch.h"

#include <system_error>
#include <utility>

#include "roomcast/core/interruptible_wait.h"

namespace roomcast::hub::daemon {

CertificateWatch::CertificateWatch(std::filesystem::path certificate, std::filesystem::path key,
                                   Take take, std::atomic<bool>& asked, LogSink log,
                                   std::chrono::milliseconds check_every)
    : certificate_(std::move(certificate)),
      key_(std::move(key)),
      take_(std::move(take)),
      asked_(asked),
      log_(std::move(log)),
      seen_(stamp()),
      thread_([this, check_every](const std::stop_token& stop) {
        while (wait_for(check_every, stop)) check_files();
      }) {}

CertificateWatch::Stamp CertificateWatch::stamp() const {
  std::error_code absent;
  return {std::filesystem::last_write_time(certificate_, absent),
          std::filesystem::last_write_time(key_, absent)};
}

/// If only one of the two files is written yet, they do not match; a later check loads both.
void CertificateWatch::check_files() {
  const Stamp now = stamp();
  if (!asked_.exchange(false) && now == seen_) return;
  seen_ = now;
  const auto certificate = net::Certificate::load(certificate_, key_);
  const Status taken = certificate ? take_(*certificate) : Status(certificate.error());
  if (taken) return log_(LogLevel::kInfo, "the certificate was renewed");
  log_(LogLevel::kWarning, "the old certificate is kept: " + taken.error().message);
}

}  // namespace roomcast::hub::daemon
