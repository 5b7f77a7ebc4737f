// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/file_bytes.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>

namespace roomcast::io {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

Error cannot(const char* what, const std::filesystem::path& path, int error_number) {
  return {ErrorCode::kUnavailable, std::string("cannot ") + what + " " + path.string() + ": " +
                                       std::generic_category().message(error_number)};
}

Status write_and_close(const std::filesystem::path& path, const char* mode, const void* bytes,
                       std::size_t size) {
  File file(std::fopen(path.c_str(), mode));
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
    return Error{ErrorCode::kNotFound, path.string() + " is missing"};
  }
  const auto size = std::filesystem::file_size(path, error);
  if (error) return Error{ErrorCode::kMalformed, "cannot read " + path.string()};
  if (size > limit_bytes) {
    return Error{ErrorCode::kTooLarge, path.string() + " has " + std::to_string(size) +
                                           " bytes; at most " + std::to_string(limit_bytes) +
                                           " are allowed"};
  }
  File file(std::fopen(path.c_str(), "rb"));
  bytes.resize(static_cast<std::size_t>(size));
  if (!file || std::fread(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) {
    return Error{ErrorCode::kMalformed, "cannot read " + path.string()};
  }
  return {};
}

Status write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  std::filesystem::path unfinished = path;
  unfinished += ".part";
  std::error_code error;
  if (Status status = write_and_close(unfinished, "wb", bytes.data(), bytes.size()); !status.ok()) {
    std::filesystem::remove(unfinished, error);
    return status;
  }
  std::filesystem::rename(unfinished, path, error);
  if (error) return cannot("write", path, error.value());
  return {};
}

Status write_file(const std::filesystem::path& path, std::string_view text) {
  return write_file(path,
                    std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

Status append_line(const std::filesystem::path& path, std::string_view line) {
  const std::string with_end = std::string(line) + "\n";
  return write_and_close(path, "ab", with_end.data(), with_end.size());
}

}  // namespace roomcast::io
