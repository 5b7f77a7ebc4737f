// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/openni2/oni_reader_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "roomcast/core/child_program.h"

namespace roomcast::source {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReaderName = "roomcast-oni-reader";

/// In the build tree and in an archive it is beside the programs, in a package below lib.
std::optional<fs::path> find_oni_reader() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return std::nullopt;
  const fs::path beside = program.parent_path();
  for (const fs::path& place : {beside / kReaderName, beside / "../lib/roomcast" / kReaderName}) {
    if (fs::exists(place, error)) return place.lexically_normal();
  }
  return std::nullopt;
}

Error reader_failed(const std::string& why) {
  return {ErrorCode::kUnavailable, std::string(kReaderName) + ", which reads .oni files, " + why};
}

}  // namespace

Result<OniReaderProcess> OniReaderProcess::start(const std::string& file, bool loop) {
  const auto program = find_oni_reader();
  if (!program) return reader_failed("is not installed with this program");
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return reader_failed("cannot be given a pipe");
  // What OpenNI or the C library print about a damaged file is not shown.
  const auto pid =
      start_program({program->string(), file, loop ? "loop" : "once"}, {.output = ends[1]});
  ::close(ends[1]);
  if (pid) return OniReaderProcess(*pid, ends[0], file);
  ::close(ends[0]);
  return reader_failed("does not start: " + pid.error().message);
}

OniReaderProcess::OniReaderProcess(OniReaderProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, 0)),
      pipe_(std::exchange(other.pipe_, -1)),
      file_(std::move(other.file_)) {}

OniReaderProcess::~OniReaderProcess() {
  if (pid_ == 0) return;
  ::close(pipe_);
  (void)::kill(pid_, SIGKILL);
  wait_for_program(pid_);
}

bool OniReaderProcess::has_bytes(std::chrono::milliseconds patience) const {
  pollfd end{.fd = pipe_, .events = POLLIN, .revents = 0};
  return ::poll(&end, 1, static_cast<int>(patience.count())) > 0;
}

Status OniReaderProcess::read(void* to, std::size_t size, std::chrono::milliseconds within) {
  auto* next = static_cast<char*>(to);
  while (size > 0) {
    if (!has_bytes(within)) return damaged("sends nothing more");
    if (Status status = read_some(next, size); !status) return status;
  }
  return {};
}

Status OniReaderProcess::read_some(char*& to, std::size_t& size) {
  const ssize_t count = ::read(pipe_, to, size);
  if (count < 0 && errno == EINTR) return {};
  if (count <= 0) return damaged("broke off");
  to += count;
  size -= static_cast<std::size_t>(count);
  return {};
}

Error OniReaderProcess::damaged(const std::string& how) const {
  return {ErrorCode::kMalformed, "the file " + file_ + " is damaged: OpenNI, reading it, " + how};
}

}  // namespace roomcast::source
