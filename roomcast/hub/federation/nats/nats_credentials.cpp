// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/nats/nats_credentials.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <openssl/evp.h>

#include "roomcast/core/assert.h"
#include "roomcast/core/text_file.h"

namespace roomcast::hub::federation {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::string_view kBase32 = "ABCDEFGHIJKLMNOPQRSTUVWXYZ234567";
constexpr std::string_view kBlank = " \t\r\n";
constexpr unsigned kSeedKind = 18 << 3, kUserKind = 20 << 3;  // "S" and "U" in base32
constexpr std::size_t kPrefixBytes = 2, kCheckBytes = 2, kSignatureBytes = 64;

/// The text between the BEGIN line of section `name` and the next line of dashes.
std::optional<std::string_view> section(std::string_view text, std::string_view name) {
  const auto begin = text.find("-----BEGIN " + std::string(name) + "-----");
  const auto line_end = text.find('\n', begin);  // also correct if there is no such line
  if (begin == std::string_view::npos || line_end == std::string_view::npos) return std::nullopt;
  const auto end = text.find("---", line_end);
  if (end == std::string_view::npos) return std::nullopt;
  auto inside = text.substr(line_end, end - line_end);
  inside.remove_prefix(std::min(inside.find_first_not_of(kBlank), inside.size()));
  inside = inside.substr(0, inside.find_last_not_of(kBlank) + 1);
  return inside;
}

/// Decodes base32 of RFC 4648, without padding.
std::optional<Bytes> from_base32(std::string_view text) {
  Bytes bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const auto value = kBase32.find(c);
    if (value == std::string_view::npos) return std::nullopt;
    bits = bits << 5 | static_cast<std::uint32_t>(value);
    count += 5;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> count));
  }
  if (count >= 5) return std::nullopt;  // the last character carries no data
  return bytes;
}

/// CRC-16/XMODEM.
std::uint16_t crc16(std::span<const std::uint8_t> bytes) {
  std::uint32_t crc = 0;
  for (const std::uint8_t byte : bytes) {
    crc ^= std::uint32_t{byte} << 8;
    for (int i = 0; i < 8; ++i) crc = (crc & 0x8000) != 0 ? crc << 1 ^ 0x1021 : crc << 1;
  }
  return static_cast<std::uint16_t>(crc);
}

bool is_seed_of_user(const Bytes& key, std::size_t seed_bytes) {
  if (key.size() != kPrefixBytes + seed_bytes + kCheckBytes) return false;
  const auto checked = std::span(key).first(key.size() - kCheckBytes);
  const unsigned check = key[key.size() - 2] | unsigned{key[key.size() - 1]} << 8;
  const unsigned kind = (key[0] & 7U) << 5 | key[1] >> 3;
  return (key[0] & 0xF8U) == kSeedKind && kind == kUserKind && check == crc16(checked);
}

std::string base64url(std::span<const std::uint8_t> bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), bytes.data(),
                                     static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  text.resize(std::min(text.find('='), text.size()));
  std::ranges::replace(text, '+', '-');
  std::ranges::replace(text, '/', '_');
  return text;
}

}  // namespace

Result<NatsCredentials> NatsCredentials::load(const std::string& file) {
  constexpr std::size_t kMaxFileBytes = 64 << 10;
  const auto text = read_text_file(file, kMaxFileBytes);
  if (!text) return text.error();
  auto credentials = parse(*text);
  if (!credentials) return Error{ErrorCode::kMalformed, file + " " + credentials.error().message};
  return credentials;
}

Result<NatsCredentials> NatsCredentials::parse(std::string_view text) {
  const auto jwt = section(text, "NATS USER JWT"), seed = section(text, "USER NKEY SEED");
  const auto key = seed ? from_base32(*seed) : std::nullopt;
  Seed own{};
  if (!jwt || jwt->empty() || !key || !is_seed_of_user(*key, own.size())) {
    return Error{ErrorCode::kMalformed, "holds no credentials of a NATS user, or damaged ones"};
  }
  std::copy_n(key->begin() + kPrefixBytes, own.size(), own.begin());
  return NatsCredentials(*jwt, own);
}

std::string NatsCredentials::sign(std::string_view text) const {
  const std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)> key(
      EVP_PKEY_new_raw_private_key(EVP_PKEY_ED25519, nullptr, seed_.data(), seed_.size()),
      &EVP_PKEY_free);
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(),
                                                                        &EVP_MD_CTX_free);
  std::array<std::uint8_t, kSignatureBytes> signature{};
  std::size_t size = signature.size();
  const bool is_signed =
      EVP_DigestSignInit(context.get(), nullptr, nullptr, nullptr, key.get()) == 1 &&
      EVP_DigestSign(context.get(), signature.data(), &size,
                     reinterpret_cast<const unsigned char*>(text.data()), text.size()) == 1;
  ROOMCAST_ASSERT(is_signed);
  return base64url(signature);
}

}  // namespace roomcast::hub::federation
