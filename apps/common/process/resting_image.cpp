#include "common/process/resting_image.h"

#include <fmt/core.h>

namespace app {

std::vector<std::string> standByOptions(const std::string& instance, std::int64_t parent) {
    return {"--preview=" + instance, "--stand-by", fmt::format("--parent={}", parent), "--progress=none"};
}

std::vector<std::string> restingPathOptions(int passes, bool byNet) {
    return {"--integrator=path", "--setting=exposure.recorded=automatic",
            fmt::format("--setting=path.filter={}", passes),
            fmt::format("--setting=denoise.net={}", byNet ? "automatic" : "off")};
}

std::string standByRequest(std::uint64_t run, const std::string& scene, const std::string& camera) {
    return fmt::format("{}\t{}\t{}\n", run, scene, camera);
}

} // namespace app
