// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/text_file.h"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "roomcast/core/open_at_once.h"

namespace roomcast {

Result<std::string> read_text_file(const std::filesystem::path& path, std::size_t limit_bytes) {
  const auto cannot_read = [&path](int reason) {
    return Error{ErrorCode::kNotFound,
                 "cannot read " + path.string() + ": " + std::generic_category().message(reason)};
  };
  const OwnedFile file = open_file_at_once(path, "r");
  if (file == nullptr) return cannot_read(errno);
  std::string text(limit_bytes + 1, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file.get()));
  if (std::ferror(file.get()) != 0) return cannot_read(errno);
  if (text.size() <= limit_bytes) return text;
  return Error{ErrorCode::kTooLarge, path.string() + " has more than " +
                                         std::to_string(limit_bytes) +
                                         " bytes; is it the right file?"};
}

}  // namespace roomcast
