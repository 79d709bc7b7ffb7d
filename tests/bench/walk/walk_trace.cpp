#include "bench/walk/walk_trace.h"

#include "rtcore/gathering/indirect_light.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <sstream>
#include <string>

namespace bench {

namespace {

constexpr const char* kTitle = "# bench_walk's steps: seconds, scale, cut, part of new samples, of learning, "
                               "eye, forward, up, fov, kind, width, aspect";

std::string textOf(rtcore::Vec3 v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

bool read(std::istream& line, rtcore::Vec3& v) { return static_cast<bool>(line >> v.x >> v.y >> v.z); }

bool read(std::istream& line, WalkStep& step) {
    std::uint32_t kind = 0;
    line >> step.seconds >> step.detail.scale >> step.detail.cut >> step.detail.newSamples >>
        step.detail.learning;
    rtcore::Camera& camera = step.camera;
    if (!read(line, camera.eye) || !read(line, camera.forward) || !read(line, camera.up)) return false;
    line >> camera.horizontalFov >> kind >> camera.orthographicWidth >> camera.aspect;
    camera.kind = static_cast<rtcore::CameraKind>(kind);
    const auto isPart = [](double value) { return value > 0 && value <= 1; };
    return line && line.eof() && kind <= 1 && isPart(step.detail.scale) &&
           (step.detail.newSamples == 0 || isPart(step.detail.newSamples)) &&
           isPart(step.detail.learning / rtcore::GatherBudget::kMaxTimes);
}

} // namespace

void writeTrace(const std::filesystem::path& path, const std::vector<WalkStep>& steps) {
    std::string text = std::string(kTitle) + '\n';
    for (const WalkStep& step : steps) {
        const rtcore::Camera& camera = step.camera;
        text += fmt::format("{} {} {:d} {} {} {} {} {} {} {} {} {}\n", step.seconds, step.detail.scale,
                            step.detail.cut, step.detail.newSamples, step.detail.learning, textOf(camera.eye),
                            textOf(camera.forward), textOf(camera.up), camera.horizontalFov,
                            static_cast<std::uint32_t>(camera.kind), camera.orthographicWidth, camera.aspect);
    }
    const std::span<const std::byte> piece = std::as_bytes(std::span(text));
    rtcore::writeFileAtomically(path, std::span(&piece, 1));
}

std::vector<WalkStep> readTrace(const std::filesystem::path& path) {
    std::istringstream text(rtcore::readTextFile(path));
    std::vector<WalkStep> steps;
    int number = 0;
    for (std::string line; std::getline(text, line);) {
        ++number;
        if (line.empty() || line.front() == '#') continue;
        std::istringstream words(line);
        WalkStep step;
        if (!read(words, step)) {
            throw rtcore::FileError(rtcore::FailureKind::BadData, path.string(),
                                    fmt::format("line {} is no step of a walk", number));
        }
        steps.push_back(step);
    }
    if (steps.empty())
        throw rtcore::FileError(rtcore::FailureKind::BadData, path.string(), "it has no steps of a walk");
    return steps;
}

} // namespace bench
