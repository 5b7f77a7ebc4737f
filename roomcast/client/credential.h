// SPDX-License-Identifier: Apache-2.0
// Credential: why a hub should let a client in. A code is good for once: the hub answers it with a
// token, which is shown from then on. Plain data.
#pragma once

#include <string>

#include "roomcast/wire/control.pb.h"

namespace roomcast {

struct Credential {
  std::string token;  // both empty: where everybody may come
  std::string code;
};

inline void show(const Credential& credential, wire::pb::Join& join) {
  join.set_token(credential.token);
  join.set_code(credential.code);
}

}  // namespace roomcast
