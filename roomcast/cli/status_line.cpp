// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/status_line.h"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace roomcast::cli {

StatusLine::StatusLine() : on_terminal_(isatty(STDERR_FILENO) == 1) {}

StatusLine::~StatusLine() {
  if (shown_) fmt::print(stderr, "\n");
}

void StatusLine::show(std::string_view text) {
  if (!on_terminal_) return;
  fmt::print(stderr, "\r{}\x1b[K", text);  // clear to the end of the line
  shown_ = true;
}

}  // namespace roomcast::cli
