// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/tls/certificate.h"

#include <array>
#include <string_view>
#include <utility>

#include <boost/asio/ip/address.hpp>
#include <fcntl.h>
#include <openssl/bio.h>
#include <openssl/ec.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/x509.h>
#include <openssl/x509v3.h>
#include <unistd.h>

#include "roomcast/core/assert.h"
#include "roomcast/net/tls/pem_file.h"

namespace roomcast::net {

namespace {

using SharedX509 = std::shared_ptr<X509>;
using SharedKey = std::shared_ptr<EVP_PKEY>;

constexpr long kValidSeconds = 10L * 365 * 24 * 3600;
constexpr long kClockMaySlowSeconds = 24L * 3600;  // a client's clock may be a day behind
constexpr int kSerialBytes = 16;

/// "DNS:hub.local,IP:192.168.1.5"
std::string alternative_names(const std::vector<std::string>& hosts) {
  std::string names;
  for (const std::string& host : hosts) {
    boost::system::error_code not_numeric;
    const auto address = boost::asio::ip::make_address(host, not_numeric);
    if (!names.empty()) names += ',';
    names += not_numeric ? "DNS:" + host : "IP:" + address.to_string();
  }
  return names;
}

bool add_extension(X509* certificate, int nid, const std::string& value) {
  const std::unique_ptr<X509_EXTENSION, decltype(&X509_EXTENSION_free)> extension(
      X509V3_EXT_conf_nid(nullptr, nullptr, nid, value.c_str()), &X509_EXTENSION_free);
  return extension != nullptr && X509_add_ext(certificate, extension.get(), -1) == 1;
}

bool set_random_serial(X509* certificate) {
  std::array<unsigned char, kSerialBytes> bytes{};
  if (RAND_bytes(bytes.data(), kSerialBytes) != 1) return false;
  bytes[0] &= 0x7F;  // makes the number positive
  const std::unique_ptr<BIGNUM, decltype(&BN_free)> number(
      BN_bin2bn(bytes.data(), kSerialBytes, nullptr), &BN_free);
  return number != nullptr &&
         BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(certificate)) != nullptr;
}

bool fill_in(X509* certificate, EVP_PKEY* key, const std::vector<std::string>& hosts) {
  X509_NAME* name = X509_get_subject_name(certificate);
  const auto* common = reinterpret_cast<const unsigned char*>("roomcast hub");
  return X509_set_version(certificate, X509_VERSION_3) == 1 && set_random_serial(certificate) &&
         X509_gmtime_adj(X509_getm_notBefore(certificate), -kClockMaySlowSeconds) != nullptr &&
         X509_gmtime_adj(X509_getm_notAfter(certificate), kValidSeconds) != nullptr &&
         X509_NAME_add_entry_by_txt(name, "CN", MBSTRING_UTF8, common, -1, -1, 0) == 1 &&
         X509_set_issuer_name(certificate, name) == 1 && X509_set_pubkey(certificate, key) == 1 &&
         add_extension(certificate, NID_basic_constraints, "critical,CA:FALSE") &&
         add_extension(certificate, NID_ext_key_usage, "serverAuth") &&
         add_extension(certificate, NID_subject_alt_name, alternative_names(hosts)) &&
         X509_sign(certificate, key, EVP_sha256()) != 0;
}

}  // namespace

Result<Certificate> Certificate::load(const std::filesystem::path& certificate,
                                      const std::filesystem::path& key) {
  auto chain = read_certificates(certificate);
  if (!chain) return chain.error();
  auto private_key = read_private_key(key);
  if (!private_key) return private_key.error();
  if (X509_check_private_key(chain->front().get(), private_key->get()) != 1) {
    ERR_clear_error();
    return Error{ErrorCode::kMalformed, "the key in '" + key.string() +
                                            "' does not belong to the certificate in '" +
                                            certificate.string() + "'"};
  }
  return Certificate(*std::move(chain), *std::move(private_key));
}

Result<Certificate> Certificate::make_self_signed(const std::vector<std::string>& hosts) {
  ROOMCAST_ASSERT(!hosts.empty());
  SharedKey key(EVP_EC_gen("P-256"), &EVP_PKEY_free);
  SharedX509 certificate(X509_new(), &X509_free);
  if (key == nullptr || certificate == nullptr || !fill_in(certificate.get(), key.get(), hosts)) {
    ERR_clear_error();
    return Error{ErrorCode::kInvalidArgument,
                 "no certificate can be made for " + alternative_names(hosts)};
  }
  return Certificate({std::move(certificate)}, std::move(key));
}

Status Certificate::save(const std::filesystem::path& file) const {
  const Error cannot{ErrorCode::kUnavailable, "cannot write '" + file.string() + "'"};
  const int fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (fd < 0) return cannot;
  const std::unique_ptr<BIO, decltype(&BIO_free)> bio(BIO_new_fd(fd, BIO_CLOSE), &BIO_free);
  bool written = ::fchmod(fd, 0600) == 0;
  written = written &&
            PEM_write_bio_PrivateKey(bio.get(), key(), nullptr, nullptr, 0, nullptr, nullptr) == 1;
  for (const auto& link : chain_) written = written && PEM_write_bio_X509(bio.get(), link.get());
  if (written && ::fsync(fd) == 0) return {};
  ERR_clear_error();
  return cannot;
}

Fingerprint Certificate::fingerprint() const {
  return fingerprint_of(leaf());
}

Fingerprint fingerprint_of(const X509* certificate) {
  Fingerprint fingerprint{};
  unsigned size = 0;
  const int done = X509_digest(certificate, EVP_sha256(), fingerprint.data(), &size);
  ROOMCAST_ASSERT(done == 1 && size == fingerprint.size());
  return fingerprint;
}

}  // namespace roomcast::net
