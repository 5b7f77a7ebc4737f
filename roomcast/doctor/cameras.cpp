// SPDX-License-Identifier: Apache-2.0
#include "roomcast/doctor/cameras.h"

#include "roomcast/source/drivers/camera_kinds.h"

namespace roomcast::doctor {
namespace {

Finding judge_camera(const source::UsbCamera& camera, bool is_built_in) {
  const std::string name =
      camera.serial.empty() ? camera.model : camera.model + " (" + camera.serial + ")";
  if (!is_built_in) {
    return {"camera", Verdict::kProblem,
            name + " is plugged in, and this program was built without " + camera.kind + ".",
            "docs/cameras.md says how to build with it."};
  }
  if (const auto reason = source::obstacle(camera))
    return {"camera", Verdict::kProblem, name + " cannot be opened.", reason->message};
  return {
      "camera", Verdict::kOk,
      name + " is plugged in: roomcast sensor --source " + camera.kind + ":" + camera.serial + "."};
}

}  // namespace

std::vector<Finding> judge_cameras(
    const std::vector<source::UsbCamera>& cameras,
    const std::function<bool(const std::string& kind)>& is_built_in) {
  std::vector<Finding> findings;
  for (const source::UsbCamera& camera : cameras)
    findings.push_back(judge_camera(camera, is_built_in(camera.kind)));
  if (findings.empty()) {
    findings.push_back({"camera", Verdict::kNotice, "No depth camera is plugged in.",
                        "Simulated sensors work without one: roomcast demo"});
  }
  return findings;
}

std::vector<Finding> check_cameras() {
  return judge_cameras(source::usb_cameras(), [](const std::string& name) {
    const source::CameraKind* const kind = source::camera_kind(name);
    return kind != nullptr && kind->make != nullptr;
  });
}

}  // namespace roomcast::doctor
