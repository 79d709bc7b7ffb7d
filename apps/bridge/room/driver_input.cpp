#include "bridge/room/driver_input.h"

namespace bridge {

DriverInput::Given DriverInput::give(SessionId driver, const InputMessage& sent, ServerCommands& server) {
    const InputMessage input = lockedKeys_.allowed(sent);
    InputState& state = inputs_[driver];
    if (!state.apply(input, clock_.seconds())) return Given::Nothing;
    server.setKeys(state.held());
    if (!input.taps.empty()) server.tap(input.taps);
    constexpr double kDegrees = 1e-3;
    const bool turns = input.right != 0 || input.up != 0;
    if (turns) server.turn(input.right * kDegrees, input.up * kDegrees);
    if (!turns && input.held.empty() && input.taps.empty()) return Given::Rest;
    moves();
    return Given::Action;
}

void DriverInput::release(std::optional<SessionId> last, ServerCommands& server) {
    moves();
    server.setKeys({});
    server.dropTurn();
    if (!last) return;
    if (const auto input = inputs_.find(*last); input != inputs_.end()) input->second.release();
}

bool DriverInput::expire(SessionId driver, ServerCommands& server) {
    const auto input = inputs_.find(driver);
    if (input == inputs_.end() || !input->second.expire(clock_.seconds())) return false;
    release({}, server);
    return true;
}

void DriverInput::goOn(std::optional<SessionId> driver) {
    const auto input = driver ? inputs_.find(*driver) : inputs_.end();
    if (input != inputs_.end() && input->second.held().any()) moves();
}

bool DriverInput::movedByOther(const ipc::Status& status) {
    constexpr double kBetween = 10;
    const double now = clock_.seconds();
    if (!camera_.moved(status, now) || now - lastElsewhere_ < kBetween) return false;
    lastElsewhere_ = now;
    return true;
}

void DriverInput::serverGone() {
    lockedKeys_.forget();
    camera_.restart(clock_.seconds());
}

} // namespace bridge
