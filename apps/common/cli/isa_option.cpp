#include "common/cli/isa_option.h"

#include "rtcore/settings/plain_text.h"
#include "rtcore/simd/instruction_set.h"

namespace app {

namespace {

std::vector<std::string> suggestIsa(std::span<const std::string> /*words*/) {
    std::vector<std::string> names = rtcore::instructionSets();
    names.emplace_back("auto");
    return names;
}

} // namespace

Option isaOption() {
    return {.name = "isa",
            .value = ValueKind::Text,
            .argument = "NAME",
            .help =
                "use the vector code of one instruction set, of those that --version lists; the results are "
                "the same [auto]",
            .more = "`avx512`, `avx2`, `sse4`, `neon` or `scalar`; `auto` is the fastest. The environment "
                    "variable `RT_ISA` does the same for every program",
            .suggest = suggestIsa};
}

void useIsa(const Arguments& arguments) {
    const auto name = arguments.text("isa");
    if (!name || rtcore::useInstructionSet(*name)) return;
    std::string known;
    for (const std::string& each : rtcore::instructionSets()) known += (known.empty() ? "" : ", ") + each;
    throw UsageError("option '--isa': " + rtcore::inQuotes(*name) +
                     " is no instruction set of this processor; it has " + known);
}

} // namespace app
