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

/// What is newer than `version` (0: all). Nothing: there is nothing newer, or no model. Errors of
/// net::fetch and model::decode_model; kNotAllowed or kNotFound with the hub's sentence.
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
  /// What has come since the last call, in order.
  [[nodiscard]] std::vector<model::DecodedModel> take();

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace roomcast::client
