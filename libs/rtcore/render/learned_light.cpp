#include "rtcore/render/learned_light.h"

namespace rtcore {

/// Records have more passes than those of a view alone: many views show each of them.
bool LearnedLight::learn(const View& view, RenderControl& control) {
    constexpr GatherBudget kBudget{65536, 6144, 6};
    return steps_.learnEnough(view, kBudget, control, light_);
}

} // namespace rtcore
