// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/xr/xr_status.h"

#include <cstdlib>

namespace roomcast::viewer::xr {
namespace {

/// The loader answers the same whether the file is missing, is no manifest, or names a library that
/// cannot be loaded.
Error no_runtime() {
  const char* const named = std::getenv("XR_RUNTIME_JSON");
  if (named == nullptr)
    return unavailable(
        "no headset software runs here: start it (SteamVR, Monado, ...), or name its manifest in "
        "XR_RUNTIME_JSON");
  return unavailable("XR_RUNTIME_JSON is \"" + std::string(named) +
                     "\", which is not the manifest of headset software that can be loaded: "
                     "correct it, or unset it");
}

}  // namespace

Status xr_status(XrResult result, const std::string& what) {
  switch (result) {
    case XR_ERROR_SESSION_LOST:
    case XR_ERROR_INSTANCE_LOST:
    case XR_SESSION_LOSS_PENDING:
      return Error{ErrorCode::kClosed, "the headset is lost"};
    case XR_ERROR_RUNTIME_UNAVAILABLE:
      return no_runtime();
    case XR_ERROR_FORM_FACTOR_UNAVAILABLE:
      return Error{ErrorCode::kUnavailable, "no headset is connected: connect it, or wake it up"};
    default:
      break;
  }
  if (XR_SUCCEEDED(result)) return {};
  return Error{ErrorCode::kUnavailable,
               what + " failed (OpenXR code " + std::to_string(static_cast<int>(result)) + ")"};
}

}  // namespace roomcast::viewer::xr
