// SPDX-License-Identifier: Apache-2.0
// roomcast-demo: `roomcast demo` alone, for scripts/demo. It is built in a fraction of the time
// that the whole program takes.
#include "roomcast/cli/built_in_cameras.h"
#include "roomcast/cli/program.h"
#include "roomcast/cli/version.h"

int main(int argc, char** argv) {
  using namespace roomcast::cli;
  constexpr AddCommand kCommands[] = {add_demo_command};
  return run_program(argc, argv, kCommands, version_text(built_in_cameras()));
}
