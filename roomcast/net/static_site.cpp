// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/static_site.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <memory>
#include <span>
#include <system_error>
#include <utility>

#include "roomcast/core/crc32.h"

namespace roomcast::net {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kIndex = "index.html";
constexpr std::string_view kCompressed = ".gz";

/// Vite puts the content hash into the names of files in this folder, so such a file never changes.
constexpr std::string_view kHashedNames = "/assets/";

Result<std::string> read_file(const fs::path& path, std::size_t max_bytes) {
  std::error_code error;
  const auto size = fs::file_size(path, error);
  if (!error && size > max_bytes) {
    return Error{ErrorCode::kTooLarge, "The page's files are larger than " +
                                           std::to_string(StaticSite::kMaxBytes >> 20) + " MiB."};
  }
  if (!error) {  // a regular file: others have no size
    std::ifstream file(path, std::ios::binary);
    std::string content(static_cast<std::size_t>(size), '\0');
    if (file.read(content.data(), static_cast<std::streamsize>(content.size()))) return content;
  }
  return Error{ErrorCode::kNotFound, "The page's file " + path.string() + " cannot be read."};
}

std::string etag_of(const std::string& content) {
  const std::uint32_t crc = crc32(std::as_bytes(std::span(content)));
  std::array<char, 32> text{};
  const int length = std::snprintf(text.data(), text.size(), "\"%08x-%zx\"", crc, content.size());
  return {text.data(), static_cast<std::size_t>(length)};
}

HttpResponse file_response(std::string_view path, std::string content) {
  HttpResponse response;
  response.content_type = content_type_of(path);
  response.etag = etag_of(content);
  if (path.starts_with(kHashedNames)) {
    response.cache_control = "public, max-age=31536000, immutable";
  }
  response.body = std::make_shared<const std::string>(std::move(content));
  return response;
}

bool is_hidden(const fs::path& path) {
  return path.filename().string().starts_with('.');
}

}  // namespace

Result<StaticSite> StaticSite::load(const fs::path& directory) {
  std::error_code error;
  fs::recursive_directory_iterator entry(directory, error);
  if (error) {
    return Error{ErrorCode::kNotFound, "The page's folder " + directory.string() +
                                           " cannot be read: " + error.message() + "."};
  }
  StaticSite site;
  std::size_t bytes = 0;
  for (; entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (is_hidden(entry->path())) {
      entry.disable_recursion_pending();
      continue;
    }
    if (entry->is_symlink(error) || !entry->is_regular_file(error)) continue;
    if (site.files_.size() == kMaxFiles) {
      return Error{ErrorCode::kTooLarge, "The page's folder " + directory.string() +
                                             " has more than " + std::to_string(kMaxFiles) +
                                             " files."};
    }
    auto content = read_file(entry->path(), kMaxBytes - bytes);
    if (!content) return std::move(content).error();
    bytes += content->size();
    std::string path = "/" + entry->path().lexically_relative(directory).generic_string();
    auto response = file_response(path, *std::move(content));
    site.files_.emplace(std::move(path), std::move(response));
  }
  site.join_compressed();
  if (!site.find("/")) {
    return Error{ErrorCode::kNotFound, "There is no index.html in " + directory.string() +
                                           "; build the page with scripts/build first."};
  }
  return site;
}

void StaticSite::join_compressed() {
  for (auto file = files_.begin(); file != files_.end();) {
    const std::string& path = file->first;
    const auto plain = path.ends_with(kCompressed)
                           ? files_.find(path.substr(0, path.size() - kCompressed.size()))
                           : files_.end();
    if (plain == files_.end()) {
      ++file;
      continue;
    }
    plain->second.gzip = file->second.body;
    file = files_.erase(file);
  }
}

std::optional<HttpResponse> StaticSite::find(std::string_view path) const {
  const auto file =
      path.ends_with('/') ? files_.find(std::string(path).append(kIndex)) : files_.find(path);
  if (file == files_.end()) return std::nullopt;
  return file->second;
}

std::string_view content_type_of(std::string_view file_name) {
  struct Ending {
    std::string_view ending;
    std::string_view type;
  };
  static constexpr std::array kTypes = {
      Ending{".html", "text/html; charset=utf-8"},
      Ending{".js", "text/javascript; charset=utf-8"},
      Ending{".mjs", "text/javascript; charset=utf-8"},
      Ending{".css", "text/css; charset=utf-8"},
      Ending{".wasm", "application/wasm"},
      Ending{".json", "application/json"},
      Ending{".map", "application/json"},
      Ending{".webmanifest", "application/manifest+json"},
      Ending{".svg", "image/svg+xml"},
      Ending{".png", "image/png"},
      Ending{".jpg", "image/jpeg"},
      Ending{".ico", "image/x-icon"},
      Ending{".woff2", "font/woff2"},
      Ending{".txt", "text/plain; charset=utf-8"},
  };
  for (const auto& [ending, type] : kTypes) {
    if (file_name.ends_with(ending)) return type;
  }
  return "application/octet-stream";
}

}  // namespace roomcast::net
