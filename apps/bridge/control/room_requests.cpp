// What pages ask for, on its way to the server and back.
#include "bridge/control/room.h"

#include "common/commands/command_lines.h"

#include <algorithm>

namespace bridge {

using nlohmann::json;

namespace {

constexpr double kLongFrame = 5, kSettled = 0.5; // seconds
constexpr const char *kLastEdit = "lastEdit", *kSize = "size";

bool isStep(const PlannedCommand& planned) {
    return planned.edits || planned.id == app::CommandId::Undo || planned.id == app::CommandId::Redo;
}

/// What an edit is known by that may make frames last long; "": it is none.
std::string watchedName(const PlannedCommand& planned) {
    if (planned.id == app::CommandId::Bloom) return "bloom.radius";
    if (planned.id == app::CommandId::Undo || planned.id == app::CommandId::Redo) return kLastEdit;
    return planned.id == app::CommandId::Resolution ? kSize : planned.setting;
}

/// A live frame is quick where the whole one, which follows at rest, is not.
double longestFrame(const ipc::Status& status) { return std::max(status.frameSeconds, status.wholeSeconds); }

} // namespace

void Room::answer(Session& session, std::uint32_t id, bool ok, const std::string& text, json content) {
    if (!content.is_object()) content = json::object();
    content["event"] = "answer";
    content["id"] = id;
    content["ok"] = ok;
    content["text"] = withoutFolders(text);
    send(session, content);
}

void Room::request(Session& session, const json& content, std::uint32_t id) {
    constexpr int kMostRequests = 4;
    const PlannedCommand planned =
        planRequest(content, {limits_, facts_.bookmarks(), facts_.lights(), facts_.hasSky()});
    if (!planned.anyone && !roles_.drives(session.id))
        throw Refused("only the driver may do that; ask to drive first");
    if (session.requests >= kMostRequests || (planned.anyone && !session.asked.take(nowSeconds())))
        throw Refused("too many requests at once");
    if (server_ && !hasServer()) throw Refused("there is no server");
    const std::string line = lineOf(session, planned);
    watchEdit(planned);
    if (isStep(planned)) edits_.sent();
    if (!planned.anyone) {
        ++moving_;
        noteOwnMovement();
    }
    roles_.touch(session.id, nowSeconds());
    ++session.requests;
    commands_->request(line,
                       [this, alive = std::weak_ptr(alive_), by = session.id, id, planned](ipc::Reply reply) {
                           post_([this, alive, by, id, planned, reply = std::move(reply)] {
                               if (!alive.expired()) answered(by, id, planned, reply);
                           });
                       });
}

/// The command as the server gets it: in the name of the session, and of its own edits only.
std::string Room::lineOf(const Session& session, const PlannedCommand& planned) const {
    using app::CommandId;
    const bool undo = planned.id == CommandId::Undo, redo = planned.id == CommandId::Redo;
    if ((undo || redo) && edits_.busy()) throw Refused("the last edit is still under way");
    if (undo && !edits_.mayUndo(session.id)) throw Refused("the last edit is not yours");
    if (redo && !edits_.mayRedo(session.id)) throw Refused("there is no edit of yours to make again");
    if (undo) return app::command::undo(edits_.undo());
    if (redo) return app::command::redo(edits_.redo());
    return planned.edits ? app::command::by(static_cast<int>(session.id), planned.line) : planned.line;
}

void Room::answered(SessionId by, std::uint32_t id, const PlannedCommand& planned, const ipc::Reply& reply) {
    const bool done = reply.status == ipc::ReplyStatus::Done;
    if (!planned.anyone) {
        noteOwnMovement();
        --moving_;
    }
    if (isStep(planned)) edits_.answered();
    if (const auto edit = watched_.find(watchedName(planned)); edit != watched_.end())
        edit->second.since = nowSeconds();
    if (!planned.anyone) commands_->refresh();
    Session* const session = find(by);
    if (session == nullptr) return;
    --session->requests;
    json content = done ? answerContent(planned.id, reply.text) : json::object();
    answer(*session, id, done, content.empty() ? reply.text : std::string(), std::move(content));
}

// A setting or a size that makes frames last for seconds locks its own author out: what was before comes
// back.

void Room::watchEdit(const PlannedCommand& planned) {
    using app::CommandId;
    if (hasStatus_ && longestFrame(status_) > kLongFrame) return; // it may be the edit that mends that
    if (planned.id == CommandId::Undo || planned.id == CommandId::Redo) {
        const std::string back = planned.id == CommandId::Undo ? app::command::redo(edits_.undo())
                                                               : app::command::undo(edits_.redo());
        watched_[kLastEdit] = {back, nowSeconds()};
        return;
    }
    const std::string name = watchedName(planned);
    std::string back;
    if (planned.id == CommandId::Resolution) {
        const std::string width = facts_.settingText("width"), height = facts_.settingText("height");
        if (!width.empty() && !height.empty())
            back = app::command::resolution(std::stoi(width), std::stoi(height));
    } else if (const std::string before = name.empty() ? "" : facts_.settingText(name); !before.empty()) {
        back = app::command::set(name, before);
    }
    if (back.empty()) return;
    // While a slider is drawn, the value from before that.
    watched_.try_emplace(name, WatchedEdit{back, 0}).first->second.since = nowSeconds();
}

void Room::guardEdits() {
    const double now = nowSeconds();
    const auto tooLong = [&](const WatchedEdit& edit) {
        const bool waits = now - edit.since > kLongFrame && lastFrame_ < edit.since && status_.idle == 0 &&
                           status_.paused == 0 && hasStatus_;
        return waits || (statusAt_ > edit.since && longestFrame(status_) > kLongFrame);
    };
    const bool heavy = std::ranges::any_of(watched_, [&](const auto& each) { return tooLong(each.second); });
    if (heavy) {
        json back = json::array();
        for (const auto& [name, edit] : watched_) {
            commands_->request(edit.back, [](const ipc::Reply&) {});
            back.push_back(name);
        }
        commands_->refresh();
        sendAll({{"event", "notice"},
                 {"code", "heavy"},
                 {"back", back},
                 {"text", "undone, since a frame took more than 5 s"}});
        watched_.clear();
    }
    // The whole frame is there, and it was quick.
    std::erase_if(watched_, [&](const auto& each) {
        return moving_ == 0 && status_.idle != 0 && now - each.second.since > kSettled;
    });
}

} // namespace bridge
