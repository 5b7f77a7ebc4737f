// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/credential.h"

#include <fstream>

namespace roomcast::client {

Result<Credential> read_credential_file(const std::string& file) {
  std::ifstream stream(file);
  std::string token;
  if (!(stream >> token)) {
    return Error{ErrorCode::kNotFound, "no token is in \"" + file + "\""};
  }
  return credential_of(std::move(token));
}

}  // namespace roomcast::client
