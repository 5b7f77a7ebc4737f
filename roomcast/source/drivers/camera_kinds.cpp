// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/camera_kinds.h"

#include <algorithm>

#ifdef ROOMCAST_HAS_FREENECT
#include "roomcast/source/drivers/freenect/freenect_backend.h"
#endif
#ifdef ROOMCAST_HAS_OPENNI2
#include "roomcast/source/drivers/openni2/openni2_backend.h"
#endif
#ifdef ROOMCAST_HAS_REALSENSE
#include "roomcast/source/drivers/realsense/realsense_backend.h"
#endif
#ifdef ROOMCAST_HAS_FREENECT2
#include "roomcast/source/drivers/freenect2/freenect2_backend.h"
#endif
#ifdef ROOMCAST_HAS_K4A
#include "roomcast/source/drivers/k4a/k4a_backend.h"
#endif

namespace roomcast::source {

const std::vector<CameraKind>& camera_kinds() {
  static const std::vector<CameraKind> kinds = {
      {"freenect", "Kinect v1", "libfreenect",
#ifdef ROOMCAST_HAS_FREENECT
       freenect_backend
#else
       nullptr
#endif
      },
      {"openni2", "Xtion, PrimeSense, Astra, .oni files", "OpenNI 2",
#ifdef ROOMCAST_HAS_OPENNI2
       openni2_backend
#else
       nullptr
#endif
      },
      {"realsense", "RealSense D400, .bag files", "librealsense2",
#ifdef ROOMCAST_HAS_REALSENSE
       realsense_backend
#else
       nullptr
#endif
      },
      {"freenect2", "Kinect v2", "libfreenect2",
#ifdef ROOMCAST_HAS_FREENECT2
       freenect2_backend
#else
       nullptr
#endif
      },
      {"k4a", "Azure Kinect, Orbbec Femto", "libk4a",
#ifdef ROOMCAST_HAS_K4A
       k4a_backend
#else
       nullptr
#endif
      },
  };
  return kinds;
}

const CameraKind* camera_kind(std::string_view name) {
  const auto& kinds = camera_kinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(),
                                  [&](const CameraKind& kind) { return kind.name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

}  // namespace roomcast::source
