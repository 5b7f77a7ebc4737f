// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/tls/tls_session.h"

#include <array>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <openssl/ssl.h>
#include <sys/socket.h>
#include <unistd.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/net/tls/tls_fixture.h"

namespace roomcast::net {
namespace {

using HandshakeOutcome = TlsSession::Outcome;

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Both ends of one non-blocking connection.
class TlsSessionTest : public ::testing::Test {
 protected:
  TlsSessionTest() {
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, fds_.data()), 0);
  }
  ~TlsSessionTest() override {
    for (const int fd : fds_) {
      if (fd >= 0) ::close(fd);
    }
  }

  TlsSession server() {
    auto session = TlsSession::accept(fds_[0], *server_context_);
    EXPECT_TRUE(session.ok());
    return *std::move(session);
  }
  TlsSession client(TlsTrust trust) {
    const auto context = TlsClientContext::create();
    EXPECT_TRUE(context.ok());
    auto session = TlsSession::connect(fds_[1], **context, std::move(trust));
    EXPECT_TRUE(session.ok());
    return *std::move(session);
  }
  TlsTrust pinned() const { return {"anything", certificate_.fingerprint()}; }

  /// Runs both until neither waits; returns the client's outcome.
  static HandshakeOutcome shake_hands(TlsSession& server, TlsSession& client) {
    HandshakeOutcome outcome = HandshakeOutcome::kWaitsToRead;
    for (int turn = 0; turn < 10 && outcome == HandshakeOutcome::kWaitsToRead; ++turn) {
      outcome = client.handshake().outcome;
      server.handshake();
    }
    return outcome;
  }

  std::array<int, 2> fds_{-1, -1};
  Certificate certificate_ = self_signed();
  std::shared_ptr<const TlsServerContext> server_context_ = server_context(certificate_);
};

TEST_F(TlsSessionTest, carries_bytes_both_ways_once_the_pin_is_right) {
  auto server = this->server();
  auto client = this->client(pinned());
  ASSERT_EQ(shake_hands(server, client), HandshakeOutcome::kDone) << client.fault();
  std::array<std::uint8_t, 16> buffer{};
  EXPECT_EQ(client.write(bytes_of("hello")).size, 5U);
  EXPECT_EQ(server.read(buffer).size, 5U);
  EXPECT_EQ(server.write(bytes_of("good day")).size, 8U);
  EXPECT_EQ(client.read(buffer).size, 8U);
  EXPECT_EQ(std::string(buffer.begin(), buffer.begin() + 8), "good day");
  EXPECT_EQ(client.read(buffer).outcome, HandshakeOutcome::kWaitsToRead);
}

TEST_F(TlsSessionTest, does_not_trust_another_certificate_than_the_pinned_one) {
  auto server = this->server();
  auto client = this->client({"localhost", self_signed().fingerprint()});
  EXPECT_EQ(shake_hands(server, client), HandshakeOutcome::kFailed);
  EXPECT_NE(client.fault().find(to_string(certificate_.fingerprint())), std::string::npos);
  EXPECT_EQ(client.write(bytes_of("secret")).outcome, HandshakeOutcome::kFailed);
}

TEST_F(TlsSessionTest, without_a_pin_only_authorities_are_trusted) {
  auto server = this->server();
  auto client = this->client({"localhost", {}});
  EXPECT_EQ(shake_hands(server, client), HandshakeOutcome::kFailed);
  EXPECT_NE(client.fault().find("untrusted certificate"), std::string::npos) << client.fault();
}

TEST_F(TlsSessionTest, a_full_socket_makes_the_writer_wait_and_loses_nothing) {
  auto server = this->server();
  auto client = this->client(pinned());
  ASSERT_EQ(shake_hands(server, client), HandshakeOutcome::kDone);
  std::vector<std::uint8_t> sent(1 << 20), received;
  for (std::size_t i = 0; i < sent.size(); ++i)
    sent[i] = static_cast<std::uint8_t>(i * 7 + (i >> 8));
  std::vector<std::uint8_t> buffer(5000);
  bool waited = false;
  for (std::size_t at = 0; received.size() < sent.size();) {
    const auto step = server.write(std::span<const std::uint8_t>(sent).subspan(at));
    at += step.size;
    if (at < sent.size() && step.outcome != HandshakeOutcome::kWaitsToWrite) continue;
    waited = waited || step.outcome == HandshakeOutcome::kWaitsToWrite;
    const auto got = client.read(buffer);
    ASSERT_TRUE(got.outcome == HandshakeOutcome::kDone ||
                got.outcome == HandshakeOutcome::kWaitsToRead);
    received.insert(received.end(), buffer.begin(),
                    buffer.begin() + static_cast<std::ptrdiff_t>(got.size));
  }
  EXPECT_TRUE(waited);
  EXPECT_EQ(received, sent);
}

TEST_F(TlsSessionTest, only_authorities_of_the_given_file_are_trusted) {
  const TemporaryFolder folder;
  const auto file = [&](const char* name) { return (folder.path() / name).string(); };
  ASSERT_TRUE(certificate_.save(file("own")).ok() && self_signed().save(file("another")).ok());
  const auto outcome = [&](const std::string& authorities) {
    auto server = this->server();
    const auto context = TlsClientContext::create({.authorities_file = authorities});
    auto client = *TlsSession::connect(fds_[1], **context, {"localhost", std::nullopt});
    return shake_hands(server, client);
  };
  EXPECT_EQ(outcome(file("own")), HandshakeOutcome::kDone);
  EXPECT_EQ(outcome(file("another")), HandshakeOutcome::kFailed);
}

TEST_F(TlsSessionTest, a_client_shows_its_certificate_to_a_server_that_asks) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "own").string();
  ASSERT_TRUE(certificate_.save(file).ok());
  SSL_CTX_set_verify(server_context_->native(), SSL_VERIFY_PEER | SSL_VERIFY_FAIL_IF_NO_PEER_CERT,
                     [](int, X509_STORE_CTX*) { return 1; });
  const auto server_outcome = [&](const TlsClientFiles& files) {
    auto server = this->server();
    const auto context = TlsClientContext::create(files);
    auto client = *TlsSession::connect(fds_[1], **context, pinned());
    shake_hands(server, client);
    return server.handshake().outcome;
  };
  EXPECT_EQ(server_outcome({.certificate_file = file, .key_file = file}), HandshakeOutcome::kDone);
  EXPECT_EQ(server_outcome({}), HandshakeOutcome::kFailed);
}

TEST(TlsClientContext, files_that_hold_something_else_are_named) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "file.pem").string();
  std::ofstream(file) << "this is no certificate\n";
  for (const TlsClientFiles& files : {TlsClientFiles{.authorities_file = file},
                                      TlsClientFiles{.certificate_file = file, .key_file = file}}) {
    const auto context = TlsClientContext::create(files);
    ASSERT_FALSE(context);
    EXPECT_EQ(context.error().code, ErrorCode::kInvalidArgument);
    EXPECT_NE(context.error().message.find(file), std::string::npos);
  }
}

TEST_F(TlsSessionTest, a_close_and_a_lost_connection_are_no_failures) {
  auto server = this->server();
  auto client = this->client(pinned());
  ASSERT_EQ(shake_hands(server, client), HandshakeOutcome::kDone);
  std::array<std::uint8_t, 16> buffer{};
  server.say_goodbye();
  EXPECT_EQ(client.read(buffer).outcome, HandshakeOutcome::kEnded);
  ::close(std::exchange(fds_[1], -1));
  EXPECT_EQ(server.read(buffer).outcome, HandshakeOutcome::kEnded);
  EXPECT_NE(server.write(bytes_of("x")).outcome, HandshakeOutcome::kDone);  // without SIGPIPE
}

TEST_F(TlsSessionTest, recognises_peers_that_do_not_speak_tls) {
  auto server = this->server();
  constexpr std::string_view kRequest = "GET / HTTP/1.1\r\n\r\n";
  ASSERT_EQ(::send(fds_[1], kRequest.data(), kRequest.size(), 0),
            static_cast<ssize_t>(kRequest.size()));
  EXPECT_EQ(server.handshake().outcome, HandshakeOutcome::kFailed);
  EXPECT_TRUE(server.peer_speaks_plain_http());
}

TEST_F(TlsSessionTest, garbage_is_a_failure_that_stays_one) {
  auto server = this->server();
  const std::vector<std::uint8_t> garbage(1000, 0x5A);
  ASSERT_GT(::send(fds_[1], garbage.data(), garbage.size(), 0), 0);
  std::array<std::uint8_t, 16> buffer{};
  EXPECT_EQ(server.read(buffer).outcome, HandshakeOutcome::kFailed);
  EXPECT_FALSE(server.fault().empty());
  EXPECT_EQ(server.read(buffer).outcome, HandshakeOutcome::kFailed);
  EXPECT_FALSE(server.peer_speaks_plain_http());
}

}  // namespace
}  // namespace roomcast::net
