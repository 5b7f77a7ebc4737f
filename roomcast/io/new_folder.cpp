// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/new_folder.h"

#include <system_error>

namespace roomcast::io {

Status make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) return {};
  return Error{ErrorCode::kUnavailable,
               "cannot make the folder " + folder.string() + ": " + error.message()};
}

Status make_new_folder(const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::exists(folder, error)) return make_folder(folder);
  return Error{ErrorCode::kUnavailable,
               "there is " + folder.string() + " already; choose another folder"};
}

}  // namespace roomcast::io
