// SPDX-License-Identifier: Apache-2.0
// roomcast board: a printable board for aligning sensors whose views share no surface.
#include <fstream>
#include <memory>
#include <string>

#include "roomcast/alignment/board/board_pdf.h"
#include "roomcast/cli/command.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/cli/print.h"
#include "roomcast/io/file_bytes.h"

namespace roomcast::cli {
namespace {

struct BoardOptions {
  std::string file;
  std::string paper = "a4";
  int tag = 0;
};

Status write_board(const BoardOptions& options) {
  alignment::BoardPage page = options.paper == "a3" ? alignment::kA3 : alignment::kA4;
  page.tag = options.tag;
  const auto pdf = alignment::board_pdf(page);
  if (!pdf) return pdf.error();
  if (auto status = io::write_file(options.file, *pdf); !status) return status;
  print_out("wrote {}: print it at 100 %; the black square has to be {:.1f} mm wide\n",
            options.file, alignment::tag_side_mm(page));
  return {};
}

}  // namespace

void add_board_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<BoardOptions>();
  CLI::App* command = app.add_subcommand(
      "board", "Make a board to print; held into the views of two sensors, it aligns them");
  command->add_option("out", options->file, "PDF file to write")->required();
  command->add_option("--paper", options->paper, "a4, or a3 for larger distances")
      ->check(CLI::IsMember({"a4", "a3"}))
      ->capture_default_str();
  command->add_option("--tag", options->tag, "Number of the AprilTag (family 36h11)")
      ->check(within(0, 586))
      ->capture_default_str();
  command->footer(
      "Example:\n"
      "  roomcast board board.pdf --paper a3\n"
      "Hold the board by its lower edge, still for two seconds, at six places well apart\n"
      "that both sensors see. Turn it to the middle between them, and keep the black\n"
      "square uncovered.");
  command->callback([options, &chosen] {
    chosen = [options] { return finish("board", write_board(*options)); };
  });
}

}  // namespace roomcast::cli
