/// A mesh in Embree, the peer that the kernels are compared with. For tests and benchmarks only.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/scene/mesh.h"
#include "support/embree_api.h"

#include <sys/types.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace test {

struct EmbreeBuild {
    RTCSceneFlags flags = RTC_SCENE_FLAG_ROBUST;
    RTCBuildQuality quality = RTC_BUILD_QUALITY_HIGH; ///< robust scenes are built as MEDIUM all the same
    int threads = 1;                                  ///< for building; 0 = all
    std::string isa = {}; ///< Embree's name of an instruction set ("avx2"); empty = the best
};

class EmbreeScene {
  public:
    /// The arrays behind `mesh` must outlive it. Throws std::runtime_error when Embree refuses.
    explicit EmbreeScene(const rtcore::Mesh& mesh, const EmbreeBuild& build = {})
        : device_(rtcNewDevice(configuration(build).c_str())) {
        if (device_ == nullptr) throw std::runtime_error("no device of Embree for " + configuration(build));
        rtcSetDeviceMemoryMonitorFunction(device_, count, &bytes_);
        scene_ = rtcNewScene(device_);
        rtcSetSceneFlags(scene_, build.flags);
        rtcSetSceneBuildQuality(scene_, build.quality);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetGeometryBuildQuality(geometry, build.quality);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   mesh.vertices.data(), 0, sizeof(rtcore::Vertex), mesh.vertices.size());
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   mesh.triangles.data(), 0, sizeof(rtcore::Triangle), mesh.triangles.size());
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
        if (rtcGetDeviceError(device_) == RTC_ERROR_NONE) return;
        release();
        throw std::runtime_error("Embree cannot build its tree");
    }
    ~EmbreeScene() { release(); }
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    RTCScene handle() const { return scene_; }

    /// Bytes of its tree; the mesh is shared.
    std::size_t memory() const { return static_cast<std::size_t>(bytes_.load()); }

    bool intersect(const rtcore::Ray& ray, rtcore::Hit& hit) const {
        RTCRayHit query;
        query.ray = convert(ray);
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        EmbreeQuery(false).intersect(scene_, query);
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
        hit = {query.ray.tfar, query.hit.primID, query.hit.u, query.hit.v};
        return true;
    }

    bool occluded(const rtcore::Ray& ray) const {
        RTCRay query = convert(ray);
        EmbreeQuery(false).occluded(scene_, query);
        return query.tfar < 0;
    }

  private:
    static std::string configuration(const EmbreeBuild& build) {
        return "threads=" + std::to_string(build.threads) + (build.isa.empty() ? "" : ",isa=" + build.isa);
    }

    static bool count(void* bytes, ssize_t more, bool /*done*/) {
        *static_cast<std::atomic<std::int64_t>*>(bytes) += more;
        return true;
    }

    void release() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

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

    std::atomic<std::int64_t> bytes_ = 0; ///< from all threads that build
    RTCDevice device_;
    RTCScene scene_ = nullptr;
};

} // namespace test
