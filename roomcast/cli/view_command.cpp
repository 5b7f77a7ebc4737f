// SPDX-License-Identifier: Apache-2.0
// roomcast view: shows the room in a window, or draws one picture without a window.
#include <memory>
#include <numbers>

#include "roomcast/cli/command.h"
#include "roomcast/cli/hub_option.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/render_mode_option.h"
#include "roomcast/cli/view_options.h"

namespace roomcast::cli {
namespace {

Eigen::Vector3d vector_from(const std::vector<double>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

Status run_view(ViewOptions options) {
  auto credential = find_credential(options.token);
  if (!credential) return credential.error();
  options.subscriber.credential = *std::move(credential);
  if (!options.png.empty()) return view_without_window(options);
  if (!options.headless) return view_in_window(options);
  return Error{ErrorCode::kInvalidArgument, "--headless needs --png FILE"};
}

}  // namespace

double ViewOptions::fov_rad() const {
  return fov_deg * std::numbers::pi / 180;
}

std::optional<RigidTransform> ViewOptions::world_from_view(const RigidTransform& start) const {
  if (at.empty()) return std::nullopt;
  const Eigen::Vector3d eye_m = vector_from(at);
  const Eigen::Vector3d forward = start.rotation * Eigen::Vector3d(0, 0, -1);
  return render::world_from_view_looking_at(
      eye_m, look.empty() ? Eigen::Vector3d(eye_m + forward) : vector_from(look));
}

void add_view_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command =
      app.add_subcommand("view", "View a room in a window, or draw one picture of it");
  add_hub_option(*command, options->subscriber.hub_url);
  command->add_option("--room", options->subscriber.room, "The room (default: the hub's only one)");
  add_token_options(*command, options->token);
  command->add_option("--name", options->subscriber.name, "Name shown to others");
  command->add_flag("--headless", options->headless, "Without a window: needs --png");
  CLI::Option* const png = command->add_option(
      "--png", options->png, "Write one picture to this file without a window, and end");
  command->add_option("--at", options->at, "Viewpoint: x,y,z in metres (default: the hub's)")
      ->delimiter(',')
      ->expected(3);
  command->add_option("--look", options->look, "Point to look at: x,y,z in metres")
      ->delimiter(',')
      ->expected(3)
      ->needs("--at");
  command->add_option("--size", options->size, "Width,height of the window or the picture")
      ->delimiter(',')
      ->expected(2)
      ->capture_default_str();
  command->add_option("--fov", options->fov_deg, "Vertical field of view, degrees")
      ->check(within(1.0, 170.0))
      ->capture_default_str();
  command
      ->add_option("--seconds", options->seconds,
                   "Receive for this time before drawing; with a window: close it then")
      ->check(seconds_from_zero());
  add_view_mode_option(*command, "--mode", options->mode);
  command->add_flag("--json", options->json, "With --png: print the drawn frames as JSON")
      ->needs(png);
  command->add_flag("--vr", options->vr, "Show the room in a headset, too (OpenXR)")->excludes(png);
  command->add_flag("--full-screen", options->full_screen, "Full screen")->excludes(png);
  command->add_flag("!--no-panel", options->panel, "Start with a closed panel (Tab opens it)")
      ->excludes(png);
  command
      ->add_option("--microphone", options->microphone,
                   "What others hear once it is on: default, none, a device's name, or FILE.wav")
      ->capture_default_str()
      ->excludes(png);
  command
      ->add_option("--speaker", options->loudspeaker,
                   "Where you hear the others: default, none, a device's name, or a new FILE.wav")
      ->capture_default_str()
      ->excludes(png);
  command->add_flag("--speak", options->speaks, "Start with the microphone on (T turns it on)")
      ->excludes(png);
  command->add_option("--pictures", options->pictures, "Folder for screenshots and videos")
      ->capture_default_str();
  command
      ->add_option("--last-picture", options->last_picture,
                   "Write the window's last picture, with its panel, to this file")
      ->excludes(png);
  command->footer(
      "In the window H shows all keys. With --png the program waits up to 10 s for a picture of "
      "every\n"
      "sensor in the room, then draws those that there are, and names the others. Without any "
      "sensor "
      "it\n"
      "draws nothing, reports that and exits with 1.\n"
      "Examples:\n"
      "  roomcast view --hub ws://127.0.0.1:7600\n"
      "  roomcast view --hub ws://127.0.0.1:7600 --speak --microphone \"USB Audio\"\n"
      "  roomcast view --hub ws://127.0.0.1:7600 --png room.png --at 3,1.6,2 --look 0,1,0");
  command->callback(
      [options, &chosen] { chosen = [options] { return finish("view", run_view(*options)); }; });
}

}  // namespace roomcast::cli
