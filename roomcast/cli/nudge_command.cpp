// SPDX-License-Identifier: Apache-2.0
// roomcast nudge: sends an approximate pose of a sensor. The hub's aligner refines it, or rejects
// it with a reason.
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "roomcast/cli/command.h"
#include "roomcast/cli/print.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/cli/token_option.h"
#include "roomcast/client/nudge.h"

namespace roomcast::cli {
namespace {

struct NudgeCommand {
  client::NudgeOptions options;
  std::vector<double> move_m = {0, 0, 0};
  double turn_deg = 0, tilt_deg = 0;
  TokenOption token;
  bool json = false;
};

Status run_nudge(NudgeCommand command) {
  auto credential = find_credential(command.token);
  if (!credential) return credential.error();
  command.options.credential = *std::move(credential);
  command.options.shift_m = Eigen::Vector3d::Map(command.move_m.data());
  command.options.turn_rad = command.turn_deg * std::numbers::pi / 180;
  command.options.tilt_rad = command.tilt_deg * std::numbers::pi / 180;
  StatusLine line;
  line.show("the aligner checks the pose");
  const auto answer = client::nudge_sensor(command.options);
  if (!answer) return answer.error();
  if (command.json) {
    print_out("{}\n", nlohmann::json{{"sensor", command.options.sensor},
                                     {"world_from_depth",
                                      row_major_from_transform(answer->world_from_depth)},
                                     {"expected_error_mm", answer->expected_error_mm}}
                          .dump());
    return {};
  }
  const Eigen::Vector3d& at = answer->world_from_depth.translation_m;
  print_out("{} is at {:.3f}, {:.3f}, {:.3f} m; expected error {:.0f} mm\n", command.options.sensor,
            at.x(), at.y(), at.z(), answer->expected_error_mm);
  return {};
}

}  // namespace

void add_nudge_command(CLI::App& app, Command& chosen) {
  auto values = std::make_shared<NudgeCommand>();
  CLI::App* command =
      app.add_subcommand("nudge", "Propose a pose for a sensor; the aligner refines it");
  command->add_option("sensor", values->options.sensor, "Its name in the room")->required();
  command->add_option("--hub", values->options.hub_url, "ws://HOST:PORT")->required();
  add_token_options(*command, values->token);
  command->add_option("--room", values->options.room, "The room (default: the hub's only one)");
  command->add_option("--move", values->move_m, "Metres along the room's axes: X Y Z, y up")
      ->expected(3);
  command->add_option("--turn", values->turn_deg,
                      "Degrees about the vertical, counter-clockwise seen from above");
  command->add_option("--tilt", values->tilt_deg, "Degrees upwards, in place");
  command->add_flag("--json", values->json, "Print JSON");
  command->footer(
      "Example:\n  roomcast nudge s2 --hub ws://127.0.0.1:7600 --token TOKEN --move 0.4 0 -0.2 "
      "--turn 15");
  command->callback(
      [values, &chosen] { chosen = [values] { return finish("nudge", run_nudge(*values)); }; });
}

}  // namespace roomcast::cli
