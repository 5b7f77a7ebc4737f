// SPDX-License-Identifier: Apache-2.0
// What `roomcast doctor` finds about depth cameras: those on USB, whether their kind is built in,
// and why one cannot be opened. `roomcast devices` lists more. Thread-safe (no state).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "roomcast/doctor/finding.h"
#include "roomcast/source/camera/usb_device.h"

namespace roomcast::doctor {

/// `is_built_in`: whether this program was built for a kind of camera ("freenect").
[[nodiscard]] std::vector<Finding> judge_cameras(
    const std::vector<source::UsbCamera>& cameras,
    const std::function<bool(const std::string& kind)>& is_built_in);
[[nodiscard]] std::vector<Finding> check_cameras();

}  // namespace roomcast::doctor
