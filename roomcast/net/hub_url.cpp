// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/hub_url.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace roomcast::net {

namespace {

constexpr std::size_t kMaxHostLength = 253;
constexpr std::size_t kMaxPathLength = 1024;
constexpr std::string_view kPinPrefix = "#sha256=";

Error not_an_address(std::string_view text) {
  return {ErrorCode::kInvalidArgument,
          "'" + std::string(text) +
              "' is not a hub's address; write ws://host:port, for example ws://127.0.0.1:7600."};
}

Error not_a_pin(std::string_view text) {
  return {ErrorCode::kInvalidArgument,
          "'" + std::string(text) +
              "' does not end in a fingerprint; write wss://host:port#sha256= and the 64 digits "
              "that the hub prints when it starts."};
}

std::optional<Fingerprint> parse_pin(std::string_view fragment) {
  if (!fragment.starts_with(kPinPrefix)) return std::nullopt;
  return parse_fingerprint(fragment.substr(kPinPrefix.size()));
}

/// Removes `prefix` from the front, ignoring case.
bool take_scheme(std::string_view& text, std::string_view prefix) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  if (text.size() < prefix.size()) return false;
  if (!std::ranges::equal(text.substr(0, prefix.size()), prefix, {}, lower)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

bool is_host_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
         c == '-' || c == '_';
}

/// Labels between dots, none of them empty but a last one, and none beginning or ending with "-"
/// (RFC 1123, section 2.1; with "_", which local networks use).
bool is_host_name(std::string_view host) {
  if (host.empty() || host.size() > kMaxHostLength) return false;
  if (host.ends_with('.')) host.remove_suffix(1);
  for (;;) {
    const auto dot = std::min(host.find('.'), host.size());
    const std::string_view label = host.substr(0, dot);
    if (label.empty() || label.starts_with('-') || label.ends_with('-')) return false;
    if (!std::ranges::all_of(label, is_host_character)) return false;
    if (dot == host.size()) return true;
    host.remove_prefix(dot + 1);
  }
}

bool is_ipv6(std::string_view host) {
  return host.find(':') != std::string_view::npos && host.size() <= kMaxHostLength &&
         std::ranges::all_of(host,
                             [](char c) { return is_host_character(c) || c == ':' || c == '%'; });
}

bool is_path(std::string_view path) {
  const auto allowed = [](char c) { return c > ' ' && c < 0x7F && c != '?' && c != '#'; };
  return path.size() <= kMaxPathLength && std::ranges::all_of(path, allowed);
}

std::optional<std::uint16_t> parse_port(std::string_view digits) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), port);
  if (error != std::errc() || end != digits.data() + digits.size() || port == 0)
    return std::nullopt;
  return port;
}

struct Authority {
  std::string_view host;
  std::string_view port;  // ":7600", or empty
};

std::optional<Authority> split(std::string_view authority) {
  if (authority.starts_with('[')) {
    const auto end = authority.find(']');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view host = authority.substr(1, end - 1);
    if (!is_ipv6(host)) return std::nullopt;
    return Authority{host, authority.substr(end + 1)};
  }
  const auto colon = std::min(authority.find(':'), authority.size());
  const std::string_view host = authority.substr(0, colon);
  if (!is_host_name(host)) return std::nullopt;
  return Authority{host, authority.substr(colon)};
}

}  // namespace

Result<HubUrl> parse_hub_url(std::string_view text) {
  HubUrl url;
  std::string_view rest = text;
  url.tls = take_scheme(rest, "wss://") || take_scheme(rest, "https://");
  if (!url.tls && !take_scheme(rest, "ws://")) take_scheme(rest, "http://");
  if (const auto hash = rest.find('#'); hash != std::string_view::npos) {
    url.pinned = url.tls ? parse_pin(rest.substr(hash)) : std::nullopt;
    if (!url.pinned) return not_a_pin(text);
    rest = rest.substr(0, hash);
  }

  const auto slash = std::min(rest.find('/'), rest.size());
  const auto authority = split(rest.substr(0, slash));
  const std::string_view path = rest.substr(slash);
  if (!authority || !is_path(path)) return not_an_address(text);

  url.host = authority->host;
  if (url.tls) url.port = kDefaultTlsPort;
  if (!authority->port.empty()) {
    const auto port =
        authority->port.front() == ':' ? parse_port(authority->port.substr(1)) : std::nullopt;
    if (!port) return not_an_address(text);
    url.port = *port;
  }
  if (path.size() > 1) url.path = path;
  return url;
}

Result<std::vector<HubUrl>> parse_hub_urls(std::string_view text) {
  std::vector<HubUrl> urls;
  for (;;) {
    const auto comma = text.find(',');
    auto url = parse_hub_url(text.substr(0, comma));
    if (!url) return url.error();
    urls.push_back(*std::move(url));
    if (comma == std::string_view::npos) return urls;
    text.remove_prefix(comma + 1);
  }
}

std::string host_and_port(const HubUrl& url) {
  const bool is_v6 = url.host.find(':') != std::string::npos;
  const std::string host = is_v6 ? "[" + url.host + "]" : url.host;
  return host + ":" + std::to_string(url.port);
}

std::string to_string(const HubUrl& url) {
  const std::string plain = "://" + host_and_port(url) + url.path;
  if (!url.tls) return "ws" + plain;
  return "wss" + plain + (url.pinned ? std::string(kPinPrefix) + to_string(*url.pinned) : "");
}

}  // namespace roomcast::net
