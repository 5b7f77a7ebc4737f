// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/child_program.h"

#include <cerrno>
#include <csignal>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace roomcast {
namespace {

void set_stream(posix_spawn_file_actions_t& files, int descriptor, int stream, int mode) {
  if (descriptor >= 0) {
    posix_spawn_file_actions_adddup2(&files, descriptor, stream);
  } else {
    posix_spawn_file_actions_addopen(&files, stream, "/dev/null", mode, 0);
  }
}

}  // namespace

Result<pid_t> start_program(std::vector<std::string> command, const ProgramStreams& streams) {
  std::vector<char*> argv;
  for (std::string& argument : command) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  set_stream(files, streams.input, STDIN_FILENO, O_RDONLY);
  set_stream(files, streams.output, STDOUT_FILENO, O_WRONLY);
  if (!streams.shares_stderr) set_stream(files, -1, STDERR_FILENO, O_WRONLY);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  pid_t pid = 0;
  const int fault = ::posix_spawnp(&pid, argv[0], &files, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (fault != 0) return Error{ErrorCode::kUnavailable, std::generic_category().message(fault)};
  return pid;
}

int wait_for_program(pid_t pid) {
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace roomcast
