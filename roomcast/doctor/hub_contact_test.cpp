// SPDX-License-Identifier: Apache-2.0
#include "roomcast/doctor/hub_contact.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <gtest/gtest.h>

#include "roomcast/hub/server/running_hub.h"

namespace roomcast::doctor {
namespace {

TEST(DoctorHub, measures_the_round_trip_to_a_hub) {
  const hub::RunningHub hub;
  const Finding finding = check_hub(hub.url());
  EXPECT_EQ(finding.verdict, Verdict::kOk) << finding.sentence;
  EXPECT_NE(finding.sentence.find(" ms"), std::string::npos) << finding.sentence;
}

TEST(DoctorHub, a_port_at_which_nobody_listens_is_a_problem_with_a_remedy) {
  boost::asio::io_context io;
  using boost::asio::ip::tcp;
  tcp::acceptor closed(io, tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0));
  const auto port = closed.local_endpoint().port();
  closed.close();
  const Finding finding = check_hub("ws://127.0.0.1:" + std::to_string(port));
  EXPECT_EQ(finding.verdict, Verdict::kProblem);
  EXPECT_NE(finding.sentence.find(std::to_string(port)), std::string::npos) << finding.sentence;
  EXPECT_NE(finding.remedy, "");
}

TEST(DoctorHub, nonsense_is_no_address) {
  EXPECT_EQ(check_hub("::::").verdict, Verdict::kProblem);
}

}  // namespace
}  // namespace roomcast::doctor
