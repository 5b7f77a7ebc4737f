// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/access/author_tag.h"

#include <array>
#include <string>

#include <openssl/evp.h>

#include "roomcast/core/assert.h"

namespace roomcast::hub {

std::uint64_t author_tag_of(std::string_view room, std::string_view author_key) {
  if (author_key.empty()) return 0;
  std::string text(room);
  text += '\0';  // names of rooms have no control characters
  text += author_key;
  std::array<std::uint8_t, 32> digest{};
  unsigned int size = 0;
  const int done =
      EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_sha256(), nullptr);
  ROOMCAST_ASSERT(done == 1 && size == digest.size());
  std::uint64_t tag = 0;
  for (std::size_t i = 0; i < sizeof(tag); ++i) tag = tag << 8 | digest[i];
  return tag;
}

}  // namespace roomcast::hub
