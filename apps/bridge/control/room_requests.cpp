// What pages ask for, on its way to the server and back.
#include "bridge/control/room.h"

#include "common/commands/command_lines.h"

namespace bridge {

using nlohmann::json;

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
    const PlannedCommand planned = planRequest(content, {limits_, facts_.bookmarks(), facts_.lights()});
    if (!planned.anyone && !roles_.drives(session.id))
        throw Refused("only the driver may do that; ask to drive first");
    if (session.requests >= kMostRequests) throw Refused("too many requests at once");
    if (server_ && !hasServer()) throw Refused("there is no server");
    checkUndo(session, planned);
    watchSetting(planned);
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
    if (done && planned.id == app::CommandId::Undo) edits_.undone();
    if (done && planned.id == app::CommandId::Redo) edits_.redone();
    if (done && planned.edits) editor_ = by;
    if (!planned.anyone) commands_->refresh();
    Session* const session = find(by);
    if (session == nullptr) return;
    --session->requests;
    answer(*session, id, done, planned.shape == AnswerShape::Text || !done ? reply.text : std::string(),
           done ? answerContent(planned.shape, reply.text) : json::object());
}

// A setting that makes frames last for seconds locks its own author out: the old value comes back.

void Room::watchSetting(const PlannedCommand& planned) {
    if (planned.setting.empty()) return;
    watched_ = WatchedSetting{planned.setting, facts_.settingText(planned.setting), nowSeconds()};
}

void Room::guardSetting() {
    if (!watched_ || watched_->value.empty()) return;
    constexpr double kLongFrame = 5, kWatched = 15;
    const double now = nowSeconds();
    const bool waits = now - watched_->since > kLongFrame && lastFrame_ < watched_->since &&
                       status_.idle == 0 && status_.paused == 0 && hasStatus_;
    if (waits || (lastFrame_ > watched_->since && status_.frameSeconds > kLongFrame)) {
        const std::string name = watched_->name;
        commands_->request(app::command::set(name, watched_->value), [](const ipc::Reply&) {});
        commands_->refresh();
        for (auto& [id, session] : sessions_)
            notice(session, "heavy", name + " was set back: a frame took more than 5 s");
        watched_.reset();
    } else if (now - watched_->since > kWatched) {
        watched_.reset();
    }
}

} // namespace bridge
