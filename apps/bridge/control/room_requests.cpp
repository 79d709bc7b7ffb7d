// What pages ask for, on its way to the server and back.
#include "bridge/control/room.h"

#include "common/commands/command_lines.h"

#include <algorithm>

namespace bridge {

using nlohmann::json;

namespace {

constexpr double kLongFrame = 5, kWatched = 15; // seconds

std::optional<OwnEdits::Step> stepOf(const PlannedCommand& planned) {
    if (planned.id == app::CommandId::Undo) return OwnEdits::Step::Undo;
    if (planned.id == app::CommandId::Redo) return OwnEdits::Step::Redo;
    if (planned.edits) return OwnEdits::Step::Edit;
    return {};
}

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
    const bool goesOn = edits_.mayGoOn(session.id, facts_.edits(), facts_.undo());
    const PlannedCommand planned =
        planRequest(content, {limits_, facts_.bookmarks(), facts_.lights(), facts_.hasSky(), goesOn});
    if (!planned.anyone && !roles_.drives(session.id))
        throw Refused("only the driver may do that; ask to drive first");
    if (session.requests >= kMostRequests || (planned.anyone && !session.asked.take(nowSeconds())))
        throw Refused("too many requests at once");
    if (server_ && !hasServer()) throw Refused("there is no server");
    checkUndo(session, planned);
    watchEdit(planned);
    if (stepOf(planned)) edits_.sent(facts_.edits());
    if (!planned.anyone) {
        ++moving_;
        noteOwnMovement();
    }
    roles_.touch(session.id, nowSeconds());
    ++session.requests;
    commands_->request(planned.line,
                       [this, alive = std::weak_ptr(alive_), by = session.id, id, planned](ipc::Reply reply) {
                           post_([this, alive, by, id, planned, reply = std::move(reply)] {
                               if (!alive.expired()) answered(by, id, planned, reply);
                           });
                       });
}

void Room::checkUndo(const Session& session, const PlannedCommand& planned) const {
    using app::CommandId;
    const bool isStep = planned.id == CommandId::Undo || planned.id == CommandId::Redo;
    if (isStep && edits_.busy()) throw Refused("the last edit is still under way");
    if (planned.id == CommandId::Undo && !edits_.mayUndo(session.id, facts_.edits(), facts_.undo()))
        throw Refused("the last edit is not yours");
    if (planned.id == CommandId::Redo && !edits_.mayRedo(session.id, facts_.edits(), facts_.redo()))
        throw Refused("there is no edit of yours to make again");
}

void Room::answered(SessionId by, std::uint32_t id, const PlannedCommand& planned, const ipc::Reply& reply) {
    const bool done = reply.status == ipc::ReplyStatus::Done;
    if (!planned.anyone) {
        noteOwnMovement();
        --moving_;
    }
    if (const auto step = stepOf(planned)) edits_.answered(by, *step, done);
    if (!planned.anyone) commands_->refresh();
    Session* const session = find(by);
    if (session == nullptr) return;
    --session->requests;
    answer(*session, id, done, planned.shape == AnswerShape::Text || !done ? reply.text : std::string(),
           done ? answerContent(planned.shape, reply.text) : json::object());
}

// A setting or a size that makes frames last for seconds locks its own author out: what was before comes
// back.

void Room::watchEdit(const PlannedCommand& planned) {
    using app::CommandId;
    if (hasStatus_ && status_.frameSeconds > kLongFrame) return; // it may be the edit that mends that
    std::string name = planned.setting, back;
    if (planned.id == CommandId::Bloom) name = "bloom.radius";
    if (!name.empty()) {
        const std::string before = facts_.settingText(name);
        if (!before.empty()) back = app::command::set(name, before);
    } else if (planned.id == CommandId::Resolution) {
        name = "the size";
        const std::string width = facts_.settingText("width"), height = facts_.settingText("height");
        if (!width.empty() && !height.empty())
            back = app::command::resolution(std::stoi(width), std::stoi(height));
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
        return waits || (lastFrame_ > edit.since && status_.frameSeconds > kLongFrame);
    };
    const bool heavy = std::ranges::any_of(watched_, [&](const auto& each) { return tooLong(each.second); });
    if (heavy) {
        std::string names;
        for (const auto& [name, edit] : watched_) {
            commands_->request(edit.back, [](const ipc::Reply&) {});
            names += (names.empty() ? "" : ", ") + name;
        }
        commands_->refresh();
        for (auto& [id, session] : sessions_)
            notice(session, "heavy", names + " was set back: a frame took more than 5 s");
        watched_.clear();
    }
    std::erase_if(watched_, [&](const auto& each) { return now - each.second.since > kWatched; });
}

} // namespace bridge
