/// Who races: our kernels, and Embree in every mode that suits.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/mesh.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace rtbench {

struct Contender {
    std::string name;
    bool robust = false; ///< Embree's robust mode, which leaks less
    std::unique_ptr<const rtcore::RayTracer> tracer;
    std::string tree = {};  ///< "ours", "Embree default": some contenders share one
    std::size_t memory = 0; ///< bytes of that tree, the mesh not counted
};

/// Whether this program was built with Embree, and its name and version.
bool hasEmbree();
std::string embreeName();

/// Ours first. With `embree`: each of Embree's trees - default and high quality, robust - by single rays and
/// by packets, flagged as coherent and as incoherent; held to rtcore::instructionSet(). Tree and mesh must
/// outlive them.
std::vector<Contender> makeContenders(const rtcore::KdTree& tree, const rtcore::Mesh& mesh, bool embree);

/// The two behind the same frame: ours, and with `embree` its robust mode in packets, flagged by the kind of
/// ray.
std::vector<Contender> makeFrameContenders(const rtcore::KdTree& tree, const rtcore::Mesh& mesh, bool embree);

} // namespace rtbench
