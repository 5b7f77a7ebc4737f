// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/server/process_stats.h"

#include <fstream>

#include <sys/resource.h>
#include <unistd.h>

namespace roomcast::hub {

namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

ProcessStats process_stats() {
  ProcessStats stats;
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  stats.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  std::uint64_t all_pages = 0, resident_pages = 0;
  if (std::ifstream("/proc/self/statm") >> all_pages >> resident_pages) {
    stats.resident_bytes = resident_pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  }
  return stats;
}

}  // namespace roomcast::hub
