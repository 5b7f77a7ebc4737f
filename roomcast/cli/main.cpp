// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/built_in_cameras.h"
#include "roomcast/cli/program.h"
#include "roomcast/cli/version.h"

int main(int argc, char** argv) {
  using namespace roomcast::cli;
  constexpr AddCommand kCommands[] = {
      add_demo_command,     add_hub_command,           add_sensor_command,    add_view_command,
      add_simulate_command, add_contact_sheet_command, add_calibrate_command, add_devices_command,
      add_doctor_command,   add_record_command,        add_play_command,      add_import_command,
      add_info_command,     add_export_command,        add_foxglove_command,  add_ros2_command,
      add_measure_command,  add_align_command,         add_board_command,     add_nudge_command,
      add_token_command,    add_study_command,         add_bench_command,
  };
  return run_program(argc, argv, kCommands, version_text(built_in_cameras()));
}
