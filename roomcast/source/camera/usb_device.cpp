// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/camera/usb_device.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include <unistd.h>

namespace roomcast::source {
namespace {

namespace fs = std::filesystem;

constexpr double kUsb3_mbit_per_s = 5000;
constexpr std::size_t kLongestAttribute = 256;

struct Known {
  std::uint16_t vendor, product;
  const char* kind;
  const char* model;
  bool needs_usb3;
};

/// The USB device of each camera that gives depth. Sources: linux-usb.org's usb.ids and the udev
/// rules of the cameras' own libraries.
constexpr std::array kKnown = {
    Known{0x045e, 0x02ae, "freenect", "Kinect for Xbox 360", false},
    Known{0x045e, 0x02bf, "freenect", "Kinect for Windows v1", false},
    Known{0x1d27, 0x0600, "openni2", "PrimeSense or Asus Xtion", false},
    Known{0x1d27, 0x0601, "openni2", "Asus Xtion Pro Live", false},
    Known{0x1d27, 0x0609, "openni2", "PrimeSense Carmine", false},
    Known{0x2bc5, 0x0401, "openni2", "Orbbec Astra", false},
    Known{0x2bc5, 0x0402, "openni2", "Orbbec Astra S", false},
    Known{0x2bc5, 0x0403, "openni2", "Orbbec Astra Pro", false},
    Known{0x8086, 0x0ad3, "realsense", "RealSense D415", false},
    Known{0x8086, 0x0b07, "realsense", "RealSense D435", false},
    Known{0x8086, 0x0b3a, "realsense", "RealSense D435i", false},
    Known{0x8086, 0x0b5b, "realsense", "RealSense D405", false},
    Known{0x8086, 0x0b5c, "realsense", "RealSense D455", false},
    Known{0x8086, 0x1155, "realsense", "RealSense D421", false},
    Known{0x8086, 0xabcd, "realsense", "RealSense D457", false},
    Known{0x8086, 0x0b64, "realsense", "RealSense L515", true},
    Known{0x045e, 0x02c4, "freenect2", "Kinect for Windows v2", true},
    Known{0x045e, 0x02d8, "freenect2", "Kinect v2", true},
    Known{0x045e, 0x02d9, "freenect2", "Kinect for Xbox One", true},
    Known{0x045e, 0x097c, "k4a", "Azure Kinect", true},
    Known{0x2bc5, 0x0669, "k4a", "Orbbec Femto Bolt", true},
};

/// The first line of a sysfs file; empty if there is none.
std::string attribute(const fs::path& device, const char* name) {
  std::ifstream file(device / name);
  std::string line;
  std::getline(file, line);
  if (line.size() > kLongestAttribute) line.resize(kLongestAttribute);
  return line;
}

long number(const fs::path& device, const char* name, int base) {
  return std::strtol(attribute(device, name).c_str(), nullptr, base);
}

const Known* known_as(long vendor, long product) {
  for (const Known& known : kKnown) {
    if (known.vendor == vendor && known.product == product) return &known;
  }
  return nullptr;
}

fs::path node_of(const fs::path& device, const fs::path& nodes) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "%03ld/%03ld", number(device, "busnum", 10) % 1000,
                number(device, "devnum", 10) % 1000);
  return nodes / name.data();
}

}  // namespace

std::vector<UsbCamera> usb_cameras(const fs::path& usb_devices, const fs::path& nodes) {
  std::vector<UsbCamera> cameras;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(usb_devices, error)) {
    const fs::path& device = entry.path();
    const Known* const known =
        known_as(number(device, "idVendor", 16), number(device, "idProduct", 16));
    if (known == nullptr) continue;
    cameras.push_back({known->kind, known->model, attribute(device, "serial"),
                       node_of(device, nodes), known->needs_usb3,
                       std::strtod(attribute(device, "speed").c_str(), nullptr)});
  }
  return cameras;
}

std::optional<Error> obstacle(const UsbCamera& camera) {
  if (::access(camera.node.c_str(), R_OK | W_OK) != 0) {
    return Error{ErrorCode::kUnavailable,
                 "this user has no permission to open the " + camera.model + " at " +
                     camera.node.string() +
                     ": copy packaging/udev/60-roomcast-cameras.rules to /etc/udev/rules.d, run "
                     "\"udevadm control --reload\" as root and plug the camera in again"};
  }
  if (camera.needs_usb3 && camera.mbit_per_s > 0 && camera.mbit_per_s < kUsb3_mbit_per_s) {
    return Error{ErrorCode::kUnavailable, "the " + camera.model +
                                              " is plugged into a USB 2 port or cable and needs "
                                              "USB 3"};
  }
  return std::nullopt;
}

std::optional<Error> obstacle_of_kind(const std::vector<UsbCamera>& cameras,
                                      const std::string& kind) {
  for (const UsbCamera& camera : cameras) {
    if (camera.kind != kind) continue;
    if (auto found = obstacle(camera)) return found;
  }
  return std::nullopt;
}

}  // namespace roomcast::source
