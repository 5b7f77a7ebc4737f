// SPDX-License-Identifier: Apache-2.0
// Converts OpenXR's result codes to Status.
#pragma once

#include <string>

#include <openxr/openxr.h>

#include "roomcast/core/result.h"

namespace roomcast::viewer::xr {

/// kClosed if the session or the runtime is lost; kUnavailable for every other failure. `what`: the
/// failed operation, such as "drawing for the headset".
[[nodiscard]] Status xr_status(XrResult result, const std::string& what);

/// Returns from the calling function with xr_status if `call` fails.
#define ROOMCAST_XR_TRY(call, what)                                                       \
  do {                                                                                    \
    if (::roomcast::Status xr_try_status = ::roomcast::viewer::xr::xr_status(call, what); \
        !xr_try_status)                                                                   \
      return std::move(xr_try_status).error();                                            \
  } while (false)

}  // namespace roomcast::viewer::xr
