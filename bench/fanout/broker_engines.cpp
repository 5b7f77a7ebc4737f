// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

#include "bench/fanout/engine.h"

namespace roomcast::bench {

namespace {

/// A broker that is started by a command line and has a protocol of its own.
class Broker : public Engine {
 public:
  explicit Broker(std::string program) : program_(std::move(program)) {}
  std::string name() const override { return program_; }

  Result<RunningEngine> start(const FanoutRoom&) const override {
    const std::string path = find_program(program_);
    if (path.empty()) return Error{ErrorCode::kNotFound, program_ + " is not installed"};
    const std::uint16_t port = free_port();
    auto child = ChildProcess::execute(command(path, port), port);
    if (!child) return child.error();
    return RunningEngine{*std::move(child), protocol(), std::nullopt};
  }

 protected:
  virtual std::vector<std::string> command(const std::string& path, std::uint16_t port) const = 0;
  virtual std::unique_ptr<Protocol> protocol() const = 0;

 private:
  std::string program_;
};

class Nats final : public Broker {
 public:
  Nats() : Broker("nats-server") {}

 private:
  std::vector<std::string> command(const std::string& path, std::uint16_t port) const override {
    return {path, "-a", "127.0.0.1", "-p", std::to_string(port)};
  }
  std::unique_ptr<Protocol> protocol() const override { return nats_protocol(); }
};

class Redis final : public Broker {
 public:
  Redis() : Broker("redis-server") {}

 private:
  /// Storage is off, and slow viewers are not disconnected.
  std::vector<std::string> command(const std::string& path, std::uint16_t port) const override {
    return {path,          "--bind", "127.0.0.1",    "--port", std::to_string(port),
            "--save",      "",       "--appendonly", "no",     "--client-output-buffer-limit",
            "pubsub 0 0 0"};
  }
  std::unique_ptr<Protocol> protocol() const override { return redis_protocol(); }
};

class Mosquitto final : public Broker {
 public:
  Mosquitto() : Broker("mosquitto") {}

 private:
  /// This broker takes its address from a file only.
  std::vector<std::string> command(const std::string& path, std::uint16_t port) const override {
    const auto file = std::filesystem::temp_directory_path() /
                      fmt::format("roomcast-bench-mosquitto-{}.conf", ::getpid());
    std::ofstream(file) << fmt::format("listener {} 127.0.0.1\nallow_anonymous true\n", port);
    return {path, "-c", file.string()};
  }
  std::unique_ptr<Protocol> protocol() const override { return mqtt_protocol(); }
};

}  // namespace

std::unique_ptr<Engine> make_nats() {
  return std::make_unique<Nats>();
}
std::unique_ptr<Engine> make_redis() {
  return std::make_unique<Redis>();
}
std::unique_ptr<Engine> make_mosquitto() {
  return std::make_unique<Mosquitto>();
}

}  // namespace roomcast::bench
