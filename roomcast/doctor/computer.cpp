// SPDX-License-Identifier: Apache-2.0
#include "roomcast/doctor/computer.h"

#include <charconv>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/timex.h>

#include "roomcast/hub/daemon/data_folder.h"

namespace roomcast::doctor {
namespace {

constexpr double kGiB = 1024.0 * 1024 * 1024;
// By hand. A hub with a sensor and its aligner took 0.3 GiB, three sensors and a window 0.8 GiB.
constexpr double kLittleMemory_GiB = 1;
constexpr double kLittleDisk_GiB = 1, kFewHours_GiB = 10;
constexpr std::uint64_t kFewDescriptors = 1024;
// A sensor in live mode with colour: docs/benchmarks/codec.md, two people exercising.
constexpr double kSensorBytesPerHour = 0.24e6 * 3600;

}  // namespace

Finding judge_processor(unsigned cores) {
  Finding finding{"processor", Verdict::kOk,
                  fmt::format("{} core{} can be used.", cores, cores == 1 ? "" : "s")};
  if (cores >= 2) return finding;
  finding.verdict = Verdict::kNotice;
  finding.remedy = "Run sensors and viewers on other computers than the hub.";
  return finding;
}

Finding judge_memory(std::uint64_t available_bytes) {
  const double gib = static_cast<double>(available_bytes) / kGiB;
  Finding finding{"memory", Verdict::kOk, fmt::format("{:.1f} GiB are available.", gib)};
  if (gib >= kLittleMemory_GiB) return finding;
  finding.verdict = Verdict::kNotice;
  finding.remedy = "End other programs: a room with three sensors and a window needs about 1 GiB.";
  return finding;
}

Finding judge_descriptors(std::uint64_t limit) {
  Finding finding{"connections", Verdict::kOk,
                  fmt::format("A program may have {} files and sockets open.", limit)};
  if (limit >= kFewDescriptors) return finding;
  finding.verdict = Verdict::kNotice;
  finding.remedy = "Raise the limit before starting a hub with many viewers: ulimit -n 4096";
  return finding;
}

Finding judge_clock(bool is_synchronized) {
  if (is_synchronized) return {"clock", Verdict::kOk, "The clock follows a time server."};
  return {"clock", Verdict::kNotice,
          "The clock does not follow a time server. Rooms have a clock of their own and do not "
          "depend on it, but dates of recordings and the end of tokens do.",
          "Switch synchronisation on: timedatectl set-ntp true"};
}

Finding judge_disk(const std::filesystem::path& folder, std::uint64_t free_bytes) {
  const double gib = static_cast<double>(free_bytes) / kGiB;
  Finding finding{
      "disk", Verdict::kOk,
      fmt::format("{:.1f} GiB are free in {}: about {:.0f} hours of recording for one sensor.", gib,
                  folder.string(), static_cast<double>(free_bytes) / kSensorBytesPerHour)};
  if (gib >= kFewHours_GiB) return finding;
  finding.verdict = gib < kLittleDisk_GiB ? Verdict::kProblem : Verdict::kNotice;
  finding.remedy = "Free some space, or name another folder: roomcast hub --data DIR";
  return finding;
}

std::optional<std::uint64_t> available_memory_bytes(std::string_view meminfo) {
  constexpr std::string_view kName = "MemAvailable:";
  auto at = meminfo.find(kName);
  if (at == std::string_view::npos) return std::nullopt;
  at = meminfo.find_first_not_of(' ', at + kName.size());
  if (at == std::string_view::npos) return std::nullopt;
  std::uint64_t kib = 0;
  const auto read = std::from_chars(meminfo.data() + at, meminfo.data() + meminfo.size(), kib);
  if (read.ec != std::errc()) return std::nullopt;
  return kib * 1024;
}

Finding check_processor() {
  return judge_processor(std::thread::hardware_concurrency());
}

Finding check_memory() {
  std::ifstream file("/proc/meminfo");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (const auto bytes = available_memory_bytes(text)) return judge_memory(*bytes);
  return {"memory", Verdict::kNotice, "The kernel does not say how much memory is available."};
}

Finding check_descriptors() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) == 0) return judge_descriptors(limit.rlim_cur);
  return {"connections", Verdict::kNotice, "The kernel does not say how many files may be open."};
}

Finding check_clock() {
  timex state{};
  const int result = adjtimex(&state);
  return judge_clock(result >= 0 && result != TIME_ERROR && (state.status & STA_UNSYNC) == 0);
}

Finding check_disk() {
  const auto folder = hub::daemon::default_data_folder();
  if (!folder) {
    return {"disk", Verdict::kNotice, "There is no home folder in which a hub could keep its data.",
            "Name a folder: roomcast hub --data DIR"};
  }
  if (const auto usable = hub::daemon::check_folder(*folder); !usable) {
    return {"disk", Verdict::kProblem,
            "A hub cannot keep its data: " + usable.error().message + ".",
            "Name another folder: roomcast hub --data DIR"};
  }
  auto existing = *folder;
  while (!std::filesystem::exists(existing) && existing.has_relative_path())
    existing = existing.parent_path();
  std::error_code error;
  const auto space = std::filesystem::space(existing, error);
  if (error) {
    return {"disk", Verdict::kNotice,
            "The space in " + existing.string() + " is not known: " + error.message() + "."};
  }
  return judge_disk(*folder, space.available);
}

}  // namespace roomcast::doctor
