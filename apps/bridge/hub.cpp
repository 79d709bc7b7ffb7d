#include "bridge/hub.h"

#include "bridge/control/caps.h"
#include "bridge/control/setting_value.h"
#include "bridge/report/metrics.h"
#include "bridge/report/status.h"
#include "bridge/visitor.h"

#include "common/cli/help_text.h"
#include "common/process/thread_seconds.h"

#include "rtcore/scene/scene_note.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace bridge {

using nlohmann::json;

Hub::Hub(const BridgeOptions& options, const Tokens& tokens, RoomServices services,
         std::function<void(const std::string& driver)> linkUsed)
    : options_(options), services_(std::move(services)), admission_(tokens), linkUsed_(std::move(linkUsed)),
      tables_({{"settings", settingsTableJson(options.limits)},
               {"labels", settingLabelsJson()},
               {"qualities", qualitiesJson()},
               {"commands", commandTableJson()},
               {"lightKinds", lightKindsJson()}}),
      began_(services_.clock.seconds()) {
    StreamOptions stream = options.stream;
    stream.maxBits /= static_cast<double>(options.instances.size());
    for (const std::string& name : options.instances)
        rooms_.push_back(std::make_unique<Room>(name, options.limits, stream, services_));
    rungs_ = json::array();
    for (const Rung& rung : stream.rungs())
        rungs_.push_back({{"divide", rung.divide}, {"quality", rung.quality}});
}

std::shared_ptr<Receiver> Hub::opened(const std::shared_ptr<Outlet>& outlet) {
    std::erase_if(outlets_, [](const auto& each) { return each.expired(); });
    outlets_.push_back(outlet);
    auto visitor = std::make_shared<Visitor>(*this, outlet, services_.clock);
    came_.push_back(visitor);
    ++visitors_;
    return visitor;
}

/// Those that have not said hello, or leave, hold no place that another one needs.
bool Hub::makeRoom() {
    std::vector<std::shared_ptr<Visitor>> newcomers;
    std::vector<std::string> addresses;
    for (const auto& each : came_) {
        auto visitor = each.lock();
        if (!visitor || !visitor->isNewcomer()) continue;
        addresses.push_back(visitor->address());
        newcomers.push_back(std::move(visitor));
    }
    if (newcomers.empty()) return false;
    newcomers[leastWelcome(addresses)]->drop();
    return true;
}

bool Hub::enters() { return visitors_ < options_.clients || makeRoom(); }

void Hub::refused(const char* reason, const std::string& address) {
    ++refused_[reason];
    note(fmt::format("refused {}: {}", address, reason));
}

void Hub::noteServers() {
    for (const auto& room : rooms_) {
        if (!room->server()) continue;
        const auto [at, first] = noted_.try_emplace(room->instance(), *room->server());
        if (!first && at->second == *room->server()) continue;
        at->second = *room->server();
        note(fmt::format("{}: server {}", room->instance(), nameOf(at->second)));
    }
}

Right Hub::rightOf(std::string_view token) { return admission_.rightOf(token, services_.clock.seconds()); }

Reception::Entrance Hub::enter(const Room& room, std::string_view token, Right right) {
    Admission::Entered entered = admission_.enter(token, services_.clock.seconds());
    if (entered.linkUsed) linkUsed_(admission_.links().driver);
    Entrance entrance{++lastId_, std::move(entered.own), {}};
    entrance.welcome = welcome(room, entrance, right);
    return entrance;
}

void Hub::left(std::string_view own, bool inOrder) {
    admission_.left(own, inOrder, services_.clock.seconds());
}

Room* Hub::room(const std::string& name) {
    if (name.empty()) return rooms_.front().get();
    for (const auto& each : rooms_)
        if (each->instance() == name) return each.get();
    return nullptr;
}

std::string Hub::instanceList() const {
    constexpr std::size_t kMaxReason = 120; // of a close
    std::string list;
    for (const auto& each : rooms_)
        if (list.size() + 1 + each->instance().size() <= kMaxReason)
            list += (list.empty() ? "" : " ") + each->instance();
    return list;
}

json Hub::welcome(const Room& room, const Entrance& entrance, Right right) const {
    constexpr int kRequests = 4;
    constexpr double kMs = 1000;
    json welcome{{"event", "welcome"},
                 {"v", kPageVersion},
                 {"version", app::suiteVersion()},
                 {"you", entrance.id},
                 {"instance", room.instance()},
                 {"instances", options_.instances},
                 {"mayDrive", right == Right::Drive},
                 {"rest", options_.byPaths ? "paths" : "live"},
                 {"limits",
                  {{"maxPixels", options_.limits.maxPixels},
                   {"lights", kMaxLights},
                   {"message", kMaxPageMessage},
                   {"note", rtcore::kMaxNoteText},
                   {"requests", kRequests},
                   {"heartbeat", InputState::kHeartbeat * kMs}}},
                 {"locked", options_.limits.locked},
                 {"visitorNotes", options_.limits.visitorNotes},
                 {"rungs", rungs_}};
    welcome.update(tables_);
    if (!entrance.own.empty()) welcome["token"] = entrance.own;
    return welcome;
}

void Hub::tick() {
    for (const auto& each : rooms_) each->tick();
    noteServers();
    std::erase_if(came_, [](const auto& each) { return each.expired(); });
    for (const auto& each : came_)
        if (const auto visitor = each.lock()) visitor->tick();
}

void Hub::renew(const Tokens& tokens) {
    admission_ = Admission(tokens);
    for (const auto& each : outlets_)
        if (const auto outlet = each.lock()) outlet->close(CloseCode::BadToken, "the links were renewed");
}

void Hub::end() {
    for (const auto& each : outlets_)
        if (const auto outlet = each.lock()) outlet->close(CloseCode::GoingAway, "the bridge ends");
}

std::vector<RoomFigures> Hub::figures() const {
    std::vector<RoomFigures> all;
    for (const auto& each : rooms_) all.push_back(each->figures());
    return all;
}

std::string Hub::watchLines() {
    return watch_.lines(figures(), app::threadSeconds(), services_.clock.seconds());
}

json Hub::status() const {
    json instances = json::array();
    for (const RoomFigures& each : figures()) instances.push_back(statusOf(each));
    return {{"version", app::suiteVersion()},
            {"seconds", services_.clock.seconds() - began_},
            {"clients", visitors_},
            {"refused", refused_},
            {"ioCpuSeconds", app::threadSeconds()},
            {"instances", instances}};
}

HttpAnswer Hub::answer(std::string_view path, std::string_view bearer, const std::string& address) {
    if (path == "/health") {
        bool there = false;
        for (const auto& each : rooms_) there |= each->hasServer();
        return there ? HttpAnswer{200, "text/plain; charset=utf-8", "ok\n"}
                     : HttpAnswer{503, "text/plain; charset=utf-8", "no server\n"};
    }
    if (path != "/status" && path != "/metrics") return {};
    if (const Right right = rightOf(bearer); right != Right::View && right != Right::Drive) {
        if (!bearer.empty()) refused("token", address);
        return {401, "text/plain; charset=utf-8", "a token is needed: Authorization: Bearer TOKEN\n"};
    }
    if (path == "/status")
        return {200, "application/json", status().dump(2, ' ', false, json::error_handler_t::replace) + "\n"};
    return {200, "text/plain; version=0.0.4; charset=utf-8",
            metricsText(figures(), refused_, app::threadSeconds())};
}

} // namespace bridge
