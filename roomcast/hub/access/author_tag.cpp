// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/access/author_tag.h"

#include <string>

#include "roomcast/hub/access/sha256.h"

namespace roomcast::hub {

std::uint64_t author_tag_of(std::string_view room, std::string_view author_key) {
  if (author_key.empty()) return 0;
  std::string text(room);
  text += '\0';  // names of rooms have no control characters
  text += author_key;
  const Sha256 digest = sha256_of(text);
  std::uint64_t tag = 0;
  for (std::size_t i = 0; i < sizeof(tag); ++i) tag = tag << 8 | digest[i];
  return tag;
}

}  // namespace roomcast::hub
