#include "bspbuilder/builder_options.h"

#include "common/cli/import_options.h"
#include "common/cli/parent_option.h"
#include "common/cli/threads_option.h"

#include <bit>

namespace bspbuilder {

BuilderOptions readBuilderOptions(const app::Arguments& arguments) {
    BuilderOptions options;
    options.input = arguments.positionals().at(0);
    options.output = arguments.positionals().at(1);
    if (arguments.has("fast")) options.build.method = rtcore::BuildMethod::Fast;
    if (const auto quality = arguments.integer("quality"))
        options.build.fastQuality = static_cast<int>(*quality);
    options.build.threads = app::threadsOf(arguments);
    options.import = app::readImportOptions(arguments);
    options.import.threads = options.build.threads;
    if (arguments.has("verbose")) options.verbosity = Verbosity::Verbose;
    if (arguments.has("very-verbose")) options.verbosity = Verbosity::VeryVerbose;
    if (const auto bands = arguments.integer("histogram")) options.histogramBands = static_cast<int>(*bands);
    if (arguments.has("parent")) options.parent = app::parentOf(arguments);
    options.progress = app::progressStyle(arguments.text("progress").value_or("auto"));
    return options;
}

std::uint32_t buildOptionsHash(const BuilderOptions& options) {
    const rtcore::BuildOptions& build = options.build;
    const bool fast = build.method == rtcore::BuildMethod::Fast;
    const float numbers[] = {fast ? 1.0F : 0.0F,
                             build.traversalCost,
                             build.intersectionCost,
                             build.emptyBonus,
                             static_cast<float>(build.lookAhead),
                             fast ? static_cast<float>(build.fastQuality) : 0,
                             options.import.creaseAngle.value_or(rtcore::kCreaseAngle),
                             options.import.deflection.value_or(rtcore::kDeflection),
                             options.import.flipTextures.value_or(false) ? 1.0F : 0.0F};
    std::uint32_t hash = 2166136261U; // FNV-1a
    for (const float number : numbers) {
        for (std::uint32_t bits = std::bit_cast<std::uint32_t>(number), byte = 0; byte < 4;
             ++byte, bits >>= 8U) {
            hash = (hash ^ (bits & 0xFFU)) * 16777619U;
        }
    }
    const rtcore::PoseChoice pose = options.import.pose.value_or(rtcore::PoseChoice{});
    if (pose != rtcore::PoseChoice{}) {
        for (const char c : poseText(pose)) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    }
    return hash == 0 ? 1 : hash;
}

} // namespace bspbuilder
