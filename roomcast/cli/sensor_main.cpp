// SPDX-License-Identifier: Apache-2.0
// The program of the package roomcast-sensor: what a camera's computer needs, without hub, window
// and graphics. Named `roomcast`, too, so that all guides hold for it.
#include "roomcast/cli/built_in_cameras.h"
#include "roomcast/cli/program.h"
#include "roomcast/cli/version.h"

int main(int argc, char** argv) {
  using namespace roomcast::cli;
  constexpr AddCommand kCommands[] = {add_sensor_command, add_devices_command,
                                      add_calibrate_command, add_board_command};
  return run_program(argc, argv, kCommands, version_text(built_in_cameras()));
}
