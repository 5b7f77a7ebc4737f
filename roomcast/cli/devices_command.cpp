// SPDX-License-Identifier: Apache-2.0
// roomcast devices: lists the connected cameras and their options, and explains why one cannot be
// opened; and the microphones.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/cli/command.h"
#include "roomcast/cli/print.h"
#include "roomcast/sound/microphone_source.h"
#include "roomcast/source/camera/usb_device.h"
#include "roomcast/source/drivers/camera_kinds.h"

namespace roomcast::cli {
namespace {

/// One row of the list.
struct Device {
  std::string spec, model, serial;
  std::optional<std::string> obstacle;
  source::CameraAbilities abilities;
};

/// One driver and the cameras found by it.
struct Kind {
  const source::CameraKind* kind = nullptr;
  std::string library;
  std::optional<std::string> problem;  // with the library itself
  std::vector<Device> devices;
};

std::string missing_library(const source::CameraKind& kind) {
  return fmt::format("roomcast was built without {}", kind.library);
}

std::optional<std::string> sentence_of(const std::optional<Error>& error) {
  return error ? std::optional(error->message) : std::nullopt;
}

Kind look_at(const source::CameraKind& kind) {
  Kind found{&kind, std::string(kind.library), std::nullopt, {}};
  if (kind.make == nullptr) {
    found.problem = missing_library(kind);
    return found;
  }
  const auto backend = kind.make();
  found.library = backend->library();
  const auto cameras = backend->list();
  if (!cameras) found.problem = cameras.error().message;
  if (!cameras) return found;
  for (const source::CameraInfo& camera : *cameras) {
    const std::string& place = camera.serial.empty() ? camera.place : camera.serial;
    found.devices.push_back({fmt::format("{}:{}", kind.name, place), camera.model, camera.serial,
                             sentence_of(camera.obstacle), backend->abilities()});
  }
  return found;
}

bool has(const Kind& kind, const source::UsbCamera& camera) {
  return std::any_of(kind.devices.begin(), kind.devices.end(), [&](const Device& device) {
    return device.serial.empty() || camera.serial.empty() || device.serial == camera.serial;
  });
}

/// Adds cameras listed by the kernel. The kernel reports more about a camera than its library, and
/// also lists cameras that no built-in library supports.
void add_from_usb(const std::vector<source::UsbCamera>& usb, Kind& kind) {
  for (const source::UsbCamera& camera : usb) {
    if (camera.kind != kind.kind->name) continue;
    const auto sentence = sentence_of(obstacle(camera));
    if (has(kind, camera)) {
      for (Device& device : kind.devices) {
        if (sentence && (device.serial == camera.serial || device.serial.empty()))
          device.obstacle = sentence;
      }
      continue;
    }
    const auto problem = sentence ? sentence : kind.problem;
    kind.devices.push_back({fmt::format("{}:{}", camera.kind, camera.serial),
                            camera.model,
                            camera.serial,
                            problem.value_or("its library does not find it; plug it in again"),
                            {}});
  }
}

std::vector<Kind> run_periodic_tasks() {
  const std::vector<source::UsbCamera> usb = source::usb_cameras();
  std::vector<Kind> kinds;
  for (const source::CameraKind& kind : source::camera_kinds()) {
    kinds.push_back(look_at(kind));
    add_from_usb(usb, kinds.back());
  }
  return kinds;
}

std::string abilities_text(const source::CameraAbilities& abilities) {
  std::string text = "depth, colour";
  if (abilities.lock_exposure) text += ", --lock-exposure";
  if (abilities.lock_white_balance) text += ", --lock-white-balance";
  if (abilities.sync) text += ", --sync";
  if (abilities.trigger_delay) text += ", --trigger-delay-us";
  return text;
}

void print(const std::vector<Kind>& kinds) {
  bool any = false;
  for (const Kind& kind : kinds) {
    for (const Device& device : kind.devices) {
      any = true;
      print_out("{}\n  {}\n", device.spec, device.model);
      if (device.obstacle) {
        print_out("  cannot be opened: {}\n", *device.obstacle);
      } else {
        print_out("  ready: {}\n", abilities_text(device.abilities));
      }
    }
  }
  if (!any) print_out("no camera is plugged in\n");
  for (const auto& [source, description] : sound::known_microphones())
    print_out("{}\n  microphone: {}\n", source, description);
  print_out("\n");
  for (const Kind& kind : kinds) {
    print_out("{:<10} {:<38} {}\n", kind.kind->name, kind.kind->cameras,
              kind.problem ? *kind.problem : kind.library);
  }
}

nlohmann::json json_of(const Device& device) {
  nlohmann::json json = {{"spec", device.spec},
                         {"model", device.model},
                         {"serial", device.serial},
                         {"ready", !device.obstacle},
                         {"can",
                          {{"lock_exposure", device.abilities.lock_exposure},
                           {"lock_white_balance", device.abilities.lock_white_balance},
                           {"sync", device.abilities.sync},
                           {"trigger_delay", device.abilities.trigger_delay}}}};
  if (device.obstacle) json["obstacle"] = *device.obstacle;
  return json;
}

nlohmann::json json_of(const std::vector<Kind>& kinds) {
  nlohmann::json json = {{"devices", nlohmann::json::array()}, {"kinds", nlohmann::json::array()}};
  for (const Kind& kind : kinds) {
    for (const Device& device : kind.devices) json["devices"].push_back(json_of(device));
    nlohmann::json row = {{"kind", kind.kind->name},
                          {"cameras", kind.kind->cameras},
                          {"library", kind.library},
                          {"built_in", kind.kind->make != nullptr}};
    if (kind.problem) row["problem"] = *kind.problem;
    json["kinds"].push_back(std::move(row));
  }
  json["microphones"] = nlohmann::json::array();
  for (const auto& [source, description] : sound::known_microphones())
    json["microphones"].push_back({{"source", source}, {"description", description}});
  return json;
}

Status run_devices(bool as_json) {
  const std::vector<Kind> kinds = run_periodic_tasks();
  if (as_json) {
    print_out("{}\n", json_of(kinds).dump(1));
  } else {
    print(kinds);
  }
  return {};
}

}  // namespace

void add_devices_command(CLI::App& app, Command& chosen) {
  auto as_json = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand(
      "devices", "List cameras, their features, and problems in opening them; and microphones");
  command->add_flag("--json", *as_json, "Print JSON");
  command->footer(
      "Example:\n"
      "  roomcast devices\n"
      "The name above \"ready\" or \"cannot be opened\" is the --source for roomcast sensor,\n"
      "the one above \"microphone\" its --audio.");
  command->callback([as_json, &chosen] {
    chosen = [as_json] { return finish("devices", run_devices(*as_json)); };
  });
}

}  // namespace roomcast::cli
