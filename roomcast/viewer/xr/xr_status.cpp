// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/xr/xr_status.h"

namespace roomcast::viewer::xr {

Status xr_status(XrResult result, const std::string& what) {
  switch (result) {
    case XR_ERROR_SESSION_LOST:
    case XR_ERROR_INSTANCE_LOST:
    case XR_SESSION_LOSS_PENDING:
      return Error{ErrorCode::kClosed, "the headset is lost"};
    case XR_ERROR_RUNTIME_UNAVAILABLE:
      return Error{ErrorCode::kUnavailable,
                   "no headset software runs here: start it (SteamVR, Monado, ...), or name its "
                   "manifest in XR_RUNTIME_JSON"};
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
