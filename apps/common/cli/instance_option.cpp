#include "common/cli/instance_option.h"

#include <cstdlib>

namespace app {

namespace {

constexpr const char* kVariable = "RT_INSTANCE";

} // namespace

std::optional<std::string> instanceOf(const Arguments& arguments) {
    if (const std::optional<std::string> named = arguments.text("instance")) return named;
    const char* const set = std::getenv(kVariable);
    if (set == nullptr || *set == '\0') return std::nullopt;
    return set;
}

HelpWord instanceEnvironmentNote() {
    return {kVariable, "the server's name where --instance does not say it"};
}

} // namespace app
