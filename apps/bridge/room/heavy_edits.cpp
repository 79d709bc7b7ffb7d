#include "bridge/room/heavy_edits.h"

#include "common/commands/command_lines.h"

#include <algorithm>

namespace bridge {

namespace {

using app::CommandId;

constexpr double kLongFrame = 5, kSettled = 0.5; // seconds
constexpr const char *kLastEdit = "lastEdit", *kSize = "size";

/// The name by which an edit that may make frames last long is watched; "": it is none.
std::string watchedName(const PlannedCommand& planned) {
    if (planned.id == CommandId::Bloom) return "bloom.radius";
    if (planned.id == CommandId::Undo || planned.id == CommandId::Redo) return kLastEdit;
    return planned.id == CommandId::Resolution ? kSize : planned.setting;
}

/// The command that brings back what is there now; "": there is none.
std::string wayBack(const PlannedCommand& planned, const SceneFacts& facts) {
    if (planned.id == CommandId::Resolution) {
        const std::string width = facts.settingText("width"), height = facts.settingText("height");
        if (width.empty() || height.empty()) return "";
        return app::command::resolution(std::stoi(width), std::stoi(height));
    }
    const std::string name = watchedName(planned);
    const std::string before = name.empty() ? "" : facts.settingText(name);
    return before.empty() ? "" : app::command::set(name, before);
}

} // namespace

void HeavyEdits::sent(const PlannedCommand& planned, const KnownServer& server, const OwnEdits& edits,
                      double now) {
    // It may be the edit that mends a frame that lasts long already.
    if (server.hasStatus && server.longestFrame() > kLongFrame) return;
    if (planned.id == CommandId::Undo || planned.id == CommandId::Redo) {
        const bool undo = planned.id == CommandId::Undo;
        watched_[kLastEdit] = {undo ? app::command::redo(edits.undo()) : app::command::undo(edits.redo()),
                               now};
        return;
    }
    const std::string back = wayBack(planned, server.facts);
    if (back.empty()) return;
    // While a slider is drawn, the value from before that.
    watched_.try_emplace(watchedName(planned), Watched{back, 0}).first->second.since = now;
}

void HeavyEdits::answered(const PlannedCommand& planned, double now) {
    if (const auto edit = watched_.find(watchedName(planned)); edit != watched_.end())
        edit->second.since = now;
}

std::vector<HeavyEdits::Back> HeavyEdits::takeHeavy(const KnownServer& server, double now) {
    const auto tooLong = [&](const Watched& edit) {
        const bool waits = now - edit.since > kLongFrame && server.lastFrame < edit.since &&
                           server.status.idle == 0 && server.status.paused == 0 && server.hasStatus;
        return waits || (server.statusAt > edit.since && server.longestFrame() > kLongFrame);
    };
    if (std::ranges::none_of(watched_, [&](const auto& each) { return tooLong(each.second); })) return {};
    std::vector<Back> all;
    for (const auto& [name, edit] : watched_) all.push_back({name, edit.back});
    watched_.clear();
    return all;
}

void HeavyEdits::settle(double now) {
    std::erase_if(watched_, [&](const auto& each) { return now - each.second.since > kSettled; });
}

} // namespace bridge
