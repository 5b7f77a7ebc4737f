// SPDX-License-Identifier: Apache-2.0
#include "roomcast/doctor/network.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <gtest/gtest.h>

namespace roomcast::doctor {
namespace {

using boost::asio::ip::tcp;

TEST(DoctorNetwork, a_port_in_use_is_noticed_and_a_free_one_is_ok) {
  boost::asio::io_context io;
  tcp::acceptor other(io, tcp::endpoint(tcp::v4(), 0));
  const std::uint16_t port = other.local_endpoint().port();
  EXPECT_EQ(check_port(port).verdict, Verdict::kNotice);
  other.close();
  EXPECT_EQ(check_port(port).verdict, Verdict::kOk);
}

TEST(DoctorNetwork, names_the_addresses) {
  const Finding finding = judge_addresses({"192.0.2.7", "198.51.100.3"});
  EXPECT_EQ(finding.verdict, Verdict::kOk);
  EXPECT_NE(finding.sentence.find("192.0.2.7, 198.51.100.3"), std::string::npos);
  EXPECT_EQ(judge_addresses({}).verdict, Verdict::kNotice);
}

}  // namespace
}  // namespace roomcast::doctor
