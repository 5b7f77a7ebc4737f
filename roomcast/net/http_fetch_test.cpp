// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/http_fetch.h"

#include <future>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/net/http_server_fixture.h"

namespace roomcast::net {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

class HttpFetchTest : public HttpServerTest {
 protected:
  HubUrl url() const { return {"127.0.0.1", server_->port(), "/ws"}; }

  /// Asks on another thread, while this one serves.
  Result<FetchedAnswer> fetched(const HubUrl& url, const std::string& target,
                                const FetchOptions& options = {}) {
    auto answer = std::async(std::launch::async, [&] { return fetch(url, target, options); });
    EXPECT_TRUE(run_until([&] { return answer.wait_for(0s) == std::future_status::ready; }));
    return answer.get();
  }
};

TEST_F(HttpFetchTest, gets_what_is_there_and_says_what_is_not) {
  listen();
  const auto page = fetched(url(), "/page");
  ASSERT_TRUE(page.ok()) << page.error().message;
  EXPECT_EQ(page->status, 200);
  EXPECT_EQ(page->body, "a page");
  EXPECT_EQ(fetched(url(), "/large").value().body.size(), 3'000'000U);
  EXPECT_EQ(fetched(url(), "/nowhere").value().status, 404);
}

TEST_F(HttpFetchTest, shows_its_token) {
  auto with_program = options();
  std::string shown;
  with_program.on_request = [&](const HttpRequest& request, const Respond& answer) {
    shown = request.authorization;
    answer(text_response(200, "yes"));
  };
  listen(std::move(with_program));
  FetchOptions options;
  options.token = "abc";
  ASSERT_TRUE(fetched(url(), "/api/v1/rooms", options).ok());
  EXPECT_EQ(shown, "Bearer abc");
}

TEST_F(HttpFetchTest, what_is_too_long_and_what_is_no_http_is_refused) {
  listen();
  FetchOptions options;
  options.max_bytes = 1000;
  EXPECT_EQ(fetched(url(), "/large", options).error().code, ErrorCode::kUnsupported);
  Tcp::acceptor stranger(io_, Tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0));
  std::optional<Tcp::socket> socket;
  stranger.async_accept([&](boost::system::error_code error, Tcp::socket accepted) {
    ASSERT_FALSE(error);
    send(accepted, "220 mail");
    accepted.shutdown(Tcp::socket::shutdown_send);
    socket = std::move(accepted);
  });
  EXPECT_FALSE(fetched({"127.0.0.1", stranger.local_endpoint().port(), "/ws"}, "/page").ok());
}

TEST_F(HttpFetchTest, ends_when_nobody_answers_in_time_or_when_it_is_stopped) {
  Tcp::acceptor silent(io_, Tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0));
  const HubUrl url{"127.0.0.1", silent.local_endpoint().port(), "/ws"};
  FetchOptions hasty;
  hasty.within = 50ms;
  const auto late = fetched(url, "/page", hasty);
  EXPECT_EQ(late.error().code, ErrorCode::kUnavailable);
  EXPECT_THAT(late.error().message, HasSubstr("in time"));
  std::stop_source stop;
  stop.request_stop();
  FetchOptions stopped;
  stopped.stop = stop.get_token();
  EXPECT_EQ(fetched(url, "/page", stopped).error().code, ErrorCode::kClosed);
}

TEST_F(HttpFetchTest, nobody_listens) {
  listen();
  const HubUrl gone = url();
  server_.reset();
  run_for(50ms);
  EXPECT_EQ(fetched(gone, "/page").error().code, ErrorCode::kUnavailable);
}

}  // namespace
}  // namespace roomcast::net
