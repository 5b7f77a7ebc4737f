// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/file_bytes.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>

#include "roomcast/core/open_at_once.h"

namespace roomcast::io {
namespace {

Error cannot(const char* what, const std::filesystem::path& path, int error_number) {
  return {ErrorCode::kUnavailable, std::string("cannot ") + what + " " + path.string() + ": " +
                                       std::generic_category().message(error_number)};
}

Status write_and_close(const std::filesystem::path& path, const char* mode, const void* bytes,
                       std::size_t size) {
  OwnedFile file = open_file_at_once(path, mode);
  if (!file) return cannot("write", path, errno);
  if (std::fwrite(bytes, 1, size, file.get()) != size) return cannot("write", path, errno);
  if (std::fclose(file.release()) != 0) return cannot("write", path, errno);
  return {};
}

}  // namespace

Status read_file(const std::filesystem::path& path, std::size_t limit_bytes,
                 std::vector<std::uint8_t>& bytes) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    const bool is_other = std::filesystem::exists(path, error);
    return Error{ErrorCode::kNotFound, path.string() + (is_other ? " is no file" : " is missing")};
  }
  const auto size = std::filesystem::file_size(path, error);
  if (error) return Error{ErrorCode::kMalformed, "cannot read " + path.string()};
  if (size > limit_bytes) {
    return Error{ErrorCode::kTooLarge, path.string() + " has " + std::to_string(size) +
                                           " bytes; at most " + std::to_string(limit_bytes) +
                                           " are allowed"};
  }
  const OwnedFile file = open_file_at_once(path, "r");
  bytes.resize(static_cast<std::size_t>(size));
  if (!file || std::fread(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) {
    return Error{ErrorCode::kMalformed, "cannot read " + path.string()};
  }
  return {};
}

Status write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  std::error_code error;
  if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
    return write_and_close(path, "w", bytes.data(), bytes.size());
  std::filesystem::path unfinished = path;
  unfinished += ".part";
  if (Status status = write_and_close(unfinished, "w", bytes.data(), bytes.size()); !status.ok()) {
    std::filesystem::remove(unfinished, error);
    return status;
  }
  std::filesystem::rename(unfinished, path, error);
  if (!error) return {};
  const int reason = error.value();
  std::filesystem::remove(unfinished, error);
  return cannot("write", path, reason);
}

Status write_file(const std::filesystem::path& path, std::string_view text) {
  return write_file(path,
                    std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

Status append_line(const std::filesystem::path& path, std::string_view line) {
  const std::string with_end = std::string(line) + "\n";
  return write_and_close(path, "a", with_end.data(), with_end.size());
}

}  // namespace roomcast::io
