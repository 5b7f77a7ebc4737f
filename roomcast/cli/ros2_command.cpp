// SPDX-License-Identifier: Apache-2.0
// roomcast ros2: publishes a room as topics of ROS 2, live.
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "roomcast/cli/command.h"
#include "roomcast/cli/hub_option.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/stderr_log.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/cli/token_option.h"
#include "roomcast/client/subscriber.h"
#include "roomcast/ros2/bridge/room_bridge.h"

namespace roomcast::cli {
namespace {

struct Ros2Options {
  client::SubscriberOptions subscriber;
  TokenOption token;
  ros2::RoomTopicsOptions topics;
  int domain = -1;  // negative: ROS_DOMAIN_ID
  std::string up = "z";
  bool insecure = false;
  bool json = false;
  bool verbose = false;
};

void announce_topics(const Ros2Options& options, int domain,
                     const std::vector<std::string>& names) {
  if (options.json) {
    print_out("{}\n", nlohmann::json{{"domain", domain}, {"topics", names}}.dump());
  } else {
    print_out("roomcast ros2: in ROS_DOMAIN_ID {}, {} topics:\n", domain, names.size());
    for (const std::string& name : names) print_out("  {}\n", name);
  }
  std::fflush(stdout);
}

Result<ros2::ParticipantOptions> participant_options(const Ros2Options& options) {
  auto participant = ros2::options_of_environment();
  if (!participant) return participant.error();
  if (options.domain >= 0) participant->domain = options.domain;
  if (!options.insecure) participant->only_localhost = true;
  return participant;
}

Status run_ros2(Ros2Options options) {
  StopOnSignal stop;
  options.topics.up = options.up == "y" ? recording::UpAxis::kY : recording::UpAxis::kZ;
  if (Status status = options.topics.check(); !status) return status;
  const auto in_domain = participant_options(options);
  if (!in_domain) return in_domain.error();
  auto credential = find_credential(options.token);
  if (!credential) return credential.error();
  const LogSink log = stderr_log("ros2", options.verbose);
  options.subscriber.credential = *std::move(credential);
  options.subscriber.log = log;
  options.subscriber.stop = stop.token();
  const auto participant = ros2::Participant::open(*in_domain);
  if (!participant) return participant.error();
  const auto room = client::Subscriber::open(options.subscriber);
  if (!room) return room.error();
  const auto topics = ros2::RoomTopics::open(**participant, options.topics);
  if (!topics) return topics.error();
  ros2::RoomBridgeOptions bridge;
  bridge.log = log;
  bridge.on_topics = [&](const std::vector<std::string>& names) {
    announce_topics(options, in_domain->domain, names);
  };
  return ros2::bridge_room(**room, **topics, bridge, stop.token());
}

}  // namespace

void add_ros2_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<Ros2Options>();
  CLI::App* command = app.add_subcommand("ros2", "Publish a room as topics of ROS 2, live");
  add_hub_option(*command, options->subscriber.hub_url);
  command->add_option("--room", options->subscriber.room, "The room (default: the hub's only one)");
  add_token_options(*command, options->token);
  command->add_option("--domain", options->domain, "Domain of ROS 2 (default: ROS_DOMAIN_ID, or 0)")
      ->check(within(0, ros2::kMaxDomain));
  command->add_option("--prefix", options->topics.prefix, "Before the names of all topics")
      ->capture_default_str();
  command->add_flag("--insecure", options->insecure,
                    "Publish to the whole network: everybody there can watch, without token and "
                    "encryption; else this computer's programs only");
  command->add_flag("--reliable", options->topics.is_reliable,
                    "Send pictures and points again where they were lost; else as ROS 2's sensor "
                    "data, best effort");
  command->add_option("--up", options->up, "Axis of `world` that points up: z or y")
      ->check(CLI::IsMember({"y", "z"}))
      ->capture_default_str();
  command
      ->add_option("--voxel", options->topics.cloud.voxel_m,
                   "One point of the room's cloud for each cube of this size (metres)")
      ->check(within(0.0, 1.0));
  command->add_flag("--json", options->json, "Print the topics as JSON, one line for each change");
  command->add_flag("--verbose", options->verbose, "Log the connection's state");
  command->footer(
      "Topics: /roomcast/points, /tf_static, and for each sensor /roomcast/NAME/depth/image_raw,\n"
      "depth/camera_info, color/image_raw, color/camera_info and points. Only what somebody reads\n"
      "is made. Without --insecure, start ROS 2's programs with ROS_LOCALHOST_ONLY=1.\n"
      "Example:\n  roomcast ros2 --hub ws://127.0.0.1:7600");
  command->callback(
      [options, &chosen] { chosen = [options] { return finish("ros2", run_ros2(*options)); }; });
}

}  // namespace roomcast::cli
