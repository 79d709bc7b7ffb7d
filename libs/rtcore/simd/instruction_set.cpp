#include "rtcore/simd/instruction_set.h"

#include "rtcore/simd/targets.h"

#include <hwy/highway.h>

#include <cstdint>
#include <cstdlib>
#include <stdexcept>

namespace rtcore {

namespace {

std::string nameOf(std::int64_t target) {
    if (target == HWY_AVX3) return "avx512";
    if (target == HWY_AVX2) return "avx2";
    if (target == HWY_SSE4) return "sse4";
    if (HWY_ARCH_ARM && target == HWY_STATIC_TARGET) return "neon";
    return target == HWY_STATIC_TARGET || target == HWY_SCALAR ? "scalar" : "";
}

/// All that this program has code for and this processor can run, fastest first.
std::vector<std::int64_t> targets() {
    static const std::vector<std::int64_t> all = [] {
        // The target that all code is compiled for is there, even if Highway says that NEON needs AES.
        std::int64_t rest = (hwy::SupportedTargets() | HWY_STATIC_TARGET) & HWY_TARGETS;
        std::vector<std::int64_t> found;
        for (; rest != 0; rest &= rest - 1) {
            const std::int64_t target = rest & -rest;
            if (!nameOf(target).empty()) found.push_back(target);
        }
        return found;
    }();
    return all;
}

/// Allows the processor's targets from `first` on: slower ones stay possible, since not every function is
/// compiled for every target.
void allowFrom(std::size_t first) {
    std::int64_t mask = 0;
    for (std::size_t i = first; i < targets().size(); ++i) mask |= targets()[i];
    hwy::SetSupportedTargetsForTest(mask);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

std::size_t& chosen() {
    static std::size_t index = 0;
    return index;
}

} // namespace

std::vector<std::string> instructionSets() {
    std::vector<std::string> names;
    for (const std::int64_t target : targets()) names.push_back(nameOf(target));
    return names;
}

std::string instructionSet() { return instructionSets()[chosen()]; }

bool useInstructionSet(std::string_view name) {
    const std::vector<std::string> names = instructionSets();
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (name != names[i] && !(name == "auto" && i == 0)) continue;
        chosen() = i;
        allowFrom(i);
        return true;
    }
    return false;
}

void useInstructionSetOfEnvironment() {
    const char* const name = std::getenv("RT_ISA");
    if (useInstructionSet(name == nullptr || *name == '\0' ? "auto" : name)) return;
    std::string known;
    for (const std::string& each : instructionSets()) known += " " + each;
    throw std::invalid_argument(std::string("RT_ISA=") + name +
                                " is not an instruction set of this processor; it has:" + known);
}

} // namespace rtcore
