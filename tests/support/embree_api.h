/// Embree 3 or 4, whichever was found, under one set of names. For tests and benchmarks only.
#pragma once

#if RT_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace test {

/// The arguments of every call besides scene and rays. Cheap to make; one for each thread and wave.
/// `coherent`: packets hold rays that take nearly the same way; single rays ignore it.
class EmbreeQuery {
  public:
    explicit EmbreeQuery(bool coherent) {
#if RT_EMBREE == 4
        rtcInitIntersectArguments(&closest_);
        rtcInitOccludedArguments(&any_);
        const RTCRayQueryFlags flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
        closest_.flags = flags;
        any_.flags = flags;
#else
        rtcInitIntersectContext(&context_);
        context_.flags =
            coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
#endif
    }

    // `valid`: -1 for each ray of the packet that counts, else 0; aligned like the packet.
#if RT_EMBREE == 4
    void intersect(RTCScene scene, RTCRayHit& ray) { rtcIntersect1(scene, &ray, &closest_); }
    void intersect(const int* valid, RTCScene scene, RTCRayHit4& rays) {
        rtcIntersect4(valid, scene, &rays, &closest_);
    }
    void intersect(const int* valid, RTCScene scene, RTCRayHit8& rays) {
        rtcIntersect8(valid, scene, &rays, &closest_);
    }
    void intersect(const int* valid, RTCScene scene, RTCRayHit16& rays) {
        rtcIntersect16(valid, scene, &rays, &closest_);
    }
    void occluded(RTCScene scene, RTCRay& ray) { rtcOccluded1(scene, &ray, &any_); }
    void occluded(const int* valid, RTCScene scene, RTCRay4& rays) {
        rtcOccluded4(valid, scene, &rays, &any_);
    }
    void occluded(const int* valid, RTCScene scene, RTCRay8& rays) {
        rtcOccluded8(valid, scene, &rays, &any_);
    }
    void occluded(const int* valid, RTCScene scene, RTCRay16& rays) {
        rtcOccluded16(valid, scene, &rays, &any_);
    }

  private:
    RTCIntersectArguments closest_;
    RTCOccludedArguments any_;
#else
    void intersect(RTCScene scene, RTCRayHit& ray) { rtcIntersect1(scene, &context_, &ray); }
    void intersect(const int* valid, RTCScene scene, RTCRayHit4& rays) {
        rtcIntersect4(valid, scene, &context_, &rays);
    }
    void intersect(const int* valid, RTCScene scene, RTCRayHit8& rays) {
        rtcIntersect8(valid, scene, &context_, &rays);
    }
    void intersect(const int* valid, RTCScene scene, RTCRayHit16& rays) {
        rtcIntersect16(valid, scene, &context_, &rays);
    }
    void occluded(RTCScene scene, RTCRay& ray) { rtcOccluded1(scene, &context_, &ray); }
    void occluded(const int* valid, RTCScene scene, RTCRay4& rays) {
        rtcOccluded4(valid, scene, &context_, &rays);
    }
    void occluded(const int* valid, RTCScene scene, RTCRay8& rays) {
        rtcOccluded8(valid, scene, &context_, &rays);
    }
    void occluded(const int* valid, RTCScene scene, RTCRay16& rays) {
        rtcOccluded16(valid, scene, &context_, &rays);
    }

  private:
    RTCIntersectContext context_;
#endif
};

} // namespace test
