/// A scene of solids with its tree and its tracers.
#pragma once

#include "rtcore/accel/builder.h"
#include "rtcore/render/shown_tracer.h"
#include "support/solids.h"

#include <memory>

namespace test {

struct MeasuredScene {
    explicit MeasuredScene(Solids& solids)
        : scene(solids.scene()), tree(rtcore::buildKdTree(scene.model.mesh, {})),
          surfaces(std::make_shared<const rtcore::KdRayTracer>(tree, scene.model.mesh)) {
        scene.up = {0, 0, 1};
    }
    std::shared_ptr<const rtcore::RayTracer> shown() const { return rtcore::shownTracer(surfaces, scene); }

    rtcore::Scene scene;
    rtcore::KdTree tree;
    std::shared_ptr<const rtcore::KdRayTracer> surfaces;
};

} // namespace test
