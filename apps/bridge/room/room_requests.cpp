#include "bridge/room/room_requests.h"

#include "bridge/control/page_sentence.h"
#include "bridge/control/scene_facts.h"

#include "common/cli/command_line.h"
#include "common/commands/command_lines.h"

#include "rtcore/platform/sentence.h"

#include <nlohmann/json.hpp>

#include <utility>

namespace bridge {

namespace {

using nlohmann::json;

constexpr int kMaxRequests = 4;

bool isStep(const PlannedCommand& planned) {
    return planned.edits || planned.id == app::CommandId::Undo || planned.id == app::CommandId::Redo;
}

} // namespace

RoomRequests::RoomRequests(const Limits& limits, const KnownServer& server, const Clock& clock,
                           RequestLinks links)
    : limits_(limits), server_(server), clock_(clock), links_(std::move(links)) {}

void RoomRequests::answer(SessionId to, std::uint32_t id, bool ok, const rtcore::Sentence& said) {
    json content = json::object();
    addSentence(content, said);
    send(to, id, ok, std::move(content));
}

void RoomRequests::send(SessionId to, std::uint32_t id, bool ok, json content) {
    content["event"] = "answer";
    content["id"] = id;
    content["ok"] = ok;
    links_.send(to, content);
}

void RoomRequests::request(SessionId by, bool drives, const json& content, std::uint32_t id) {
    Asker& asker = askers_[by];
    const SceneFacts& facts = server_.facts;
    const double now = clock_.seconds();
    const PlannedCommand planned = planRequest(content, {limits_, facts.bookmarks(), facts.lights(),
                                                         facts.hasSky(), facts.flights(), facts.variants()});
    if (!planned.anyone && !drives) throw Refused("only the driver may do that; ask to drive first");
    if (asker.open >= kMaxRequests || (planned.anyone && !asker.asked.take(now)))
        throw Refused("too many requests at once");
    if (server_.link && !server_.isThere()) throw Refused("there is no server");
    const bool visits = isVisitorsNote(planned, drives);
    const std::string line = visits ? app::command::visitor(planned.line) : lineOf(by, planned);
    if (visits) takeNote(asker, planned, now);
    heavy_.sent(planned, server_, edits_, now);
    if (isStep(planned) && !visits) edits_.sent();
    if (!planned.anyone) {
        ++moving_;
        links_.moves();
    }
    ++asker.open;
    links_.ask(line, [this, by, id, planned, visits](const ipc::Reply& reply) {
        if (planned.note) noteAnswered(by, visits, reply);
        answered(by, id, planned, visits, reply);
    });
}

/// Of a page that does not drive, or may do no more than others.
bool RoomRequests::isVisitorsNote(const PlannedCommand& planned, bool drives) const {
    return planned.note && (!drives || limits_.isLocked("edits"));
}

/// Nothing is taken where it is refused.
void RoomRequests::takeNote(Asker& asker, const PlannedCommand& planned, double now) {
    if (!planned.named) throw Refused("a note needs a name");
    if (noteCount_ + notesSent_ >= kMaxVisitorNotes)
        throw Refused(rtcore::say("there are {0} notes, the most that visitors may have", kMaxVisitorNotes));
    if (!asker.notes.has(now) || !notes_.has(now)) throw Refused("too many notes; wait a minute");
    asker.notes.take(now);
    notes_.take(now);
    ++notesSent_;
}

/// The answer to a note tells how many there are now, before the state does.
void RoomRequests::noteAnswered(SessionId by, bool visits, const ipc::Reply& reply) {
    const bool done = reply.status == ipc::ReplyStatus::Done;
    const auto count = done ? app::parseInteger(reply.text) : std::nullopt;
    if (count && *count >= 0) noteCount_ = static_cast<std::size_t>(*count);
    if (!visits) return;
    --notesSent_;
    if (done) return;
    notes_.giveBack();
    if (const auto asker = askers_.find(by); asker != askers_.end()) asker->second.notes.giveBack();
}

/// The command as the server gets it: in the name of the session, and of its own edits only.
std::string RoomRequests::lineOf(SessionId by, const PlannedCommand& planned) const {
    using app::CommandId;
    const bool undo = planned.id == CommandId::Undo, redo = planned.id == CommandId::Redo;
    if ((undo || redo) && edits_.busy()) throw Refused("the last edit is still under way");
    if (undo && !edits_.mayUndo(by)) throw Refused("the last edit is not yours");
    if (redo && !edits_.mayRedo(by)) throw Refused("there is no edit of yours to make again");
    if (undo) return app::command::undo(edits_.undo());
    if (redo) return app::command::redo(edits_.redo());
    return planned.edits ? app::command::by(static_cast<int>(by), planned.line) : planned.line;
}

void RoomRequests::answered(SessionId by, std::uint32_t id, const PlannedCommand& planned, bool visits,
                            const ipc::Reply& reply) {
    if (!planned.anyone) {
        links_.moves();
        --moving_;
    }
    if (isStep(planned) && !visits) edits_.answered();
    heavy_.answered(planned, clock_.seconds());
    if (!planned.anyone || planned.edits) links_.refresh();
    const auto asker = askers_.find(by);
    if (asker == askers_.end()) return;
    --asker->second.open;
    const bool done = reply.status == ipc::ReplyStatus::Done;
    json content = done ? answerContent(planned.id, reply.text) : json::object();
    const bool told = content.empty();
    addSentence(content, told ? reply.text : "", told ? reply.detail : "");
    send(by, id, done, std::move(content));
}

bool RoomRequests::stateRead() {
    const bool waited = edits_.busy();
    edits_.read(server_.facts.undo(), server_.facts.redo());
    noteCount_ = server_.facts.notes();
    return waited != edits_.busy();
}

void RoomRequests::serverGone() {
    edits_.clear();
    heavy_.clear();
    noteCount_ = 0;
}

void RoomRequests::tick() {
    const double now = clock_.seconds();
    const std::vector<HeavyEdits::Back> heavy = heavy_.takeHeavy(server_, now);
    if (!heavy.empty()) {
        json back = json::array();
        for (const HeavyEdits::Back& each : heavy) {
            links_.ask(each.line, [](const ipc::Reply&) {});
            back.push_back(each.name);
        }
        links_.refresh();
        json notice{{"event", "notice"}, {"code", "heavy"}, {"back", back}};
        addSentence(notice, rtcore::say("undone, since a frame took more than 5 s"));
        links_.sendAll(notice);
    }
    if (moving_ == 0 && server_.status.idle != 0) heavy_.settle(now);
}

} // namespace bridge
