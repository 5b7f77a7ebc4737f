// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/stream.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>

#include "roomcast/net/loopback_fixture.h"
#include "roomcast/net/tls/tls_fixture.h"

namespace roomcast::net {
namespace {

namespace asio = boost::asio;

/// Each test runs with TLS and without.
class StreamTest : public LoopbackTest, public ::testing::WithParamInterface<bool> {
 protected:
  StreamTest() {
    auto sockets = LoopbackTest::connected_sockets();
    if (!GetParam()) {
      ours_.emplace(std::move(sockets.ours));
      theirs_.emplace(std::move(sockets.theirs));
      return;
    }
    const Certificate certificate = self_signed();
    const auto clients = TlsClientContext::create();
    auto accept = TlsSession::accept(sockets.ours.native_handle(), *server_context(certificate));
    auto connect = TlsSession::connect(sockets.theirs.native_handle(), **clients,
                                       {"localhost", certificate.fingerprint()});
    ours_.emplace(std::move(sockets.ours), *std::move(accept));
    theirs_.emplace(std::move(sockets.theirs), *std::move(connect));
  }

  std::optional<Stream> ours_, theirs_;
};

INSTANTIATE_TEST_SUITE_P(Plain, StreamTest, ::testing::Values(false));
INSTANTIATE_TEST_SUITE_P(Tls, StreamTest, ::testing::Values(true));

TEST_P(StreamTest, carries_more_than_the_socket_holds) {
  std::vector<std::uint8_t> sent(8 << 20), received(sent.size());
  for (std::size_t i = 0; i < sent.size(); ++i) sent[i] = static_cast<std::uint8_t>(i + (i >> 10));
  bool all_sent = false, all_received = false;
  asio::async_write(
      *ours_,
      std::array<asio::const_buffer, 2>{asio::buffer(sent, 1000), asio::buffer(sent) + 1000},
      [&](auto error, std::size_t) { all_sent = !error; });
  asio::async_read(*theirs_, asio::buffer(received),
                   [&](auto error, std::size_t) { all_received = !error; });
  EXPECT_TRUE(run_until([&] { return all_sent && all_received; }));
  EXPECT_EQ(received, sent);
}

TEST_P(StreamTest, ends_with_eof_after_the_last_byte) {
  bool shaken = false;
  theirs_->async_handshake([&](auto error, std::size_t) { shaken = !error; });
  std::array<char, 16> buffer{};
  std::string received;
  boost::system::error_code end;
  std::function<void()> read = [&] {
    theirs_->async_read_some(asio::buffer(buffer), [&](auto error, std::size_t size) {
      received.append(buffer.data(), size);
      end = error;
      if (!error) read();
    });
  };
  asio::async_write(*ours_, asio::buffer("good day", 8),
                    [&](auto, std::size_t) { ours_->shutdown_send(); });
  ASSERT_TRUE(run_until([&] { return shaken; }));
  read();
  EXPECT_TRUE(run_until([&] { return end.failed(); }));
  EXPECT_EQ(end, asio::error::eof);
  EXPECT_EQ(received, "good day");
}

TEST_P(StreamTest, nothing_completes_within_the_call_that_starts_it) {
  bool completed = false;
  ours_->async_handshake([&](auto, std::size_t) { completed = true; });
  EXPECT_FALSE(completed);
  ours_->close();
  EXPECT_TRUE(run_until([&] { return completed; }));
}

TEST_P(StreamTest, closing_ends_a_read_under_way) {
  std::array<char, 16> buffer{};
  boost::system::error_code end;
  ours_->async_read_some(asio::buffer(buffer), [&](auto error, std::size_t) { end = error; });
  run_ready();
  EXPECT_FALSE(end);
  ours_->close();
  EXPECT_TRUE(run_until([&] { return end.failed(); }));
  EXPECT_EQ(end, asio::error::operation_aborted);
}

}  // namespace
}  // namespace roomcast::net
