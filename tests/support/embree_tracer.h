/// Embree behind the interface of the project's own kernels, so that both can be raced and rendered with.
/// For tests and benchmarks only. No header of Embree is needed to use it.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/mesh.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace test {

class EmbreeScene;

enum class EmbreeQuality { Medium, High, Robust };
/// ByKind: as an application would set it, coherent for primary and shadow rays alone.
enum class EmbreeCoherence { Coherent, Incoherent, ByKind };

/// "Embree 3.13.5", as it was compiled against.
std::string embreeVersion();

/// How many rays the widest packets have that Embree traces at once with this instruction set (a name of
/// rtcore::instructionSets()).
int embreeWidth(const std::string& instructionSet);

/// Bytes of its tree; the mesh is shared.
std::size_t embreeMemory(const EmbreeScene& scene);

/// Builds Embree's tree with all cores, held to `instructionSet` (see embreeWidth). `mesh` must outlive it.
std::shared_ptr<const EmbreeScene> makeEmbreeScene(const rtcore::Mesh& mesh, EmbreeQuality quality,
                                                   const std::string& instructionSet);

class EmbreeTracer final : public rtcore::RayTracer {
  public:
    /// `width`: rays a call; 1, or embreeWidth().
    EmbreeTracer(std::shared_ptr<const EmbreeScene> scene, int width, EmbreeCoherence coherence);

    void intersect(rtcore::RayKind kind, const rtcore::RayWave& rays, rtcore::HitWave& hits) const override;
    void occluded(rtcore::RayKind kind, const rtcore::RayWave& rays,
                  std::vector<std::uint8_t>& occluded) const override;
    rtcore::Box3 bounds() const override;

  private:
    bool coherent(rtcore::RayKind kind) const;

    std::shared_ptr<const EmbreeScene> scene_;
    int width_;
    EmbreeCoherence coherence_;
};

} // namespace test
