// SPDX-License-Identifier: Apache-2.0
// Shared by main() and the subcommands. Each subcommand adds itself to the command line and
// supplies the function to run. Exit codes: 0 success, 1 failure, 2 wrong usage. A command that
// fails prints the reason as one sentence on stderr.
#pragma once

#include <functional>
#include <string_view>

#include <CLI/CLI.hpp>

#include "roomcast/core/result.h"

namespace roomcast::cli {

/// The chosen command with its options bound. Returns the exit code.
using Command = std::function<int()>;

inline constexpr int kDone = 0, kFailed = 1, kWrongUsage = 2;

/// Returns the exit code; on failure also prints "roomcast NAME: sentence" to stderr.
/// kInvalidArgument is wrong usage.
int finish(std::string_view name, const Status& status);

void add_demo_command(CLI::App& app, Command& chosen);
void add_hub_command(CLI::App& app, Command& chosen);
void add_sensor_command(CLI::App& app, Command& chosen);
void add_view_command(CLI::App& app, Command& chosen);
void add_simulate_command(CLI::App& app, Command& chosen);
void add_contact_sheet_command(CLI::App& app, Command& chosen);
void add_calibrate_command(CLI::App& app, Command& chosen);
void add_devices_command(CLI::App& app, Command& chosen);
void add_doctor_command(CLI::App& app, Command& chosen);
void add_record_command(CLI::App& app, Command& chosen);
void add_play_command(CLI::App& app, Command& chosen);
void add_import_command(CLI::App& app, Command& chosen);
void add_info_command(CLI::App& app, Command& chosen);
void add_export_command(CLI::App& app, Command& chosen);
void add_foxglove_command(CLI::App& app, Command& chosen);
void add_measure_command(CLI::App& app, Command& chosen);
void add_align_command(CLI::App& app, Command& chosen);
void add_board_command(CLI::App& app, Command& chosen);
void add_nudge_command(CLI::App& app, Command& chosen);
void add_token_command(CLI::App& app, Command& chosen);
void add_bench_command(CLI::App& app, Command& chosen);

}  // namespace roomcast::cli
