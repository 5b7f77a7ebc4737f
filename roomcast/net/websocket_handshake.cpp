// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/websocket_handshake.h"

#include <array>
#include <cstdint>
#include <new>
#include <span>

#include <boost/beast/core/string.hpp>
#include <boost/beast/http/field.hpp>
#include <boost/beast/http/rfc7230.hpp>
#include <boost/beast/http/status.hpp>
#include <boost/beast/http/verb.hpp>
#include <openssl/evp.h>

#include "roomcast/net/base64.h"
#include "roomcast/net/random_bytes.h"
#include "roomcast/net/request_framing.h"

namespace roomcast::net {

namespace beast = boost::beast;
namespace http = boost::beast::http;

namespace {

constexpr std::string_view kWebSocketGuid = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
constexpr std::string_view kVersion = "13";
constexpr std::size_t kNonceBytes = 16;
constexpr std::size_t kKeyLength = 24;  // kNonceBytes in base64

bool is_key(std::string_view key) {
  std::array<std::uint8_t, kKeyLength> decoded{};
  return key.size() == kKeyLength && key.ends_with("==") && key[kKeyLength - 3] != '=' &&
         EVP_DecodeBlock(decoded.data(), reinterpret_cast<const unsigned char*>(key.data()),
                         kKeyLength) >= 0;
}

std::string_view field(const http::fields& fields, http::field name) {
  const auto value = fields[name];
  return {value.data(), value.size()};
}

bool has_token(std::string_view list, std::string_view token) {
  return http::token_list(beast::string_view(list.data(), list.size()))
      .exists(beast::string_view(token.data(), token.size()));
}

/// Subprotocol names are case-sensitive (RFC 6455 section 4.2.2); has_token() ignores case.
bool offers(std::string_view list, std::string_view subprotocol) {
  for (const auto token : http::token_list(beast::string_view(list.data(), list.size()))) {
    if (std::string_view(token.data(), token.size()) == subprotocol) return true;
  }
  return false;
}

std::string all_of(const http::fields& fields, http::field name) {
  std::string joined;
  const auto [begin, end] = fields.equal_range(name);
  for (auto it = begin; it != end; ++it) {
    if (!joined.empty()) joined += ", ";
    joined.append(it->value().data(), it->value().size());
  }
  return joined;
}

HttpResponse upgrade_required() {
  HttpResponse response =
      text_response(426, "This address accepts only WebSocket, version 13 (RFC 6455).\n");
  response.headers = {{"Upgrade", "websocket"}, {"Sec-WebSocket-Version", std::string(kVersion)}};
  return response;
}

std::string_view without_default_port(std::string_view host, std::string_view scheme) {
  const std::string_view port = scheme == "https" ? ":443" : ":80";
  if (host.ends_with(port)) host.remove_suffix(port.size());
  return host;
}

}  // namespace

std::string accept_for(std::string_view key) {
  std::string text(key);
  text += kWebSocketGuid;
  std::array<std::uint8_t, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  const int done = EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_sha1(), nullptr);
  if (done != 1) throw std::bad_alloc();  // the digest of a short text needs only memory
  return base64(std::span(digest).first(size));
}

std::string random_key() {
  std::array<std::uint8_t, kNonceBytes> nonce{};
  fill_with_random_bytes(nonce);
  return base64(nonce);
}

bool asks_for_websocket(const RequestHeader& request) {
  return has_token(field(request, http::field::upgrade), "websocket") &&
         has_token(field(request, http::field::connection), "upgrade");
}

std::optional<HttpResponse> refuse_upgrade(const RequestHeader& request,
                                           std::string_view subprotocol,
                                           const AllowedNames& names) {
  if (request.method() != http::verb::get || request.version() < 11 ||
      !asks_for_websocket(request) ||
      field(request, http::field::sec_websocket_version) != kVersion) {
    return upgrade_required();
  }
  if (!is_key(field(request, http::field::sec_websocket_key))) {
    return text_response(400, "Sec-WebSocket-Key must be 16 bytes in base64.\n");
  }
  if (auto refusal = refuse_ambiguous(request)) return refusal;
  const auto origin = request.find(http::field::origin);
  if (origin != request.end() && !names.allows_origin(field(request, http::field::origin),
                                                      field(request, http::field::host))) {
    return text_response(403, "Pages of other sites may not connect here.\n");
  }
  if (!offers(all_of(request, http::field::sec_websocket_protocol), subprotocol)) {
    return text_response(400,
                         "The WebSocket subprotocol must be " + std::string(subprotocol) + ".\n");
  }
  return std::nullopt;
}

EmptyResponse make_upgrade(const RequestHeader& request, std::string_view subprotocol) {
  EmptyResponse response(http::status::switching_protocols, 11);
  response.set(http::field::upgrade, "websocket");
  response.set(http::field::connection, "Upgrade");
  response.set(http::field::sec_websocket_accept,
               accept_for(field(request, http::field::sec_websocket_key)));
  response.set(http::field::sec_websocket_protocol,
               beast::string_view(subprotocol.data(), subprotocol.size()));
  return response;
}

EmptyRequest make_upgrade_request(std::string_view host_and_port, std::string_view path,
                                  std::string_view key, std::string_view subprotocol) {
  const auto text = [](std::string_view view) {
    return beast::string_view(view.data(), view.size());
  };
  EmptyRequest request(http::verb::get, text(path), 11);
  request.set(http::field::host, text(host_and_port));
  request.set(http::field::upgrade, "websocket");
  request.set(http::field::connection, "Upgrade");
  request.set(http::field::sec_websocket_key, text(key));
  request.set(http::field::sec_websocket_version, text(kVersion));
  request.set(http::field::sec_websocket_protocol, text(subprotocol));
  request.set(http::field::user_agent, "roomcast");
  return request;
}

std::optional<std::string> fault_in_upgrade(const ResponseHeader& response, std::string_view key,
                                            std::string_view subprotocol) {
  const bool agrees = has_token(field(response, http::field::upgrade), "websocket") &&
                      has_token(field(response, http::field::connection), "upgrade") &&
                      field(response, http::field::sec_websocket_accept) == accept_for(key);
  if (!agrees) return "does not follow the WebSocket handshake";
  if (field(response, http::field::sec_websocket_protocol) != subprotocol) {
    return "does not speak " + std::string(subprotocol);
  }
  if (response.count(http::field::sec_websocket_extensions) != 0) {
    return "requires a WebSocket extension";
  }
  return std::nullopt;
}

bool is_same_host(std::string_view origin, std::string_view host) {
  const auto scheme_end = origin.find("://");
  if (scheme_end == std::string_view::npos || host.empty()) return false;
  const std::string_view scheme = origin.substr(0, scheme_end);
  const std::string_view origin_host = without_default_port(origin.substr(scheme_end + 3), scheme);
  const std::string_view asked_host = without_default_port(host, scheme);
  return beast::iequals(beast::string_view(origin_host.data(), origin_host.size()),
                        beast::string_view(asked_host.data(), asked_host.size()));
}

}  // namespace roomcast::net
