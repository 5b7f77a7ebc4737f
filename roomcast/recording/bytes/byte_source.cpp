// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/bytes/byte_source.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "roomcast/core/open_at_once.h"

namespace roomcast::recording {
namespace {

const Error kTooShort = {ErrorCode::kMalformed, "it ends too early"};

class FileSource final : public ByteSource {
 public:
  FileSource(int descriptor, std::uint64_t size) : descriptor_(descriptor), size_(size) {}
  FileSource(const FileSource&) = delete;
  FileSource& operator=(const FileSource&) = delete;
  ~FileSource() override { ::close(descriptor_); }

  std::uint64_t size() const override { return size_; }
  Status read(std::uint64_t offset, std::span<std::uint8_t> out) const override {
    if (offset > size_ || out.size() > size_ - offset) return kTooShort;
    while (!out.empty()) {
      const auto got = ::pread(descriptor_, out.data(), out.size(), static_cast<off_t>(offset));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0)
        return Error{ErrorCode::kMalformed, std::string("reading failed: ") + std::strerror(errno)};
      if (got == 0) return kTooShort;
      offset += static_cast<std::uint64_t>(got);
      out = out.subspan(static_cast<std::size_t>(got));
    }
    return {};
  }

 private:
  int descriptor_;
  std::uint64_t size_;
};

class MemorySource final : public ByteSource {
 public:
  explicit MemorySource(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {}
  std::uint64_t size() const override { return bytes_.size(); }
  Status read(std::uint64_t offset, std::span<std::uint8_t> out) const override {
    if (offset > bytes_.size() || out.size() > bytes_.size() - offset) return kTooShort;
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(offset), out.size(), out.begin());
    return {};
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

Result<std::unique_ptr<ByteSource>> open_file(const std::filesystem::path& path) {
  const int descriptor = open_at_once(path, O_RDONLY);
  if (descriptor < 0) {
    return Error{ErrorCode::kNotFound,
                 "cannot open " + path.string() + ": " + std::strerror(errno)};
  }
  struct stat about {};
  if (::fstat(descriptor, &about) != 0 || !S_ISREG(about.st_mode)) {
    ::close(descriptor);
    return Error{ErrorCode::kNotFound, path.string() + " is not a file"};
  }
  return std::unique_ptr<ByteSource>(
      new FileSource(descriptor, static_cast<std::uint64_t>(about.st_size)));
}

std::unique_ptr<ByteSource> bytes_in_memory(std::vector<std::uint8_t> bytes) {
  return std::make_unique<MemorySource>(std::move(bytes));
}

}  // namespace roomcast::recording
