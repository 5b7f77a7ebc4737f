// SPDX-License-Identifier: Apache-2.0
#include "roomcast/foxglove/protocol.h"

#include <limits>
#include <optional>

#include <nlohmann/json.hpp>

#include "roomcast/core/little_endian.h"
#include "roomcast/net/base64.h"

namespace roomcast::foxglove {
namespace {

using nlohmann::json;
using recording::FoxgloveKind;

constexpr std::uint8_t kMessageData = 0x01;

/// Text that comes from elsewhere, such as names of sensors, may be no UTF-8.
std::string text_of(const json& message) {
  return message.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::optional<std::uint32_t> id_of(const json& value) {
  if (!value.is_number_unsigned()) return std::nullopt;
  const auto number = value.get<std::uint64_t>();
  if (number > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return static_cast<std::uint32_t>(number);
}

Error malformed(const std::string& sentence) {
  return {ErrorCode::kMalformed, sentence};
}

/// The array `name` of a message, if it is one of bearable length.
const json* list_of(const json& message, const char* name) {
  const auto found = message.find(name);
  if (found == message.end() || !found->is_array() || found->size() > kMaxIdsPerRequest)
    return nullptr;
  return &*found;
}

Result<Request> parse_subscribe(const json& message) {
  const json* const list = list_of(message, "subscriptions");
  if (list == nullptr)
    return malformed("subscribe needs an array `subscriptions` of at most 1024 elements.");
  Request request;
  for (const json& entry : *list) {
    if (!entry.is_object() || !entry.contains("id") || !entry.contains("channelId"))
      return malformed("A subscription is an object with `id` and `channelId`.");
    const auto id = id_of(entry["id"]), channel = id_of(entry["channelId"]);
    if (!id || !channel) return malformed("IDs are numbers from 0 to 4294967295.");
    request.subscribe.push_back({*id, ChannelId{*channel}});
  }
  return request;
}

Result<Request> parse_unsubscribe(const json& message) {
  const json* const list = list_of(message, "subscriptionIds");
  if (list == nullptr)
    return malformed("unsubscribe needs an array `subscriptionIds` of at most 1024 elements.");
  Request request;
  for (const json& entry : *list) {
    const auto id = id_of(entry);
    if (!id) return malformed("IDs are numbers from 0 to 4294967295.");
    request.unsubscribe.push_back(*id);
  }
  return request;
}

}  // namespace

std::string server_info(std::string_view name, std::string_view session) {
  return text_of({{"op", "serverInfo"},
                  {"name", name},
                  {"capabilities", json::array()},
                  {"metadata", json::object()},
                  {"sessionId", session}});
}

std::string advertise(std::span<const Channel> channels) {
  json list = json::array();
  for (const Channel& channel : channels) {
    const recording::FoxgloveSchema schema = foxglove_schema(channel.kind);
    list.push_back({{"id", channel.id.value},
                    {"topic", channel.topic},
                    {"encoding", "protobuf"},
                    {"schemaName", schema.name},
                    {"schema", net::base64(bytes_of(schema.files))},
                    {"schemaEncoding", "protobuf"}});
  }
  return text_of({{"op", "advertise"}, {"channels", std::move(list)}});
}

std::string unadvertise(std::span<const ChannelId> channels) {
  json list = json::array();
  for (const ChannelId channel : channels) list.push_back(channel.value);
  return text_of({{"op", "unadvertise"}, {"channelIds", std::move(list)}});
}

std::string status(Level level, std::string_view sentence) {
  return text_of({{"op", "status"}, {"level", static_cast<int>(level)}, {"message", sentence}});
}

Result<Request> parse_request(std::string_view text) {
  const json message = json::parse(text, nullptr, false);
  const auto op = message.is_object() ? message.find("op") : message.end();
  if (!message.is_object() || op == message.end() || !op->is_string())
    return malformed("Text messages are JSON objects with a string `op`.");
  const auto& name = op->get_ref<const std::string&>();
  if (name == "subscribe") return parse_subscribe(message);
  if (name == "unsubscribe") return parse_unsubscribe(message);
  return Error{ErrorCode::kUnsupported,
               "This server only sends: it offers subscribe and unsubscribe."};
}

std::array<std::uint8_t, 13> data_header(std::uint32_t subscription, nanoseconds time) {
  std::array<std::uint8_t, 13> header{kMessageData};
  write_u32(&header[1], subscription);
  write_u64(&header[5], static_cast<std::uint64_t>(time.count()));
  return header;
}

}  // namespace roomcast::foxglove
