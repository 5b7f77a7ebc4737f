// SPDX-License-Identifier: Apache-2.0
// RoomModels: the hub's view of the models that are kept of its rooms. Threading: called on the
// rooms' thread; no member may block.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace roomcast::hub {

class RoomModels {
 public:
  virtual ~RoomModels() = default;
  /// docs/spec/model.md, for a viewer who has the model of version `known` (0: none). Null: there
  /// is nothing newer.
  [[nodiscard]] virtual std::shared_ptr<const std::string> changes_after(
      const std::string& room, std::uint64_t known) const = 0;
};

}  // namespace roomcast::hub
