// SPDX-License-Identifier: Apache-2.0
// The model of what stands still in a room, as the hub gives it over HTTP (docs/spec/model.md).
// ModelFollower keeps up with it: asks again every few seconds, and again after failures.
// Threading: ModelFollower has its own thread, which also decodes; thread-safe.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/model/pieces/decoded_model.h"

namespace roomcast::client {

struct ModelSource {
  std::string hub_url;     // of several hubs the first that answers
  std::string token = {};  // that of the viewer; empty: for rooms that are open to all
};

/// Fetches the pieces that are newer than `version` (0: all). Nothing: the hub has nothing newer,
/// or no model. Errors of net::fetch and model::decode_model; kNotFound for an unknown room,
/// kUnavailable for any other refusal.
[[nodiscard]] Result<std::optional<model::DecodedModel>> fetch_model(const ModelSource& source,
                                                                     const std::string& room,
                                                                     std::uint64_t version,
                                                                     const std::stop_token& stop);

class ModelFollower {
 public:
  explicit ModelFollower(ModelSource source);
  ~ModelFollower();

  /// Begins with this room, once it is known; later calls have no effect.
  void follow(const std::string& room);
  /// Returns the answers that came since the last call, in order.
  [[nodiscard]] std::vector<model::DecodedModel> take();

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace roomcast::client
