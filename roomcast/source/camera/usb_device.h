// SPDX-License-Identifier: Apache-2.0
// Depth cameras on the USB, as the kernel lists them (sysfs, ABI/stable/sysfs-bus-usb of Linux),
// and why one of them cannot be opened: what the cameras' libraries only call "error -3".
// Thread-safe (no state).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/result.h"

namespace roomcast::source {

/// A depth camera that is plugged in, whether roomcast was built for its kind or not.
struct UsbCamera {
  std::string kind;  // of the SPEC that opens it: "freenect"
  std::string model;
  std::string serial;          // as the USB tells it; empty where it does not
  std::filesystem::path node;  // what a program opens: /dev/bus/usb/001/005
  bool needs_usb3 = false;
  double mbit_per_s = 0;  // that it was plugged in with
};

/// `usb_devices` and `nodes` are looked for elsewhere in tests. A kernel without USB has none.
[[nodiscard]] std::vector<UsbCamera> usb_cameras(
    const std::filesystem::path& usb_devices = "/sys/bus/usb/devices",
    const std::filesystem::path& nodes = "/dev/bus/usb");

/// kUnavailable: this user may not open it (what to install), or its port is too slow; nothing when
/// it should open.
[[nodiscard]] std::optional<Error> obstacle(const UsbCamera& camera);

/// The first obstacle of any camera of this kind.
[[nodiscard]] std::optional<Error> obstacle_of_kind(const std::vector<UsbCamera>& cameras,
                                                    const std::string& kind);

}  // namespace roomcast::source
