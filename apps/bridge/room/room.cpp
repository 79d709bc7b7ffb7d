#include "bridge/room/room.h"

#include "bridge/control/page_sentence.h"
#include "bridge/room/page_request.h"
#include "bridge/room/role_requests.h"

#include "rtcore/platform/sentence.h"

#include <algorithm>
#include <utility>

namespace bridge {

namespace {

using nlohmann::json;
using rtcore::say;

std::string textOfEvent(const json& event) {
    return event.dump(-1, ' ', false, json::error_handler_t::replace);
}

Post whileAlive(const Post& post, const std::shared_ptr<bool>& alive) {
    return [post, alive = std::weak_ptr(alive)](std::function<void()> work) {
        post([alive, work = std::move(work)] {
            if (!alive.expired()) work();
        });
    };
}

} // namespace

Room::Room(std::string instance, const Limits& limits, const StreamOptions& stream,
           const RoomServices& services)
    : instance_(std::move(instance)), clock_(services.clock), note_(services.note),
      post_(whileAlive(services.post, alive_)), input_(limits, clock_),
      stream_(stream, clock_, [this](const FrameDemand& demand) { frames_->setDemand(demand); }),
      requests_(limits, server_, clock_, requestLinks()),
      resting_(services.renderer ? services.renderer() : nullptr, clock_, restingLinks()),
      frames_(services.frames(instance_, stream.rungs(), frameEvents())),
      commands_(services.commands(instance_, input_.lockedKeys().restraint(), serverEvents())) {}

Room::~Room() {
    alive_.reset();
    frames_.reset();
    commands_.reset();
}

RequestLinks Room::requestLinks() {
    return {.ask =
                [this](const std::string& line, std::function<void(const ipc::Reply&)> done) {
                    commands_->request(line, [post = post_, done = std::move(done)](ipc::Reply reply) {
                        post([done, reply = std::move(reply)] { done(reply); });
                    });
                },
            .refresh = [this] { commands_->refresh(); },
            .send = [this](SessionId to, const json& event) { send(to, event); },
            .sendAll = [this](const json& event) { sendAll(event); },
            .moves = [this] { input_.moves(); }};
}

RestingView::Links Room::restingLinks() {
    return {.ask =
                [this](const std::string& line, std::function<void(bool, const std::string&)> done) {
                    commands_->request(line, [post = post_, done = std::move(done)](ipc::Reply reply) {
                        post([done, reply = std::move(reply)] {
                            done(reply.status == ipc::ReplyStatus::Done, reply.text);
                        });
                    });
                },
            .show = [this](const std::optional<PreviewRun>& run) { frames_->setPreview(run); },
            .note = [this](const std::string& line) { note_(instance_ + ": " + line); }};
}

FrameEvents Room::frameEvents() {
    return {.deliver =
                [this, post = post_](FrameSet set) {
                    post([this, set = std::move(set)] {
                        if (stream_.newFrames(set)) server_.lastFrame = now();
                    });
                },
            .failed =
                [this, post = post_](std::string why) {
                    post([this, why = std::move(why)] { note_(instance_ + ": no frames: " + why); });
                },
            .preview =
                [this, post = post_](const PreviewProgress& progress) {
                    post([this, progress] { resting_.progressed(progress); });
                }};
}

ServerEvents Room::serverEvents() {
    ServerEvents events;
    events.server = [this, post = post_](ServerLink link, rtcore::Sentence why) {
        post([this, link, why = std::move(why)] { serverChanged(link, why); });
    };
    events.status = [this, post = post_](const ipc::Status& status) {
        post([this, status] { statusChanged(status); });
    };
    events.state = [this, post = post_](std::string report) {
        post([this, report = std::move(report)] { stateChanged(report); });
    };
    events.messages = [this, post = post_](std::string lines, std::string details) {
        post([this, lines = std::move(lines), details = std::move(details)] {
            for (const json& event : messageEvents(lines, details)) sendAll(event);
        });
    };
    if (input_.lockedKeys().possible())
        events.bindings = [this, post = post_](std::string lines) {
            post([this, lines = std::move(lines)] { input_.lockedKeys().read(lines); });
        };
    return events;
}

Room::Session* Room::find(SessionId id) {
    const auto found = sessions_.find(id);
    return found == sessions_.end() ? nullptr : &found->second;
}

// --- Coming and going ---

void Room::join(Arrival arrival) {
    const SessionId id = arrival.id;
    const std::optional<SessionId> before = driver();
    roles_.join({id, std::move(arrival.name), arrival.mayDrive}, now());
    sessions_[id].outlet = arrival.outlet;
    requests_.join(id);
    stream_.join(id, arrival.view, std::move(arrival.outlet));
    arrival.welcome["role"] = roles_.drives(id) ? "driver" : "viewer";
    send(id, arrival.welcome);
    rolesChanged(before);
    tellRoles();
    if (server_.link) sendServer(id);
    if (server_.facts.known()) sendState(id, server_.facts.all());
    if (server_.hasStatus) send(id, statusJson(server_.status));
    if (resting_.shown()) send(id, imageEvent());
    commands_->setAnyone(true);
    commands_->refresh();
    stream_.serve(id);
}

void Room::leave(SessionId id) {
    if (sessions_.erase(id) == 0) return;
    const std::optional<SessionId> before = driver();
    requests_.leave(id);
    roles_.leave(id);
    rolesChanged(before);
    input_.leave(id);
    if (sessions_.empty()) commands_->setAnyone(false);
    stream_.leave(id);
}

// --- Events for pages ---

void Room::send(SessionId id, const json& event) {
    if (Session* const session = find(id)) session->outlet->sendText(textOfEvent(event));
}

void Room::sendAll(const json& event) {
    const std::string text = textOfEvent(event);
    for (auto& [id, session] : sessions_) session.outlet->sendText(text);
}

void Room::notice(SessionId id, const char* code, const rtcore::Sentence& said) {
    json event{{"event", "notice"}, {"code", code}};
    addSentence(event, said);
    send(id, event);
}

void Room::sendServer(SessionId id) {
    json event{{"event", "server"}, {"state", nameOf(*server_.link)}};
    addSentence(event, server_.why);
    send(id, event);
}

void Room::sendState(SessionId id, const json& content) {
    json event = content;
    event["event"] = "state";
    event["mayUndo"] = requests_.mayUndo(id);
    event["mayRedo"] = requests_.mayRedo(id);
    send(id, event);
}

/// To those that do not have it yet.
void Room::sendStatus() {
    const std::string status = statusJson(server_.status).dump();
    for (auto& [id, session] : sessions_)
        if (std::exchange(session.lastStatus, status) != status) session.outlet->sendText(status);
}

/// How the image was made that is shown.
json Room::imageEvent() const {
    const std::optional<PreviewProgress>& shown = resting_.shown();
    json event{{"event", "image"}, {"paths", shown.has_value()}};
    if (!shown) return event;
    event["samples"] = shown->samples;
    event["part"] = shown->part;
    if (shown->error >= 0) event["error"] = shown->error;
    if (shown->error >= 0) event["largestError"] = shown->largestError;
    return event;
}

void Room::tellImage() {
    const json event = imageEvent();
    std::string text = textOfEvent(event);
    if (text == imageSent_ || (imageSent_.empty() && !resting_.shown())) return;
    imageSent_ = std::move(text);
    sendAll(event);
}

// --- Messages of pages ---

void Room::binary(SessionId id, std::span<const std::uint8_t> bytes) {
    Session* const session = find(id);
    if (session == nullptr) return;
    const std::optional<ClientMessage> message = parseClientMessage(bytes);
    if (!message)
        return session->outlet->close(CloseCode::BadMessage, "a binary message that is none of the protocol");
    if (const auto* ack = std::get_if<AckMessage>(&*message)) {
        stream_.acked(id, *ack);
    } else if (const auto* input = std::get_if<InputMessage>(&*message)) {
        applyInput(id, *input);
    } else if (const auto* view = std::get_if<PageView>(&*message)) {
        stream_.setView(id, *view);
    } else if (const auto* ping = std::get_if<PingMessage>(&*message)) {
        session->outlet->sendBinary(echoHeader(ping->stamp), nullptr);
    }
}

void Room::text(SessionId id, std::string_view message) {
    Session* const session = find(id);
    if (session == nullptr) return;
    const PageRequest request = readPageRequest(message);
    if (request.wrong != nullptr) return session->outlet->close(CloseCode::BadMessage, request.wrong);
    try {
        if (answerItself(id, request)) return;
        requests_.request(id, roles_.drives(id), request.content, request.id);
        roles_.touch(id, now());
    } catch (const Refused& refusal) {
        requests_.answer(id, request.id, false, refusal.sentence());
    }
}

// --- Who drives, and with which keys ---

std::string Room::nameOfPerson(SessionId id) const {
    const auto found = std::ranges::find(roles_.people(), id, &Person::id);
    return found == roles_.people().end() ? "" : found->name;
}

json Room::rolesEvent() const {
    json people = json::array();
    for (const Person& each : roles_.people())
        people.push_back({{"id", each.id}, {"name", each.name}, {"mayDrive", each.mayDrive}});
    json event{{"event", "roles"}, {"driver", nullptr}, {"asking", roles_.asking()}, {"people", people}};
    if (driver()) event["driver"] = *driver();
    return event;
}

void Room::rolesChanged(std::optional<SessionId> before) {
    if (before != driver()) {
        input_.release(before, *commands_);
        if (before) notice(*before, "taken", say(driver() ? "another drives now" : "there is no driver now"));
        if (driver()) notice(*driver(), "handed", say("you drive now"));
    }
    rolesUntold_ = true;
}

/// Many changes at once are told as one.
void Room::tellRoles() {
    if (std::exchange(rolesUntold_, false)) sendAll(rolesEvent());
}

void Room::applyInput(SessionId id, const InputMessage& sent) {
    if (!roles_.drives(id)) return;
    noteOwnMovement(); // by keys that are released now
    const DriverInput::Given given = input_.give(id, sent, *commands_);
    if (given == DriverInput::Given::Nothing) return;
    if (given == DriverInput::Given::Action) {
        roles_.touch(id, now());
        resting_.touched();
    }
    stream_.gaveInput(id, sent.sequence);
}

/// Notes that held keys and requests under way still move the camera.
void Room::noteOwnMovement() {
    if (requests_.moving()) input_.moves();
    input_.goOn(driver());
}

/// Requests of which the server knows nothing: who drives, and the state again.
bool Room::answerItself(SessionId id, const PageRequest& request) {
    const bool wantsState = request.content.value("do", json()) == "state";
    if (!wantsState && !isRoleRequest(request.content)) return false;
    if (!find(id)->own.take(now())) throw Refused("too many requests at once");
    if (wantsState) {
        const bool known = server_.facts.known();
        if (known) sendState(id, server_.facts.all());
        requests_.answer(id, request.id, known, known ? rtcore::Sentence() : say("there is no state yet"));
        return true;
    }
    const std::optional<SessionId> before = driver();
    const RoleAnswer answer = doRoleRequest(roles_, id, request.content, now());
    if (answer.toAsk) sendAsked(*answer.toAsk, id);
    requests_.answer(id, request.id, answer.ok, answer.text);
    if (answer.ok) rolesChanged(before);
    return true;
}

void Room::sendAsked(SessionId driver, SessionId by) {
    const std::string name = nameOfPerson(by);
    json event{{"event", "notice"}, {"code", "asked"}, {"by", by}};
    addSentence(event, name.empty() ? say("A viewer asks to drive") : say("{0} asks to drive", name));
    send(driver, event);
}

// --- The server ---

void Room::serverChanged(ServerLink link, const rtcore::Sentence& why) {
    server_.link = link;
    server_.why = why;
    if (!server_.isThere()) {
        server_.facts.clear();
        server_.hasStatus = false;
        requests_.serverGone();
        input_.serverGone();
        resting_.serverGone();
    } else {
        resting_.serverFound();
    }
    for (const auto& [id, session] : sessions_) sendServer(id);
}

void Room::statusChanged(const ipc::Status& status) {
    noteOwnMovement();
    if (input_.movedByOther(status) && driver())
        notice(*driver(), "elsewhere", say("another client moves the camera"));
    if (status.frameSeconds != server_.status.frameSeconds) server_.lastFrame = now(); // pages may take none
    server_.status = status;
    resting_.statusChanged(status);
    server_.statusAt = now();
    server_.hasStatus = true;
}

void Room::stateChanged(const std::string& report) {
    SceneFacts& facts = server_.facts;
    const bool first = !facts.known();
    const app::ReportedEdit undo = facts.undo(), redo = facts.redo();
    if (!facts.read(report)) return;
    const bool freed = requests_.stateRead();
    const bool same = undo == facts.undo() && redo == facts.redo() && !freed;
    if (facts.changes().empty() && same) return;
    for (const auto& [id, session] : sessions_) sendState(id, first ? facts.all() : facts.changes());
}

// --- Time ---

void Room::tick() {
    constexpr double kStatusEvery = 0.5;
    const std::optional<SessionId> before = driver();
    if (roles_.tick(now())) rolesChanged(before);
    if (driver() && input_.expire(*driver(), *commands_))
        notice(*driver(), "released", say("keys were released: nothing came for half a second"));
    requests_.tick();
    tellRoles();
    const bool statusDue = server_.hasStatus && now() - lastStatusSent_ >= kStatusEvery && !sessions_.empty();
    if (statusDue) stream_.shareLimit();
    stream_.serveWaiting();
    if (statusDue) sendStatus();
    if (statusDue) lastStatusSent_ = now();
    stream_.tellLinks();
    resting_.setWatched(stream_.watched());
    resting_.tick();
    tellImage();
}

RoomFigures Room::figures() const {
    RoomFigures all;
    all.instance = instance_;
    all.state = server_.link ? nameOf(*server_.link) : "unknown";
    all.hasServer = hasServer();
    if (server_.hasStatus) all.server = server_.status;
    stream_.addTo(all);
    for (SessionFigures& each : all.sessions) {
        each.name = nameOfPerson(each.id);
        each.drives = roles_.drives(each.id);
    }
    all.frames = frames_->figures();
    all.commands = commands_->figures();
    return all;
}

} // namespace bridge
