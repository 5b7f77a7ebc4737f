// SPDX-License-Identifier: Apache-2.0
// Shared by main() and the subcommands. Each subcommand adds itself to the command line and
// supplies the function to run. Exit codes: 0 success, 1 failure, 2 wrong usage. When a command
// fails, run_program() prints the reason as one sentence on stderr, and with --json also as an
// object on stdout: {"error": {"code": "not_found", "sentence": "..."}}.
#pragma once

#include <functional>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>

#include "roomcast/core/result.h"

namespace roomcast::cli {

/// How a command ended.
struct Outcome {
  Outcome(Error error) : status(std::move(error)) {}  // NOLINT: implicit
  Outcome(Status how, bool is_told = false)           // NOLINT: implicit
      : status(std::move(how)), told(is_told) {}

  Status status;
  bool told = false;  // the report on stdout has the error, too: add_error()
};

struct Finished {
  std::string_view name;  // of the command
  Outcome outcome;
};

/// The chosen command with its options bound.
using Command = std::function<Finished()>;

inline constexpr int kDone = 0, kFailed = 1, kWrongUsage = 2;

[[nodiscard]] inline Finished finish(std::string_view name, Outcome outcome) {
  return {name, std::move(outcome)};
}

/// Tells how a command ended: on failure "roomcast NAME: sentence" on stderr, with `json` also on
/// stdout. Returns the exit code; kInvalidArgument is wrong usage.
int tell(const Finished& finished, bool json);

/// Adds "error" to a report that is printed although the command failed.
void add_error(const Status& status, nlohmann::json& report);

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
void add_ros2_command(CLI::App& app, Command& chosen);
void add_measure_command(CLI::App& app, Command& chosen);
void add_align_command(CLI::App& app, Command& chosen);
void add_board_command(CLI::App& app, Command& chosen);
void add_nudge_command(CLI::App& app, Command& chosen);
void add_study_command(CLI::App& app, Command& chosen);
void add_token_command(CLI::App& app, Command& chosen);
void add_bench_command(CLI::App& app, Command& chosen);

}  // namespace roomcast::cli
