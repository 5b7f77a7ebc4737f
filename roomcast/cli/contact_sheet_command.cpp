// SPDX-License-Identifier: Apache-2.0
// roomcast contact-sheet: one overview picture for each simulated room.
#include <memory>
#include <string>

#include <fmt/format.h>

#include "roomcast/cli/command.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/simulator/rig/contact_sheet.h"

namespace roomcast::cli {
namespace {

Status run_contact_sheet(const std::string& folder, const simulator::ContactSheetOptions& options) {
  StatusLine line;
  line.show("building the rooms");
  return simulator::write_contact_sheets(folder, options, [&line](int done, int total) {
    line.show(fmt::format("{} of {} rooms drawn", done, total));
  });
}

}  // namespace

void add_contact_sheet_command(CLI::App& app, Command& chosen) {
  auto folder = std::make_shared<std::string>();
  auto options = std::make_shared<simulator::ContactSheetOptions>();
  CLI::App* command =
      app.add_subcommand("contact-sheet", "Draw every simulated room as its sensors see it");
  command->add_option("folder", *folder, "Folder for the files <scene>.jpg")->required();
  command->add_option("--seed", options->seed, "Seed of the rooms")
      ->check(seed_number())
      ->capture_default_str();
  command->add_option("--width", options->cell_width, "Width of one sensor's view in pixels")
      ->check(within(64, 1920))
      ->capture_default_str();
  command->footer("Example:\n  roomcast contact-sheet docs/images/scenes --seed 7");
  command->callback([folder, options, &chosen] {
    chosen = [folder, options] {
      return finish("contact-sheet", run_contact_sheet(*folder, *options));
    };
  });
}

}  // namespace roomcast::cli
