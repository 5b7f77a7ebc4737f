// SPDX-License-Identifier: Apache-2.0
// StaticSite: the files of a folder, read once into memory and served from there. A request is a
// look-up in a map, so no path can leave the folder. Threading: immutable after load.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "roomcast/core/result.h"
#include "roomcast/net/http_response.h"

namespace roomcast::net {

class StaticSite {
 public:
  static constexpr std::size_t kMaxBytes = std::size_t{64} << 20;  // all files together
  static constexpr std::size_t kMaxFiles = 2000;

  /// Reads `directory` and its subfolders. Symbolic links and names that start with a dot are left
  /// out. FILE.gz next to FILE is its compressed version, for clients that accept gzip. Errors:
  /// kNotFound (no such folder, no index.html in it, unreadable file), kTooLarge.
  static Result<StaticSite> load(const std::filesystem::path& directory);

  /// The file at `path` ("/assets/main-8d1f.js"); "/" and "/folder/" give their index.html.
  [[nodiscard]] std::optional<HttpResponse> find(std::string_view path) const;

  [[nodiscard]] std::size_t file_count() const { return files_.size(); }

 private:
  void join_compressed();

  std::map<std::string, HttpResponse, std::less<>> files_;  // by path, "/" first
};

/// By the extension of the name; "application/octet-stream" if unknown.
[[nodiscard]] std::string_view content_type_of(std::string_view file_name);

}  // namespace roomcast::net
