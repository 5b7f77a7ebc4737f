// SPDX-License-Identifier: Apache-2.0
// Subcommands of `roomcast bench` that are defined in files of their own.
#pragma once

#include "roomcast/cli/command.h"

namespace roomcast::cli {

void add_abuse_bench(CLI::App& bench, Command& chosen);
void add_align_bench(CLI::App& bench, Command& chosen);
void add_fanout_bench(CLI::App& bench, Command& chosen);
void add_frame_times_bench(CLI::App& bench, Command& chosen);
void add_latency_bench(CLI::App& bench, Command& chosen);
void add_line_bench(CLI::App& bench, Command& chosen);
void add_model_bench(CLI::App& bench, Command& chosen);
void add_moved_furniture_bench(CLI::App& bench, Command& chosen);
void add_real_bench(CLI::App& bench, Command& chosen);
void add_redundancy_bench(CLI::App& bench, Command& chosen);
void add_render_bench(CLI::App& bench, Command& chosen);

}  // namespace roomcast::cli
