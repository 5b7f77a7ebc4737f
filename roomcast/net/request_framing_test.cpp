// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/request_framing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/net/http_server_fixture.h"

namespace roomcast::net {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

namespace http = boost::beast::http;

http::header<true, http::fields> plain_request() {
  http::header<true, http::fields> request;
  request.method(http::verb::get);
  request.version(11);
  request.set(http::field::host, "hub.example");
  return request;
}

int refusal_of_framing(const http::header<true, http::fields>& request) {
  const auto refusal = refuse_ambiguous(request);
  return refusal ? refusal->status : 0;
}

int refusal_of_codings(std::initializer_list<const char*> codings, unsigned version = 11) {
  auto request = plain_request();
  request.version(version);
  for (const char* const coding : codings) {
    request.insert(http::field::transfer_encoding, coding);
  }
  return refusal_of_framing(request);
}

TEST(RequestFraming, takes_one_host_and_one_origin) {
  auto request = plain_request();
  EXPECT_EQ(refusal_of_framing(request), 0);
  request.set(http::field::origin, "http://hub.example");
  EXPECT_EQ(refusal_of_framing(request), 0);
}

TEST(RequestFraming, refuses_a_second_host_even_if_it_is_the_same) {
  auto request = plain_request();
  request.insert(http::field::host, "hub.example");
  EXPECT_EQ(refusal_of_framing(request), 400);
}

TEST(RequestFraming, refuses_a_second_origin) {
  auto request = plain_request();
  request.insert(http::field::origin, "http://hub.example");
  request.insert(http::field::origin, "http://evil.example");
  EXPECT_EQ(refusal_of_framing(request), 400);
}

TEST(RequestFraming, chunked_is_the_only_transfer_coding) {
  EXPECT_EQ(refusal_of_codings({"chunked"}), 0);
  EXPECT_EQ(refusal_of_codings({"Chunked"}), 0);
  EXPECT_EQ(refusal_of_codings({"xchunked"}), 501);
  EXPECT_EQ(refusal_of_codings({"gzip, chunked"}), 501);
  EXPECT_EQ(refusal_of_codings({"chunked, chunked"}), 501);
  EXPECT_EQ(refusal_of_codings({"gzip", "chunked"}), 501);
  EXPECT_EQ(refusal_of_codings({"identity"}), 501);
  EXPECT_EQ(refusal_of_codings({""}), 501);
}

TEST(RequestFraming, http_1_0_has_no_transfer_coding) {
  EXPECT_EQ(refusal_of_codings({"chunked"}, 10), 400);
}

/// Requests as they come over a socket. The server closes after its one answer: exchange() reads
/// to the end, and a second answer would be in what it returns.
class AmbiguousRequestTest : public HttpServerTest {
 protected:
  AmbiguousRequestTest() {
    auto with_program = options();
    with_program.on_request = [this](const HttpRequest&, const Respond& respond) {
      ++times_asked_;
      respond(text_response(200, "done"));
    };
    listen(std::move(with_program));
  }

  void expect_refused(std::string_view bytes, std::string_view status) {
    const std::string next = request("GET", "/page");
    const std::string answer = exchange(std::string(bytes) + next);
    EXPECT_THAT(answer, AllOf(StartsWith("HTTP/1.1 " + std::string(status) + " "),
                              HasSubstr("Connection: close\r\n")))
        << bytes;
    EXPECT_EQ(answer.find("HTTP/1.1 ", 1), std::string::npos) << answer;
    EXPECT_EQ(times_asked_, 0) << bytes;
    EXPECT_TRUE(handlers_.empty()) << bytes;
  }
};

TEST_F(AmbiguousRequestTest, two_hosts_are_refused_on_every_path) {
  const std::string two = "Host: evil.example\r\n";
  expect_refused(request("GET", "/page", two), "400");
  expect_refused(request("POST", "/api/x", two + "Content-Length: 0\r\n"), "400");
  expect_refused(upgrade_request(two), "400");
}

TEST_F(AmbiguousRequestTest, two_origins_are_refused_on_every_path) {
  const std::string two = "Origin: http://" + host() + "\r\nOrigin: http://evil.example\r\n";
  expect_refused(request("GET", "/page", two), "400");
  expect_refused(request("POST", "/api/x", two + "Content-Length: 0\r\n"), "400");
  expect_refused(upgrade_request(two), "400");
}

TEST_F(AmbiguousRequestTest, unknown_transfer_codings_are_refused_on_every_path) {
  const std::string coded = "Transfer-Encoding: xchunked\r\n";
  expect_refused(request("GET", "/page", coded), "501");
  expect_refused(request("POST", "/api/x", coded + "Content-Length: 5\r\n"), "501");
  expect_refused(upgrade_request(coded), "501");
}

}  // namespace
}  // namespace roomcast::net
