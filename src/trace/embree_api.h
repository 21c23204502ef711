// SPDX-License-Identifier: Apache-2.0
#pragma once

// The two generations of Embree differ in a header's name and in how a ray query is asked; nothing else here does.

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace parhelion {

inline void intersectClosest(RTCScene scene, RTCRayHit& query) {
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(scene, &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &query);
#endif
}

/// The same for those rays of a packet whose `valid` is -1.
inline void intersectClosest(const int* valid, RTCScene scene, RTCRayHit16& query) {
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect16(valid, scene, &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect16(valid, scene, &context, &query);
#endif
}

}  // namespace parhelion
