// SPDX-License-Identifier: Apache-2.0
#include "bench/fanout/child_process.h"

#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>
#include <utility>

#include <arpa/inet.h>
#include <fcntl.h>
#include <malloc.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace roomcast::bench {

namespace {

using namespace std::chrono_literals;
constexpr auto kStartsWithin = 5s;

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

bool listens(std::uint16_t port) {
  const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const sockaddr_in address = loopback(port);
  const bool connected =
      ::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  ::close(fd);
  return connected;
}

[[noreturn]] void become(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int fd : {0, 1, 2}) ::dup2(nowhere, fd);
  ::execv(arguments[0], arguments.data());
  ::_exit(127);
}

/// Ends the child with its parent, also if the parent is killed.
void end_with_parent() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
}

std::uint16_t read_port(int fd) {
  std::uint16_t port = 0;
  pollfd question{.fd = fd, .events = POLLIN, .revents = 0};
  constexpr auto kWait = std::chrono::duration_cast<std::chrono::milliseconds>(kStartsWithin);
  if (::poll(&question, 1, static_cast<int>(kWait.count())) == 1 &&
      ::read(fd, &port, sizeof(port)) != sizeof(port)) {
    port = 0;
  }
  return port;
}

}  // namespace

Result<ChildProcess> ChildProcess::fork_off(const std::function<void(const PortReport&)>& serve) {
  int ends[2];
  if (::pipe(ends) != 0) return Error{ErrorCode::kUnavailable, "no pipe to a child process"};
  const pid_t pid = ::fork();
  if (pid == 0) {
    end_with_parent();
    // Returns memory freed by this program, which would hide the server's allocations.
    ::malloc_trim(0);
    ::close(ends[0]);
    serve([&](std::uint16_t port) {
      if (::write(ends[1], &port, sizeof(port)) != sizeof(port)) ::_exit(1);
    });
    ::_exit(0);
  }
  ::close(ends[1]);
  const std::uint16_t port = pid > 0 ? read_port(ends[0]) : 0;
  ::close(ends[0]);
  ChildProcess child(pid, port);
  if (port == 0) return Error{ErrorCode::kUnavailable, "a server under test did not start"};
  return child;
}

Result<ChildProcess> ChildProcess::execute(const std::vector<std::string>& command,
                                           std::uint16_t port) {
  const pid_t pid = ::fork();
  if (pid == 0) {
    end_with_parent();
    become(command);
  }
  ChildProcess child(pid, port);
  const auto give_up = std::chrono::steady_clock::now() + kStartsWithin;
  while (!listens(port)) {
    if (std::chrono::steady_clock::now() > give_up) {
      return Error{ErrorCode::kUnavailable, "'" + command.front() + "' did not start to listen"};
    }
    std::this_thread::sleep_for(10ms);
  }
  return child;
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)), port_(other.port_) {}

ChildProcess::~ChildProcess() {
  if (pid_ <= 0) return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
}

std::chrono::nanoseconds ChildProcess::cpu_time() const {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(pid_, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return {};
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

std::size_t ChildProcess::resident_bytes() const {
  std::ifstream status("/proc/" + std::to_string(pid_) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("RssAnon:")) return std::strtoull(line.c_str() + 8, nullptr, 10) * 1024;
  }
  return 0;
}

std::uint16_t free_port() {
  const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address = loopback(0);
  socklen_t size = sizeof(address);
  ::bind(fd, reinterpret_cast<const sockaddr*>(&address), size);
  ::getsockname(fd, reinterpret_cast<sockaddr*>(&address), &size);
  ::close(fd);
  return ntohs(address.sin_port);
}

std::string find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::stringstream folders(std::string(path == nullptr ? "" : path) +
                            ":/usr/sbin:/usr/local/sbin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const auto program = std::filesystem::path(folder) / name;
    if (::access(program.c_str(), X_OK) == 0) return program.string();
  }
  return {};
}

}  // namespace roomcast::bench
