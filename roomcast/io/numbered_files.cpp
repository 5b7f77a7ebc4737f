// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/numbered_files.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

namespace roomcast::io {
namespace {

constexpr int kMaxFiles = 9999;

bool is_plain(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || letter == '-';
}

}  // namespace

std::string file_stem(const std::string& room) {
  std::string name = room;
  std::ranges::replace_if(
      name, [](char letter) { return !is_plain(letter); }, '-');
  return name.empty() ? "roomcast" : "roomcast-" + name;
}

Result<std::filesystem::path> next_free_path(const std::filesystem::path& folder,
                                             const std::string& stem, const std::string& suffix) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return Error{ErrorCode::kUnavailable,
                 "the folder " + folder.string() + " cannot be made: " + error.message()};
  }
  for (int number = 1; number <= kMaxFiles; ++number) {
    const auto path = folder / fmt::format("{}-{:04}{}", stem, number, suffix);
    if (!std::filesystem::exists(path, error)) return path;
  }
  return Error{ErrorCode::kUnavailable,
               "the folder " + folder.string() + " has no free file number; choose another one"};
}

}  // namespace roomcast::io
