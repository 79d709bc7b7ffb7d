#include "bench/rtbench/contenders.h"

#include "rtcore/simd/instruction_set.h"

#ifdef RT_EMBREE
#include "support/embree_tracer.h"
#endif

#include <utility>

namespace rtbench {

namespace {

Contender ours(const rtcore::KdTree& tree, const rtcore::Mesh& mesh) {
    auto tracer = std::make_unique<rtcore::KdRayTracer>(tree, mesh);
    const std::size_t memory = tracer->memory();
    return {"ours", false, std::move(tracer), "ours", memory};
}

} // namespace

#ifdef RT_EMBREE

bool hasEmbree() { return true; }

std::string embreeName() { return test::embreeVersion(); }

std::vector<Contender> makeContenders(const rtcore::KdTree& tree, const rtcore::Mesh& mesh, bool embree) {
    std::vector<Contender> all;
    all.push_back(ours(tree, mesh));
    if (!embree) return all;
    using test::EmbreeCoherence;
    using test::EmbreeQuality;
    const std::string isa = rtcore::instructionSet();
    const int wide = test::embreeWidth(isa);
    const std::string packet = std::to_string(wide);
    for (const auto& [quality, name] : {std::pair{EmbreeQuality::Medium, "default"},
                                        {EmbreeQuality::High, "high"},
                                        {EmbreeQuality::Robust, "robust"}}) {
        const auto scene = test::makeEmbreeScene(mesh, quality, isa);
        const auto add = [&, &quality = quality, &name = name](const std::string& call, int width,
                                                               EmbreeCoherence coherence) {
            all.push_back({name + (" " + call), quality == EmbreeQuality::Robust,
                           std::make_unique<test::EmbreeTracer>(scene, width, coherence),
                           std::string("Embree ") + name, test::embreeMemory(*scene)});
        };
        add("1", 1, EmbreeCoherence::Incoherent);
        add(packet + " coherent", wide, EmbreeCoherence::Coherent);
        add(packet + " incoherent", wide, EmbreeCoherence::Incoherent);
    }
    return all;
}

std::vector<Contender> makeFrameContenders(const rtcore::KdTree& tree, const rtcore::Mesh& mesh,
                                           bool embree) {
    std::vector<Contender> both;
    both.push_back(ours(tree, mesh));
    if (!embree) return both;
    const std::string isa = rtcore::instructionSet();
    both.push_back(
        {"Embree", true,
         std::make_unique<test::EmbreeTracer>(test::makeEmbreeScene(mesh, test::EmbreeQuality::Robust, isa),
                                              test::embreeWidth(isa), test::EmbreeCoherence::ByKind),
         "Embree robust"});
    return both;
}

#else

bool hasEmbree() { return false; }

std::string embreeName() { return "no Embree"; }

std::vector<Contender> makeContenders(const rtcore::KdTree& tree, const rtcore::Mesh& mesh, bool) {
    std::vector<Contender> all;
    all.push_back(ours(tree, mesh));
    return all;
}

std::vector<Contender> makeFrameContenders(const rtcore::KdTree& tree, const rtcore::Mesh& mesh, bool) {
    return makeContenders(tree, mesh, false);
}

#endif

} // namespace rtbench
