// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/tls/pem_file.h"

#include <string>

#include <openssl/bio.h>
#include <openssl/err.h>
#include <openssl/pem.h>

#include "roomcast/core/assert.h"
#include "roomcast/core/text_file.h"

namespace roomcast::net {
namespace {

using Bio = std::unique_ptr<BIO, decltype(&BIO_free)>;

constexpr std::size_t kMaxPemBytes = 1 << 20;

Result<Bio> open_pem(const std::filesystem::path& file) {
  const auto text = read_text_file(file, kMaxPemBytes);
  if (!text) return text.error();
  Bio bio(BIO_new(BIO_s_mem()), &BIO_free);
  ROOMCAST_ASSERT(bio != nullptr);
  BIO_set_mem_eof_return(bio.get(), 0);
  if (!text->empty()) BIO_write(bio.get(), text->data(), static_cast<int>(text->size()));
  return bio;
}

/// Replaces OpenSSL's callback, which would prompt on the terminal.
int no_passphrase(char*, int, int, void*) {
  return -1;
}

}  // namespace

Result<std::vector<std::shared_ptr<X509>>> read_certificates(const std::filesystem::path& file) {
  const auto pem = open_pem(file);
  if (!pem) return pem.error();
  std::vector<std::shared_ptr<X509>> certificates;
  while (X509* next = PEM_read_bio_X509(pem->get(), nullptr, &no_passphrase, nullptr)) {
    certificates.emplace_back(next, &X509_free);
  }
  ERR_clear_error();  // OpenSSL reports the end of the file as an error
  if (!certificates.empty()) return certificates;
  return Error{ErrorCode::kMalformed, "'" + file.string() + "' has no certificate in PEM form"};
}

Result<std::shared_ptr<EVP_PKEY>> read_private_key(const std::filesystem::path& file) {
  const auto pem = open_pem(file);
  if (!pem) return pem.error();
  std::shared_ptr<EVP_PKEY> key(
      PEM_read_bio_PrivateKey(pem->get(), nullptr, &no_passphrase, nullptr), &EVP_PKEY_free);
  ERR_clear_error();
  if (key != nullptr) return key;
  return Error{ErrorCode::kMalformed,
               "'" + file.string() + "' has no private key in PEM form without a passphrase"};
}

}  // namespace roomcast::net
