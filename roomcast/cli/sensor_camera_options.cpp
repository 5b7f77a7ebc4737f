// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/sensor_camera_options.h"

#include <map>
#include <string>

#include "roomcast/cli/named_choice.h"
#include "roomcast/cli/number_option.h"

namespace roomcast::cli {

void add_camera_options(CLI::App& command, sensor::SourceOptions& source) {
  const std::map<std::string, source::SyncRole> roles = {
      {"alone", source::SyncRole::kAlone},
      {"primary", source::SyncRole::kPrimary},
      {"secondary", source::SyncRole::kSecondary}};
  source::CameraSettings& camera = source.camera;
  command.add_option(
      "--calibration", source.calibration,
      "A camera.json of roomcast calibrate, used instead of the camera's own calibration");
  command.add_flag("--lock-exposure", camera.lock_exposure,
                   "Keep the exposure of the first seconds, so that the sensors' pictures match");
  command.add_flag("--lock-white-balance", camera.lock_white_balance, "Likewise");
  choose_by_name(command.add_option("--sync", camera.sync, "Role on a sync cable"), roles);
  command
      .add_option_function<int>(
          "--trigger-delay-us",
          [&camera](int delay) { camera.trigger_delay = std::chrono::microseconds(delay); },
          "Delay after the primary's pulse: 160 for each unit before it, so that time-of-flight "
          "cameras do not disturb each other")
      ->check(within(0, static_cast<int>(source::kLongestTriggerDelay.count())));
}

}  // namespace roomcast::cli
