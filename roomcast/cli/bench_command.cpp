// SPDX-License-Identifier: Apache-2.0
// roomcast bench: what the README's table is made of.
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/codec_bench.h"
#include "bench/register_bench.h"
#include "roomcast/cli/command.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/geometry/registration.h"
#include "roomcast/source/source_factory.h"

namespace roomcast::cli {
namespace {

struct BenchOptions {
  std::string source = "sim#0";
  int frames = 60;
  bool json = false;
};

Status run_codec(const BenchOptions& options) {
  SourceOptions source_options;
  source_options.pace = Pace::kAsFastAsPossible;
  source_options.loop = false;
  auto source = open_source(options.source, source_options);
  if (!source) return source.error();
  auto registration = Registration::create((*source)->description().calibration);
  if (!registration) return registration.error();

  StatusLine line;
  Status fault;
  CapturedFrame captured;
  RegisteredColor registered;
  int frames = 0;
  const auto feed = [&](DepthImage& depth_mm, ColorImage& color, MaskImage& seen) {
    auto more = (*source)->next(captured, {});
    if (!more) fault = more.error();
    if (!more || !*more) return false;
    line.show(fmt::format("frame {}", ++frames));
    depth_mm = captured.depth_mm;
    if (captured.color.empty()) return true;
    if (auto status = registration->run(captured.depth_mm, captured.color, registered); !status) {
      fault = status;
      return false;
    }
    color = registered.color;
    seen = registered.seen;
    return true;
  };
  bench::CodecBenchOptions bench_options;
  bench_options.fps = (*source)->description().fps;
  bench_options.most_frames = options.frames;
  const auto report = bench::run_codec_bench(options.source, feed, {}, bench_options);
  if (!fault) return fault;
  if (!report) return report.error();
  options.json ? bench::print_json(*report, std::cout) : bench::print_table(*report, std::cout);
  return {};
}

void add_codec_bench(CLI::App& bench, Command& chosen) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = bench.add_subcommand(
      "codec", "Bytes and CPU time of one sensor's frames, beside raw, gzip and RVL");
  command->add_option("source", options->source, "sim[:scene][#n], rig:DIR#s0, tum:DIR")
      ->capture_default_str();
  command->add_option("--frames", options->frames, "At most so many")
      ->check(CLI::Range(1, 10'000))
      ->capture_default_str();
  command->add_flag("--json", options->json, "For scripts");
  command->footer("Example:\n  roomcast bench codec rig:recordings/lab#s0 --json");
  command->callback([options, &chosen] {
    chosen = [options] { return finish("bench codec", run_codec(*options)); };
  });
}

Status run_register(const std::string& source, bool json) {
  std::vector<bench::RegisterBenchInput> inputs = {bench::synthetic_kinect_v2_input()};
  if (!source.empty()) {
    constexpr int kMostFrames = 10;
    auto recorded = bench::recorded_input(source, kMostFrames);
    if (!recorded) return recorded.error();
    inputs.push_back(std::move(*recorded));
  }
  const auto report = bench::run_register_bench(inputs);
  if (!report) return report.error();
  json ? bench::print_json(*report, std::cout) : bench::print_table(*report, std::cout);
  return {};
}

void add_register_bench(CLI::App& bench, Command& chosen) {
  auto source = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  CLI::App* command = bench.add_subcommand(
      "register", "Mapping colour into the depth grid: frames a second of one core");
  command->add_option("source", *source,
                      "Measure this recording too: rig:DIR#s0, tum:DIR (Kinect v2 sizes)");
  command->add_flag("--json", *json, "For scripts");
  command->footer("Example:\n  roomcast bench register rig:recordings/lab#s0 --json");
  command->callback([source, json, &chosen] {
    chosen = [source, json] { return finish("bench register", run_register(*source, *json)); };
  });
}

}  // namespace

void add_bench_command(CLI::App& app, Command& chosen) {
  CLI::App* bench = app.add_subcommand("bench", "Measure parts of roomcast on this machine");
  bench->require_subcommand(1);
  bench->footer("Example: roomcast bench register");
  add_codec_bench(*bench, chosen);
  add_register_bench(*bench, chosen);
}

}  // namespace roomcast::cli
