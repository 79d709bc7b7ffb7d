// Who drives in a room, and with which keys.
#include "bridge/control/room.h"

#include "bridge/control/plain_name.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace bridge {

using nlohmann::json;

json Room::rolesEvent() const {
    json people = json::array();
    for (const Person& each : roles_.people())
        people.push_back({{"id", each.id}, {"name", each.name}, {"mayDrive", each.mayDrive}});
    json event{{"event", "roles"}, {"driver", nullptr}, {"asking", roles_.asking()}, {"people", people}};
    if (roles_.driver()) event["driver"] = *roles_.driver();
    return event;
}

void Room::rolesChanged(std::optional<SessionId> before) {
    if (before != roles_.driver()) {
        releaseKeys();
        if (Session* const last = before ? find(*before) : nullptr) {
            last->input.release();
            notice(*last, "taken", roles_.driver() ? "another drives now" : "there is no driver now");
        }
        if (Session* const next = roles_.driver() ? find(*roles_.driver()) : nullptr)
            notice(*next, "handed", "you drive now");
    }
    rolesUntold_ = true;
}

/// Many changes at once are told as one.
void Room::tellRoles() {
    if (std::exchange(rolesUntold_, false)) sendAll(rolesEvent());
}

void Room::releaseKeys() {
    camera_.acted(nowSeconds());
    commands_->setKeys({});
    commands_->dropTurn();
}

void Room::applyInput(Session& session, const InputMessage& sent) {
    if (!roles_.drives(session.id)) return;
    const InputMessage input = lockedKeys_.allowed(sent);
    const double now = nowSeconds();
    noteOwnMovement(); // what is let go of now
    if (!session.input.apply(input, now)) return;
    const bool acts = input.right != 0 || input.up != 0 || !input.held.empty() || !input.taps.empty();
    commands_->setKeys(session.input.held());
    if (!input.taps.empty()) commands_->tap(input.taps);
    constexpr double kDegrees = 1e-3;
    if (input.right != 0 || input.up != 0) commands_->turn(input.right * kDegrees, input.up * kDegrees);
    if (acts) {
        camera_.acted(now);
        roles_.touch(session.id, now);
    }
    constexpr std::size_t kKept = 64;
    session.given.push_back({input.sequence, nowNanoseconds()});
    if (session.given.size() > kKept) session.given.pop_front();
}

bool Room::roleRequest(Session& session, const json& request, std::uint32_t id) {
    const auto found = request.find("do");
    const std::string what = found != request.end() && found->is_string() ? found->get<std::string>() : "";
    const std::optional<SessionId> before = roles_.driver();
    const double now = nowSeconds();
    constexpr std::array<std::string_view, 6> kOwn{"ask", "give", "keep", "release", "name", "state"};
    if (std::ranges::find(kOwn, what) == kOwn.end()) return false;
    if (!session.own.take(now)) throw Refused("too many requests at once");
    bool ok = true;
    std::string text;
    if (what == "ask") {
        const Roles::Asked asked = roles_.ask(session.id, now);
        ok = asked != Roles::Asked::NotAllowed;
        text = ok ? (asked == Roles::Asked::Waits ? "the driver is asked" : "")
                  : "this link is for looking only";
        Session* const driver = asked == Roles::Asked::Waits ? find(*roles_.driver()) : nullptr;
        if (driver != nullptr)
            send(*driver, {{"event", "notice"},
                           {"code", "asked"},
                           {"by", session.id},
                           {"text", (session.name.empty() ? "A viewer" : session.name) + " asks to drive"}});
    } else if (what == "give") {
        const auto to = request.find("to");
        ok = to != request.end() && to->is_number_unsigned() &&
             to->get<std::uint64_t>() <= std::numeric_limits<SessionId>::max() &&
             roles_.give(session.id, to->get<SessionId>(), now);
        if (!ok) text = "only the driver hands over, to one with a driver's link";
    } else if (what == "keep" || what == "release") {
        ok = what == "keep" ? roles_.keep(session.id) : roles_.release(session.id);
        if (!ok) text = "only the driver may do that";
    } else if (what == "name") {
        const auto name = request.find("name");
        ok = name != request.end() && name->is_string();
        if (ok) session.name = plainName(name->get<std::string>());
        if (ok) roles_.rename(session.id, session.name);
        if (!ok) text = "'name' is a text";
    } else { // state
        if (facts_.known()) sendState(session, facts_.all());
        answer(session, id, facts_.known(), facts_.known() ? "" : "there is no state yet", {});
        return true;
    }
    answer(session, id, ok, text, {});
    if (ok) rolesChanged(before);
    return true;
}

} // namespace bridge
