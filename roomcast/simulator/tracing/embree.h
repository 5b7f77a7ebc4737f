// SPDX-License-Identifier: Apache-2.0
// Embree 3 and 4: the queries that they spell differently. ROOMCAST_EMBREE is the version that the
// build has found. Thread-safe (no state).
#pragma once

#if ROOMCAST_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace roomcast::simulator {

inline void intersect(RTCScene scene, RTCRayHit& query) {
#if ROOMCAST_EMBREE >= 4
  rtcIntersect1(scene, &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &query);
#endif
}

/// `ray.tfar` is below zero if something is in its way.
inline void find_obstacle(RTCScene scene, RTCRay& ray) {
#if ROOMCAST_EMBREE >= 4
  rtcOccluded1(scene, &ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &ray);
#endif
}

}  // namespace roomcast::simulator
