// SPDX-License-Identifier: Apache-2.0
// Other programs that this one starts and is connected to by pipes. They do not receive the
// terminal's Ctrl-C: whoever starts them ends them. Thread-safe (no state).
#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

#include "roomcast/core/result.h"

namespace roomcast {

/// Descriptors that become a program's standard streams; /dev/null where there is none.
struct ProgramStreams {
  int input = -1, output = -1;
  bool shares_stderr = false;
};

/// Starts `command[0]`, which is looked for on the PATH unless it has a slash, with the rest as its
/// arguments. kUnavailable, with the system's reason: it does not start.
[[nodiscard]] Result<pid_t> start_program(std::vector<std::string> command,
                                          const ProgramStreams& streams);

/// Waits for its end, without a limit. Returns the status that waitpid() gives.
int wait_for_program(pid_t pid);

}  // namespace roomcast
