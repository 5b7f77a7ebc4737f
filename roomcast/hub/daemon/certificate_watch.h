// SPDX-License-Identifier: Apache-2.0
// CertificateWatch: detects that a hub's certificate files were renewed and passes on the new
// certificate, so that the hub need not be restarted. Checks once a second by default. A
// certificate that cannot be loaded is reported once, and the old one stays in use. Threading: has
// its own thread, which calls `take` and `log`.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>

#include "roomcast/core/log.h"
#include "roomcast/net/tls/certificate.h"

namespace roomcast::hub::daemon {

class CertificateWatch {
 public:
  using Take = std::function<Status(const net::Certificate&)>;

  /// `asked`: setting it reloads the files even if they have not changed.
  CertificateWatch(std::filesystem::path certificate, std::filesystem::path key, Take take,
                   std::atomic<bool>& asked, LogSink log,
                   std::chrono::milliseconds check_every = std::chrono::seconds(1));

 private:
  using Stamp = std::pair<std::filesystem::file_time_type, std::filesystem::file_time_type>;
  [[nodiscard]] Stamp stamp() const;
  void check_files();

  const std::filesystem::path certificate_, key_;
  const Take take_;
  std::atomic<bool>& asked_;
  const LogSink log_;
  Stamp seen_;
  std::jthread thread_;  // last: uses all of the above
};

}  // namespace roomcast::hub::daemon
