// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/web_directory.h"

#include <cstdlib>

namespace roomcast::cli {

namespace fs = std::filesystem;

std::optional<fs::path> find_web_directory(const std::string& named) {
  if (!named.empty()) return named;
  if (const char* from_environment = std::getenv("ROOMCAST_WEB"); from_environment != nullptr)
    return from_environment;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return std::nullopt;
  const fs::path beside = program.parent_path();
  for (const fs::path& candidate : {beside / "../../web", beside / "../share/roomcast/web"}) {
    if (fs::exists(candidate / "index.html", error)) return candidate.lexically_normal();
  }
  return std::nullopt;
}

}  // namespace roomcast::cli
