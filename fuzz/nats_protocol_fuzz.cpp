// SPDX-License-Identifier: Apache-2.0
// Parses arbitrary bytes as the output of a NATS server. However the input is split, the events are
// the same, none uses bytes that have not arrived, and incomplete events consume nothing.
#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "roomcast/core/assert.h"
#include "roomcast/hub/federation/nats/nats_protocol.h"

namespace {

using namespace roomcast::hub::federation;
using Bytes = std::span<const std::uint8_t>;

std::string describe(const NatsEvent& event) {
  const std::string kind = std::to_string(event.index()) + " ";
  if (const auto* message = std::get_if<NatsMessage>(&event)) {
    return kind + std::string(message->subject) + " " + std::to_string(message->subscription) +
           " " + std::string(message->bytes.begin(), message->bytes.end());
  }
  if (const auto* info = std::get_if<NatsInfo>(&event)) {
    (void)read_server_info(info->json);
    return kind + std::string(info->json);
  }
  if (const auto* complaint = std::get_if<NatsServerError>(&event)) {
    return kind + std::string(complaint->text);
  }
  return kind;
}

/// The events if the input arrives in pieces of `step` bytes.
std::vector<std::string> events_of(Bytes all, std::size_t step) {
  std::vector<std::string> events;
  std::size_t taken = 0, there = 0;
  while (there < all.size()) {
    there = std::min(there + step, all.size());
    for (;;) {
      Bytes bytes = all.first(there).subspan(taken);
      const std::size_t before = bytes.size();
      const NatsEvent event = next_nats_event(bytes);
      const bool is_over = std::holds_alternative<NatsViolation>(event);
      const bool takes = !is_over && !std::holds_alternative<NatsNeedsMore>(event);
      ROOMCAST_ASSERT(takes == (bytes.size() < before));
      if (takes || is_over) events.push_back(describe(event));
      if (is_over) return events;
      if (!takes) break;
      taken += before - bytes.size();
    }
  }
  return events;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes bytes(data, size);
  const auto whole = events_of(bytes, size + 1);
  ROOMCAST_ASSERT(events_of(bytes, 1) == whole);
  ROOMCAST_ASSERT(events_of(bytes, 7) == whole);
  return 0;
}
