#include "bridge/control/room.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace bridge {

namespace {

using nlohmann::json;

constexpr double kStatusEvery = 0.5, kPingEvery = 2, kLinkEvery = 1;

} // namespace

std::int64_t nowNanoseconds() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

double nowSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Room::Room(std::string instance, const Limits& limits, const StreamOptions& stream, Post post)
    : instance_(std::move(instance)), limits_(limits), stream_(stream), rungs_(stream.rungs()),
      post_(std::move(post)), lockedKeys_(limits) {
    const auto later = [this](auto work) {
        post_([alive = std::weak_ptr(alive_), work = std::move(work)] {
            if (!alive.expired()) work();
        });
    };
    frames_ = std::make_unique<FrameSource>(instance_, rungs_, [this, later](FrameSet set) {
        later([this, set = std::move(set)] { newFrames(set); });
    });
    CommandLinkEvents events;
    events.server = [this, later](ServerState state, std::string why) {
        later([this, state, why = std::move(why)] { serverChanged(state, why); });
    };
    events.status = [this, later](const ipc::Status& status) {
        later([this, status] { statusChanged(status); });
    };
    events.state = [this, later](std::string report) {
        later([this, report = std::move(report)] { stateChanged(report); });
    };
    events.messages = [this, later](const std::string& lines) {
        later([this, lines] {
            for (const json& event : messageEvents(lines)) sendAll(event);
        });
    };
    if (lockedKeys_.possible())
        events.bindings = [this, later](std::string lines) {
            later([this, lines = std::move(lines)] { lockedKeys_.read(lines); });
        };
    commands_ = std::make_unique<CommandLink>(instance_, lockedKeys_.restraint(), std::move(events));
}

Room::~Room() {
    alive_.reset();
    frames_.reset();
    commands_.reset();
}

Session* Room::find(SessionId id) {
    const auto found = sessions_.find(id);
    return found == sessions_.end() ? nullptr : &found->second;
}

// --- Coming and going ---

void Room::join(SessionId id, std::string name, bool mayDrive, const PageView& view,
                std::shared_ptr<Outlet> outlet, json welcome) {
    const double now = nowSeconds();
    const std::optional<SessionId> before = roles_.driver();
    roles_.join({id, name, mayDrive}, now);
    Session& session = sessions_[id];
    session.id = id;
    session.name = std::move(name);
    session.mayDrive = mayDrive;
    session.outlet = std::move(outlet);
    session.began = session.lastLink = now;
    session.delivery.prefer(stream_.fixedRung());
    session.delivery.setView(view);
    session.delivery.rate().setFrameTime(frameTime_);
    session.outlet->ping(); // the delay of the link, before anything fills it
    session.lastPing = now;
    welcome["role"] = roles_.drives(id) ? "driver" : "viewer";
    send(session, welcome);
    rolesChanged(before);
    tellRoles();
    if (server_) send(session, {{"event", "server"}, {"state", nameOf(*server_)}, {"text", serverWhy_}});
    if (facts_.known()) sendState(session, facts_.all());
    if (hasStatus_) send(session, statusJson(status_));
    commands_->setAnyone(true);
    commands_->refresh();
    pump(session);
    updateDemand();
}

void Room::leave(SessionId id) {
    const auto found = sessions_.find(id);
    if (found == sessions_.end()) return;
    const std::optional<SessionId> before = roles_.driver();
    skippedBefore_ += found->second.delivery.framesSkipped();
    sessions_.erase(found);
    roles_.leave(id);
    rolesChanged(before);
    if (sessions_.empty()) {
        newest_ = FrameSet();
        commands_->setAnyone(false);
    }
    updateDemand();
}

void Room::send(Session& session, const json& event) {
    session.outlet->sendText(event.dump(-1, ' ', false, json::error_handler_t::replace));
}

void Room::sendAll(const json& event) {
    const std::string text = event.dump(-1, ' ', false, json::error_handler_t::replace);
    for (auto& [id, session] : sessions_) session.outlet->sendText(text);
}

void Room::notice(Session& session, const char* code, const std::string& text) {
    send(session, {{"event", "notice"}, {"code", code}, {"text", text}});
}

// --- Messages of pages ---

void Room::binary(SessionId id, std::span<const std::uint8_t> bytes) {
    Session* const session = find(id);
    if (session == nullptr) return;
    const std::optional<ClientMessage> message = parseClientMessage(bytes);
    if (!message)
        return session->outlet->close(CloseCode::BadMessage, "a binary message that is none of the protocol");
    if (const auto* ack = std::get_if<AckMessage>(&*message)) {
        session->delivery.rate().acked(ack->stream, ack->number, ack->part, ack->decodeSeconds, nowSeconds());
    } else if (const auto* input = std::get_if<InputMessage>(&*message)) {
        return applyInput(*session, *input);
    } else if (const auto* view = std::get_if<PageView>(&*message)) {
        session->delivery.setView(*view);
    } else if (const auto* ping = std::get_if<PingMessage>(&*message)) {
        return session->outlet->sendBinary(echoHeader(ping->stamp), nullptr);
    }
    pump(*session);
    updateDemand();
}

void Room::ponged(SessionId id, double seconds) {
    if (Session* const session = find(id)) session->delivery.rate().ponged(seconds, nowSeconds());
}

void Room::writable(SessionId id) {
    Session* const session = find(id);
    if (session == nullptr) return;
    if (const std::int64_t published = std::exchange(session->writing, 0); published != 0)
        publishToSocket_.add(nowSeconds() - 1e-9 * static_cast<double>(published));
    pump(*session);
    updateDemand();
}

void Room::text(SessionId id, std::string_view message) {
    Session* const session = find(id);
    if (session == nullptr) return;
    constexpr int kDepth = 16;
    int depth = 0;
    const auto shallow = [&](int, json::parse_event_t event, json&) {
        if (event == json::parse_event_t::object_start || event == json::parse_event_t::array_start) ++depth;
        if (event == json::parse_event_t::object_end || event == json::parse_event_t::array_end) --depth;
        return depth <= kDepth;
    };
    const json content = json::parse(message, shallow, false);
    if (!content.is_object())
        return session->outlet->close(CloseCode::BadMessage, "a text message is a JSON object");
    const auto number = content.find("id");
    constexpr double kMost = 4294967295.0;
    if (number == content.end() || !number->is_number_integer() || number->get<double>() < 0 ||
        number->get<double>() > kMost)
        return session->outlet->close(CloseCode::BadMessage, "a request has an id from 0 to 4294967295");
    const auto requestId = number->get<std::uint32_t>();
    try {
        if (!roleRequest(*session, content, requestId)) request(*session, content, requestId);
    } catch (const Refused& refusal) {
        answer(*session, requestId, false, refusal.what(), {});
    }
}

// --- The server ---

void Room::serverChanged(ServerState state, const std::string& why) {
    server_ = state;
    serverWhy_ = why;
    if (state == ServerState::Gone || state == ServerState::Refused) {
        facts_.clear();
        edits_.clear();
        watched_.clear();
        lockedKeys_.forget();
        hasStatus_ = false;
        camera_.restart(nowSeconds());
    }
    sendAll({{"event", "server"}, {"state", nameOf(state)}, {"text", why}});
}

void Room::statusChanged(const ipc::Status& status) {
    watchOthers(status);
    if (status.frameSeconds != status_.frameSeconds) lastFrame_ = nowSeconds(); // pages may take none
    status_ = status;
    statusAt_ = nowSeconds();
    hasStatus_ = true;
}

/// A window or a shell moves the camera.
void Room::watchOthers(const ipc::Status& status) {
    constexpr double kBetween = 10;
    const double now = nowSeconds();
    noteOwnMovement();
    if (!camera_.moved(status, now) || now - lastElsewhere_ < kBetween) return;
    lastElsewhere_ = now;
    if (!roles_.driver()) return;
    if (Session* const driver = find(*roles_.driver()))
        notice(*driver, "elsewhere", "another client moves the camera");
}

/// What is held or under way goes on moving it.
void Room::noteOwnMovement() {
    Session* const driver = roles_.driver() ? find(*roles_.driver()) : nullptr;
    if (moving_ > 0 || (driver != nullptr && driver->input.held().any())) camera_.acted(nowSeconds());
}

void Room::stateChanged(const std::string& report) {
    const bool first = !facts_.known();
    const app::ReportedEdit undo = facts_.undo(), redo = facts_.redo();
    if (!facts_.read(report)) return;
    const bool waited = edits_.busy();
    edits_.read(facts_.undo(), facts_.redo());
    const bool same = undo == facts_.undo() && redo == facts_.redo() && waited == edits_.busy();
    if (facts_.changes().empty() && same) return;
    for (auto& [id, session] : sessions_) sendState(session, first ? facts_.all() : facts_.changes());
}

void Room::sendState(Session& session, const json& content) {
    json event = content;
    event["event"] = "state";
    event["mayUndo"] = edits_.mayUndo(session.id);
    event["mayRedo"] = edits_.mayRedo(session.id);
    send(session, event);
}

// --- Time ---

void Room::tick() {
    const double now = nowSeconds();
    const std::optional<SessionId> before = roles_.driver();
    if (roles_.tick(now)) rolesChanged(before);
    Session* const driver = roles_.driver() ? find(*roles_.driver()) : nullptr;
    if (driver != nullptr && driver->input.expire(now)) {
        releaseKeys();
        notice(*driver, "released", "keys were released: nothing came for half a second");
    }
    guardEdits();
    tellRoles();
    const bool statusDue = hasStatus_ && now - lastStatusSent_ >= kStatusEvery && !sessions_.empty();
    std::string status;
    if (statusDue) {
        shareLimit();
        lastStatusSent_ = now;
        status = statusJson(status_).dump();
    }
    if (stream_.mostBits > 0) {
        for (auto& [id, session] : sessions_) pump(session); // what waited for its turn
        updateDemand();
    }
    for (auto& [id, session] : sessions_) {
        if (statusDue && session.lastStatus != status) {
            session.lastStatus = status;
            session.outlet->sendText(status);
        }
        pingAfter(session, stream_.pingSeconds, now);
        const std::uint64_t sent = session.delivery.framesSent();
        if (now - session.lastLink < kLinkEvery) continue;
        const double mbit =
            8e-6 * static_cast<double>(session.bytes - session.lastLinkBytes) / (now - session.lastLink);
        session.lastLink = now;
        session.lastLinkBytes = session.bytes;
        if (sent == session.linkSent) continue;
        session.linkSent = sent;
        const LinkReport link = session.delivery.rate().report();
        const Rung& rung = rungs_[static_cast<std::size_t>(link.rung)];
        constexpr double kMs = 1000;
        send(session, {{"event", "link"},
                       {"rung", link.rung},
                       {"divide", rung.divide},
                       {"quality", rung.quality},
                       {"window", link.window},
                       {"rttMs", link.rtt * kMs},
                       {"baseMs", link.base * kMs},
                       {"queueMs", link.queue * kMs},
                       {"mbit", mbit},
                       {"sent", sent},
                       {"skipped", session.delivery.framesSkipped()}});
        pingAfter(session, kPingEvery, now);
    }
}

void Room::pingAfter(Session& session, double seconds, double now) {
    // Behind a frame a ping would measure that frame.
    if (now - session.lastPing < seconds || session.delivery.rate().inFlight() > 0) return;
    session.lastPing = now;
    session.outlet->ping();
}

} // namespace bridge
