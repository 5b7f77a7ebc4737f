// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <cstdlib>
#include <string_view>

#include "roomcast/ros2/dds/participant.h"

namespace roomcast::ros2 {
namespace {

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string_view() : value;
}

}  // namespace

Status ParticipantOptions::check() const {
  if (domain >= 0 && domain <= kMaxDomain) return {};
  return invalid_argument("a domain of ROS 2 is a number from 0 to " + std::to_string(kMaxDomain));
}

Result<ParticipantOptions> options_of_environment() {
  ParticipantOptions options;
  const std::string_view domain = variable("ROS_DOMAIN_ID");
  const char* const end = domain.data() + domain.size();
  const auto [rest, error] = std::from_chars(domain.data(), end, options.domain);
  if (!domain.empty() && (error != std::errc() || rest != end || !options.check()))
    return invalid_argument("ROS_DOMAIN_ID is \"" + std::string(domain) +
                            "\", not a number from 0 to " + std::to_string(kMaxDomain));
  options.only_localhost = variable("ROS_LOCALHOST_ONLY") == "1";
  return options;
}

}  // namespace roomcast::ros2
