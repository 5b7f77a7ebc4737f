// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/tls/socket_bio.h"

#include <cerrno>
#include <cstdint>
#include <memory>

#include <openssl/bio.h>
#include <sys/socket.h>

namespace roomcast::net {

namespace {

int fd_of(BIO* bio) {
  return static_cast<int>(reinterpret_cast<std::intptr_t>(BIO_get_data(bio)));
}

bool may_go_on_later() {
  return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

int write_to_socket(BIO* bio, const char* data, int size) {
  BIO_clear_retry_flags(bio);
  const auto written = ::send(fd_of(bio), data, static_cast<std::size_t>(size), MSG_NOSIGNAL);
  if (written < 0 && may_go_on_later()) BIO_set_retry_write(bio);
  return static_cast<int>(written);
}

int read_from_socket(BIO* bio, char* data, int size) {
  BIO_clear_retry_flags(bio);
  const auto received = ::recv(fd_of(bio), data, static_cast<std::size_t>(size), 0);
  if (received < 0 && may_go_on_later()) BIO_set_retry_read(bio);
  if (received == 0) BIO_set_flags(bio, BIO_FLAGS_IN_EOF);
  return static_cast<int>(received);
}

long control(BIO* bio, int command, long, void*) {
  if (command == BIO_CTRL_FLUSH) return 1;
  if (command == BIO_CTRL_EOF) return BIO_test_flags(bio, BIO_FLAGS_IN_EOF) != 0;
  return 0;
}

using Method = std::unique_ptr<BIO_METHOD, decltype(&BIO_meth_free)>;

Method make_method() {
  Method method(BIO_meth_new(BIO_get_new_index() | BIO_TYPE_SOURCE_SINK, "roomcast socket"),
                &BIO_meth_free);
  if (method == nullptr) return method;
  BIO_meth_set_write(method.get(), &write_to_socket);
  BIO_meth_set_read(method.get(), &read_from_socket);
  BIO_meth_set_ctrl(method.get(), &control);
  return method;
}

}  // namespace

BIO* make_socket_bio(int fd) {
  static const Method method = make_method();
  BIO* bio = method == nullptr ? nullptr : BIO_new(method.get());
  if (bio == nullptr) return nullptr;
  BIO_set_data(bio, reinterpret_cast<void*>(static_cast<std::intptr_t>(fd)));
  BIO_set_init(bio, 1);
  return bio;
}

}  // namespace roomcast::net
