#include "common/mirror/edit_queue.h"

#include "common/commands/command_lines.h"

#include <utility>

namespace app {

std::optional<std::string> EditQueue::edit(const std::string& thing, const std::string& line,
                                           std::optional<bool> goesOn, Clock::time_point now) {
    const bool joins = goesOn.value_or(last_ == thing && now - since_ < kOneGesture);
    last_ = thing;
    since_ = now;
    const auto [found, first] = waiting_.try_emplace(thing);
    if (first) return joins ? command::also(line) : line;
    Waiting& next = found->second;
    // A line that replaces the first one of a step begins that step.
    next.goesOn = next.line ? next.goesOn && joins : joins;
    next.line = line;
    return std::nullopt;
}

std::optional<std::string> EditQueue::answered(const std::string& thing) {
    const auto found = waiting_.find(thing);
    if (found == waiting_.end()) return std::nullopt;
    const std::optional<std::string> line = std::exchange(found->second.line, std::nullopt);
    if (!line) {
        waiting_.erase(found);
        return std::nullopt;
    }
    return found->second.goesOn ? command::also(*line) : line;
}

} // namespace app
