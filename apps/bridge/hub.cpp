#include "bridge/hub.h"

#include "bridge/control/setting_value.h"
#include "bridge/report/metrics.h"
#include "bridge/report/status.h"
#include "bridge/visitor.h"

#include "common/cli/help_text.h"
#include "common/process/thread_seconds.h"

#include <fmt/core.h>

#include <algorithm>

namespace bridge {

using nlohmann::json;

Hub::Hub(const BridgeOptions& options, Tokens tokens, const Post& post)
    : options_(options), tokens_(std::move(tokens)), settings_(settingsTableJson(options.limits)),
      began_(nowSeconds()) {
    StreamOptions stream = options.stream;
    stream.mostBits /= static_cast<double>(options.instances.size());
    for (const std::string& name : options.instances)
        rooms_.push_back(std::make_unique<Room>(name, options.limits, stream, post));
    rungs_ = json::array();
    for (const Rung& rung : stream.rungs())
        rungs_.push_back({{"divide", rung.divide}, {"quality", rung.quality}});
}

std::shared_ptr<Receiver> Hub::opened(const std::shared_ptr<Outlet>& outlet) {
    std::erase_if(outlets_, [](const auto& each) { return each.expired(); });
    outlets_.push_back(outlet);
    auto visitor = std::make_shared<Visitor>(*this, outlet);
    came_.push_back(visitor);
    return visitor;
}

std::vector<std::shared_ptr<Visitor>> Hub::newcomers(const std::string& address) const {
    std::vector<std::shared_ptr<Visitor>> all;
    for (const auto& each : came_) {
        const auto visitor = each.lock();
        if (visitor && visitor->isNewcomer() && (address.empty() || visitor->address() == address))
            all.push_back(visitor);
    }
    return all;
}

bool Hub::makeRoom(const std::string& address, double patience) {
    const auto all = newcomers(address);
    const auto first = std::ranges::find_if(
        all, [&, now = nowSeconds()](const auto& each) { return each->givesWay(now, patience); });
    if (first == all.end()) return false;
    (*first)->drop();
    return true;
}

Entry Hub::entry(const std::string& address) {
    constexpr std::size_t kMostNewcomers = 8;
    constexpr double kPatience = 1;
    if (wrong_.shutOut(address, nowSeconds())) return Entry::WrongTokens;
    // All visitors of a proxy have its address; there the oldest newcomer gives way once all places are
    // taken.
    const bool shared = isShared(address) && (options_.origin || address == "unix");
    if (!shared && newcomers(address).size() >= kMostNewcomers && !makeRoom(address, kPatience))
        return Entry::Crowded;
    if (visitors_ >= options_.clients && !makeRoom("", shared ? 0 : kPatience)) return Entry::Full;
    return Entry::Free;
}

void Hub::wrongToken(const std::string& address) {
    wrong_.add(address, nowSeconds());
    refused("token", address);
}

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

Hub::Right Hub::rightOf(std::string_view token) const {
    const bool drives = sameToken(token, tokens_.driver), views = sameToken(token, tokens_.viewer);
    return drives ? Right::Drive : views ? Right::View : Right::None;
}

Room* Hub::room(const std::string& name) {
    if (name.empty()) return rooms_.front().get();
    for (const auto& each : rooms_)
        if (each->instance() == name) return each.get();
    return nullptr;
}

std::string Hub::instanceList() const {
    constexpr std::size_t kMostReason = 120; // of a close
    std::string list;
    for (const auto& each : rooms_)
        if (list.size() + 1 + each->instance().size() <= kMostReason)
            list += (list.empty() ? "" : " ") + each->instance();
    return list;
}

json Hub::welcome(const Room& room, SessionId id, Right right) const {
    constexpr int kMessage = 4096, kRequests = 4;
    constexpr double kMs = 1000;
    return {{"event", "welcome"},
            {"v", 1},
            {"version", app::suiteVersion()},
            {"you", id},
            {"instance", room.instance()},
            {"instances", options_.instances},
            {"mayDrive", right == Right::Drive},
            {"limits",
             {{"maxPixels", options_.limits.maxPixels},
              {"message", kMessage},
              {"requests", kRequests},
              {"heartbeat", InputState::kHeartbeat * kMs}}},
            {"locked", options_.limits.locked},
            {"rungs", rungs_},
            {"settings", settings_}};
}

void Hub::tick() {
    for (const auto& each : rooms_) each->tick();
    noteServers();
    std::erase_if(came_, [](const auto& each) { return each.expired(); });
    for (const auto& each : came_)
        if (const auto visitor = each.lock()) visitor->tick(nowSeconds());
}

void Hub::renew(Tokens tokens) {
    tokens_ = std::move(tokens);
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

std::string Hub::watchLines() { return watch_.lines(figures(), app::threadSeconds(), nowSeconds()); }

json Hub::status() const {
    json instances = json::array();
    for (const RoomFigures& each : figures()) instances.push_back(statusOf(each));
    return {{"version", app::suiteVersion()},
            {"seconds", nowSeconds() - began_},
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
    if (wrong_.shutOut(address, nowSeconds()))
        return {429, "text/plain; charset=utf-8", "too many wrong tokens; wait for a minute\n"};
    if (rightOf(bearer) == Right::None) {
        if (!bearer.empty()) wrongToken(address);
        return {401, "text/plain; charset=utf-8", "a token is needed: Authorization: Bearer TOKEN\n"};
    }
    if (path == "/status")
        return {200, "application/json", status().dump(2, ' ', false, json::error_handler_t::replace) + "\n"};
    return {200, "text/plain; version=0.0.4; charset=utf-8",
            metricsText(figures(), refused_, app::threadSeconds())};
}

} // namespace bridge
