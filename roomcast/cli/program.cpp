// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/program.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <system_error>

#include <boost/system/system_error.hpp>

#include "roomcast/cli/print.h"

namespace roomcast::cli {
namespace {

/// CLI11 only says that a command is missing, not which word it did not know.
std::string unknown_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  const std::string word = argv[1];
  const auto known =
      app.get_subcommands([&](const CLI::App* command) { return command->get_name() == word; });
  return known.empty() ? word : "";
}

/// Memory, threads or descriptors have run out, in any thread: that is a failure with a sentence.
/// All else that nobody catches is a fault of ours, and worth a core file.
[[noreturn]] void end_with_reason() {
  try {
    if (const auto reason = std::current_exception()) std::rethrow_exception(reason);
  } catch (const std::bad_alloc&) {
    (void)write_raw(stderr, "roomcast: this computer gives the program no more memory\n");
    std::_Exit(kFailed);
  } catch (const std::system_error& error) {
    (void)print_err("roomcast: the system refused what the program needs: {}\n", error.what());
    std::_Exit(kFailed);
  } catch (const boost::system::system_error& error) {
    (void)print_err("roomcast: the system refused what the program needs: {}\n", error.what());
    std::_Exit(kFailed);
  } catch (const std::exception& error) {
    (void)print_err("roomcast: internal error: {}\n", error.what());
  }
  std::abort();
}

/// The chosen command, or the command of a group: "bench codec".
bool asks_for_json(const CLI::App& app) {
  const CLI::Option* const json = app.get_option_no_throw("--json");
  if (json != nullptr && json->count() > 0) return true;
  return std::ranges::any_of(app.get_subcommands(),
                             [](const CLI::App* command) { return asks_for_json(*command); });
}

/// The same of a command line that is wrong.
bool says_json(int argc, char** argv) {
  return std::any_of(argv, argv + argc,
                     [](const char* word) { return word == std::string_view("--json"); });
}

int run_command(int argc, char** argv, std::span<const AddCommand> commands,
                const std::string& version) {
  CLI::App app("roomcast: walk around live in a remote room.", "roomcast");
  app.set_version_flag("--version", version);
  app.require_subcommand(1);
  Command chosen;
  for (const AddCommand add : commands) add(app, chosen);
  const auto named = app.get_subcommands([](const CLI::App*) { return true; });
  if (named.size() == 1 || named.front()->get_name() == "demo") {
    app.footer("Example: roomcast demo");
  } else {
    app.footer("Example: roomcast " + named.front()->get_name() + " --help");
  }
  if (const auto word = unknown_command(app, argc, argv); !word.empty()) {
    const Error unknown =
        invalid_argument("there is no command \"" + word + "\" (roomcast --help lists them)");
    return tell(finish("", unknown), says_json(argc, argv));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    const Error wrong =
        invalid_argument(std::string(error.what()) + " (roomcast --help shows how)");
    return tell(finish("", wrong), says_json(argc, argv));
  }
  return tell(chosen(), asks_for_json(app));
}

}  // namespace

int run_program(int argc, char** argv, std::span<const AddCommand> commands,
                const std::string& version) {
  keep_standard_streams();
  std::set_terminate(&end_with_reason);
  std::signal(SIGPIPE, SIG_IGN);  // a closed socket or pipe is an error code to us, not an end
  std::signal(SIGXFSZ, SIG_IGN);  // and so is a file that may not grow any more
  const int code = run_command(argc, argv, commands, version);
  if (wrote_results()) return code;
  (void)print_err("roomcast: not all of the results could be written to stdout\n");
  return code == kDone ? kFailed : code;
}

}  // namespace roomcast::cli
