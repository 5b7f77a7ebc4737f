// SPDX-License-Identifier: Apache-2.0
// The program of the package roomcast-hub: what a hub's computer needs, without window, graphics
// and cameras. Named `roomcast`, too, so that all guides hold for it.
#include "roomcast/cli/program.h"
#include "roomcast/cli/version.h"

int main(int argc, char** argv) {
  using namespace roomcast::cli;
  constexpr AddCommand kCommands[] = {add_hub_command, add_token_command, add_record_command,
                                      add_play_command, add_study_command};
  return run_program(argc, argv, kCommands, version_text());
}
