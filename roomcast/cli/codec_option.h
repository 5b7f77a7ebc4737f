// SPDX-License-Identifier: Apache-2.0
// Command-line options for the coding of a sensor's frames.
#pragma once

#include <map>
#include <string>

#include <CLI/CLI.hpp>

#include "roomcast/cli/named_choice.h"
#include "roomcast/cli/number_option.h"
#include "roomcast/sensor/sender/codec_choice.h"

namespace roomcast::cli {

/// Adds --mbit.
inline void add_target_rate_option(CLI::App& command, sensor::CodecChoice& choice) {
  const auto set = [&choice](const std::string& text) {
    choice.fits_line = text == "auto";
    if (!choice.fits_line) CLI::detail::lexical_cast(text, choice.target_mbit_per_s);
  };
  const auto number = within(sensor::kMinTargetMbit, sensor::kMaxTargetMbit);
  const auto check = [number](std::string text) {
    if (text == "auto") return std::string();
    const std::string fault = number(text);
    return fault.empty() ? fault : fault + ", nor auto";
  };
  command
      .add_option_function<std::string>(
          "--mbit", set,
          "Send so many Mbit/s, never more; auto: as many as the line to the hub carries. Depth "
          "and "
          "colour become coarser or finer, then frames fewer; --color-kbit has no effect (default: "
          "a fixed quality)")
      ->check(CLI::Validator(check, ""))
      ->type_name("auto or 0.1 to 100");
}

/// Adds --codec, --bound-mm, --layers, --color-scale, --color-kbit, --mbit and --small-mbit.
inline void add_codec_options(CLI::App& command, sensor::CodecChoice& choice) {
  const std::map<std::string, codec::DepthMode> modes = {
      {"live", codec::DepthMode::kLive},
      {"near-lossless", codec::DepthMode::kNearLossless},
      {"lossless", codec::DepthMode::kLossless}};
  choose_by_name(command.add_option("--codec", choice.depth_mode,
                                    "Depth coding; live needs the fewest bytes and removes noise"),
                 modes)
      ->default_str("live");
  command
      .add_option("--bound-mm", choice.depth_bound_mm,
                  "With --codec near-lossless: maximum error of a reading in millimetres")
      ->check(within(1, 63))
      ->capture_default_str();
  command
      .add_option("--layers", choice.layers,
                  "Temporal layers; on a slow network only the lowest is sent")
      ->check(within(1, 3))
      ->capture_default_str();
  command
      .add_option(
          "--color-scale", choice.color_scale,
          "2 sends colour at twice the resolution of depth: sharper, but more work and bytes")
      ->check(within(1, 2))
      ->capture_default_str();
  command
      .add_option("--color-kbit", choice.color_kbit_per_s, "Bit rate of the colour stream, kbit/s")
      ->check(within(50, 20'000))
      ->default_str("790, or 1000 with --color-scale 2");
  add_target_rate_option(command, choice);
  const auto rate = within(sensor::kMinTargetMbit, sensor::kMaxTargetMbit);
  command
      .add_option("--small-mbit", choice.small_mbit_per_s,
                  "Bit rate of a small rendition, Mbit/s, which is sent besides while the line of "
                  "some viewer takes no more; with --mbit at most a quarter of that; 0: none")
      ->check(CLI::Validator(
          [rate](std::string text) { return text == "0" ? std::string() : rate(text); }, ""))
      ->type_name("0 or 0.1 to 100")
      ->capture_default_str();
}

}  // namespace roomcast::cli
