// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/mcap/output_file.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace roomcast::recording::mcap {
namespace {

constexpr mode_t kOwnerOnly = 0600;  // a recording shows a room

std::string reason(int error) {
  if (error == ENOSPC || error == EDQUOT) return "the disk is full";
  if (error == EFBIG) return "the file has reached the size limit of this user or disk";
  return std::strerror(error);
}

}  // namespace

Result<OutputFile> OutputFile::create(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kOwnerOnly);
  if (descriptor >= 0) return OutputFile(path, descriptor);
  const std::string why = errno == EEXIST
                              ? "it exists already, and nothing is overwritten; choose another name"
                              : reason(errno);
  return Error{ErrorCode::kUnavailable, "cannot make " + path.string() + ": " + why};
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_) {}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Status OutputFile::append(std::span<const std::uint8_t> piece) {
  return append(piece, {});
}

Status OutputFile::append(std::span<const std::uint8_t> first,
                          std::span<const std::uint8_t> second) {
  if (!write_all(first) || !write_all(second)) return take_back();
  size_ += first.size() + second.size();
  return {};
}

bool OutputFile::write_all(std::span<const std::uint8_t> piece) {
  while (!piece.empty()) {
    const auto written = ::write(descriptor_, piece.data(), piece.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    piece = piece.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

Error OutputFile::take_back() {
  const std::string why = reason(errno);
  const auto end = static_cast<off_t>(size_);
  const bool back =
      ::ftruncate(descriptor_, end) == 0 && ::lseek(descriptor_, end, SEEK_SET) == end;
  return {ErrorCode::kUnavailable, "cannot write to " + path_.string() + ": " + why +
                                       (back ? "" : ", and the file now ends in damaged data")};
}

}  // namespace roomcast::recording::mcap
