/// A mesh in Embree 3, the peer that the kernels are compared with. For tests and benchmarks only.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/scene/mesh.h"

#include <embree3/rtcore.h>

#include <stdexcept>
#include <string>

namespace test {

class EmbreeScene {
  public:
    /// `mesh` must outlive it. `threads` is for building.
    explicit EmbreeScene(const rtcore::Mesh& mesh, RTCSceneFlags flags = RTC_SCENE_FLAG_ROBUST,
                         RTCBuildQuality quality = RTC_BUILD_QUALITY_HIGH, int threads = 1)
        : device_(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())) {
        if (device_ == nullptr) throw std::runtime_error("no device of Embree");
        scene_ = rtcNewScene(device_);
        rtcSetSceneFlags(scene_, flags);
        rtcSetSceneBuildQuality(scene_, quality);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetGeometryBuildQuality(geometry, quality);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   mesh.vertices.data(), 0, sizeof(rtcore::Vertex), mesh.vertices.size());
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   mesh.triangles.data(), 0, sizeof(rtcore::Triangle), mesh.triangles.size());
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~EmbreeScene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    bool intersect(const rtcore::Ray& ray, rtcore::Hit& hit) const {
        RTCRayHit query;
        query.ray = convert(ray);
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene_, &context, &query);
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
        hit = {query.ray.tfar, query.hit.primID, query.hit.u, query.hit.v};
        return true;
    }

    bool occluded(const rtcore::Ray& ray) const {
        RTCRay query = convert(ray);
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded1(scene_, &context, &query);
        return query.tfar < 0;
    }

  private:
    static RTCRay convert(const rtcore::Ray& ray) {
        RTCRay r;
        r.org_x = ray.origin.x;
        r.org_y = ray.origin.y;
        r.org_z = ray.origin.z;
        r.tnear = ray.tMin;
        r.dir_x = ray.direction.x;
        r.dir_y = ray.direction.y;
        r.dir_z = ray.direction.z;
        r.time = 0;
        r.tfar = ray.tMax;
        r.mask = 0xFFFFFFFFU;
        r.id = 0;
        r.flags = 0;
        return r;
    }

    RTCDevice device_;
    RTCScene scene_ = nullptr;
};

} // namespace test
