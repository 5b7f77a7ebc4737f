// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/nats/nats_protocol.h"

#include <algorithm>
#include <array>
#include <charconv>

#include <nlohmann/json.hpp>

namespace roomcast::hub::federation {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kBlank = " \t";

/// The first line without its end. Nothing: it is incomplete or too long.
std::optional<std::string_view> first_line(std::span<const std::uint8_t> bytes) {
  const auto text = std::string_view(reinterpret_cast<const char*>(bytes.data()),
                                     std::min(bytes.size(), kMaxNatsLineBytes));
  const auto end = text.find(kNatsLineEnd);
  if (end == std::string_view::npos) return std::nullopt;
  return text.substr(0, end);
}

/// Removes the first word and surrounding blanks from `text`.
std::string_view take_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
  const auto word = text.substr(0, text.find_first_of(kBlank));
  text.remove_prefix(word.size());
  text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
  return word;
}

bool is_verb(std::string_view word, std::string_view verb) {
  const auto upper = [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; };
  return std::ranges::equal(word, verb, {}, upper);
}

template <class Number>
bool read_number(std::string_view word, Number& number) {
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
  return fault == std::errc() && end == word.data() + word.size() && !word.empty();
}

/// `text`: the line after "MSG": "subject subscription [reply-to] size". The message follows it.
NatsEvent read_message(std::string_view text, std::span<const std::uint8_t>& bytes,
                       std::size_t line_bytes) {
  NatsMessage message;
  message.subject = take_word(text);
  const auto subscription = take_word(text);
  auto size = take_word(text);
  if (!text.empty()) size = take_word(text);  // the previous word was the reply-to subject
  std::size_t message_bytes = 0;
  if (message.subject.empty() || !text.empty() || !read_number(size, message_bytes) ||
      !read_number(subscription, message.subscription) || message_bytes > kMaxNatsMessageBytes) {
    return NatsViolation{};
  }
  const auto rest = bytes.subspan(line_bytes);
  if (rest.size() < message_bytes + kNatsLineEnd.size()) return NatsNeedsMore{};
  message.bytes = rest.first(message_bytes);
  const auto behind = rest.subspan(message_bytes);
  if (behind[0] != '\r' || behind[1] != '\n') return NatsViolation{};
  bytes = behind.subspan(kNatsLineEnd.size());
  return message;
}

/// "'Authorization Violation'"
std::string_view without_quotes(std::string_view text) {
  if (text.size() < 2 || !text.starts_with('\'') || !text.ends_with('\'')) return text;
  return text.substr(1, text.size() - 2);
}

/// Parses a line that is not followed by a message.
NatsEvent read_line(std::string_view verb, std::string_view rest) {
  if (is_verb(verb, "PING")) return NatsPing{};
  if (is_verb(verb, "PONG")) return NatsPong{};
  if (is_verb(verb, "+OK")) return NatsOk{};
  if (is_verb(verb, "INFO")) return NatsInfo{rest};
  if (is_verb(verb, "-ERR")) return NatsServerError{without_quotes(rest)};
  return NatsViolation{};
}

}  // namespace

NatsEvent next_nats_event(std::span<const std::uint8_t>& bytes) {
  const auto line = first_line(bytes);
  if (!line && bytes.size() >= kMaxNatsLineBytes) return NatsViolation{};
  if (!line) return NatsNeedsMore{};
  const std::size_t line_bytes = line->size() + kNatsLineEnd.size();
  std::string_view rest = *line;
  const std::string_view verb = take_word(rest);
  if (is_verb(verb, "MSG")) return read_message(rest, bytes, line_bytes);
  NatsEvent event = read_line(verb, rest);
  if (!std::holds_alternative<NatsViolation>(event)) bytes = bytes.subspan(line_bytes);
  return event;
}

std::optional<NatsServerInfo> read_server_info(std::string_view json) {
  const Json object = Json::parse(json, nullptr, false);
  if (!object.is_object()) return std::nullopt;
  const auto flag = [&](const char* name) {
    const auto found = object.find(name);
    return found != object.end() && found->is_boolean() && found->get<bool>();
  };
  NatsServerInfo info;
  const auto max = object.find("max_payload");
  if (max != object.end() && max->is_number_unsigned()) {
    info.max_message_bytes = std::min(max->get<std::size_t>(), kMaxNatsMessageBytes);
  }
  const auto nonce = object.find("nonce");
  if (nonce != object.end() && nonce->is_string()) info.nonce = nonce->get<std::string>();
  info.demands_tls = flag("tls_required");
  info.offers_tls = info.demands_tls || flag("tls_available");
  return info;
}

std::string connect_line(const NatsIdentity& identity, bool uses_tls) {
  Json object = {{"verbose", false},       {"pedantic", false}, {"echo", false},
                 {"headers", false},       {"protocol", 1},     {"lang", "C++"},
                 {"name", "roomcast hub"}, {"version", "1"},    {"tls_required", uses_tls}};
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) object[name] = value;
  };
  add("user", identity.user);
  add("pass", identity.password);
  add("auth_token", identity.token);
  add("jwt", identity.user_jwt);
  add("sig", identity.signature);
  return "CONNECT " + object.dump(-1, ' ', false, Json::error_handler_t::replace) + "\r\n";
}

std::string publish_line(std::string_view subject, std::size_t message_bytes) {
  std::string line("PUB ");
  line += subject;
  line += ' ';
  line += std::to_string(message_bytes);
  line += kNatsLineEnd;
  return line;
}

std::string subscribe_line(std::string_view subject, std::uint64_t number) {
  return "SUB " + std::string(subject) + " " + std::to_string(number) + "\r\n";
}

std::string unsubscribe_line(std::uint64_t number) {
  return "UNSUB " + std::to_string(number) + "\r\n";
}

}  // namespace roomcast::hub::federation
