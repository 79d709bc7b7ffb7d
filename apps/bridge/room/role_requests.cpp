#include "bridge/room/role_requests.h"

#include "bridge/control/plain_name.h"

#include "rtcore/platform/sentence.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

namespace bridge {

namespace {

using nlohmann::json;

std::string wordOf(const json& request) {
    const auto found = request.find("do");
    return found != request.end() && found->is_string() ? found->get<std::string>() : "";
}

RoleAnswer answerIf(bool ok, const char* otherwise) {
    return {ok, ok ? rtcore::Sentence() : rtcore::Sentence(otherwise)};
}

RoleAnswer askToDrive(Roles& roles, SessionId by, double now) {
    switch (roles.ask(by, now)) {
    case Roles::Asked::NotAllowed:
        return {false, rtcore::say("this link is for looking only")};
    case Roles::Asked::Waits:
        return {true, rtcore::say("the driver is asked"), roles.driver()};
    case Roles::Asked::Drives:
        break;
    }
    return {};
}

RoleAnswer handOver(Roles& roles, SessionId by, const json& request, double now) {
    const auto to = request.find("to");
    const bool ok = to != request.end() && to->is_number_unsigned() &&
                    to->get<std::uint64_t>() <= std::numeric_limits<SessionId>::max() &&
                    roles.give(by, to->get<SessionId>(), now);
    return answerIf(ok, rtcore::form("only the driver hands over, to one with a driver's link"));
}

RoleAnswer rename(Roles& roles, SessionId by, const json& request) {
    const auto name = request.find("name");
    const bool ok = name != request.end() && name->is_string();
    if (ok) roles.rename(by, plainName(name->get<std::string>()));
    return answerIf(ok, rtcore::form("'name' is a text"));
}

} // namespace

bool isRoleRequest(const json& request) {
    constexpr std::array<std::string_view, 5> kRoleRequests{"ask", "give", "keep", "release", "name"};
    return std::ranges::find(kRoleRequests, wordOf(request)) != kRoleRequests.end();
}

RoleAnswer doRoleRequest(Roles& roles, SessionId by, const json& request, double now) {
    const std::string word = wordOf(request);
    if (word == "ask") return askToDrive(roles, by, now);
    if (word == "give") return handOver(roles, by, request, now);
    if (word == "name") return rename(roles, by, request);
    const bool ok = word == "keep" ? roles.keep(by) : roles.release(by);
    return answerIf(ok, rtcore::form("only the driver may do that"));
}

} // namespace bridge
