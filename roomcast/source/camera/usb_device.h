// SPDX-License-Identifier: Apache-2.0
// Lists the depth cameras on USB from the kernel (sysfs, ABI/stable/sysfs-bus-usb of Linux), and
// finds the reason why one cannot be opened, which the cameras' libraries report only as "error
// -3". Thread-safe (no state).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/result.h"

namespace roomcast::source {

/// A connected depth camera, whether or not roomcast was built for its kind.
struct UsbCamera {
  std::string kind;  // first part of the SPEC that opens it: "freenect"
  std::string model;
  std::string serial;          // as USB reports it; empty if it does not
  std::filesystem::path node;  // device file: /dev/bus/usb/001/005
  bool needs_usb3 = false;
  double mbit_per_s = 0;  // speed of the connection
};

/// Tests pass other folders as `usb_devices` and `nodes`. Empty for a kernel without USB.
[[nodiscard]] std::vector<UsbCamera> usb_cameras(
    const std::filesystem::path& usb_devices = "/sys/bus/usb/devices",
    const std::filesystem::path& nodes = "/dev/bus/usb");

/// Returns kUnavailable, with the remedy, if this user may not open it or its port is too slow;
/// nothing if it should open.
[[nodiscard]] std::optional<Error> obstacle(const UsbCamera& camera);

/// The first obstacle of any camera of this kind.
[[nodiscard]] std::optional<Error> obstacle_of_kind(const std::vector<UsbCamera>& cameras,
                                                    const std::string& kind);

}  // namespace roomcast::source
