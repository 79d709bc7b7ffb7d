#include "cui/chosen_instance.h"

#include "common/cli/instance_option.h"

#include "ipc/endpoint/instances.h"

#include <fmt/core.h>

#include <vector>

namespace cui {

namespace {

std::vector<std::string> runningServers() {
    std::vector<std::string> names;
    for (const ipc::Instance& each : ipc::listInstances())
        if (each.running && !each.name.starts_with(app::kPreviewPrefix)) names.push_back(each.name);
    return names;
}

} // namespace

std::string chosenInstance(const app::Arguments& arguments) {
    if (const std::optional<std::string> named = app::instanceOf(arguments)) return *named;
    const std::vector<std::string> running = runningServers();
    if (running.empty()) return "default";
    if (running.size() == 1) return running.front();
    std::string list;
    for (const std::string& name : running) list += (list.empty() ? "'" : ", '") + name + "'";
    throw app::UsageError(fmt::format("{} servers run: {}; choose one by --instance, or RT_INSTANCE in the "
                                      "environment",
                                      running.size(), list));
}

} // namespace cui
