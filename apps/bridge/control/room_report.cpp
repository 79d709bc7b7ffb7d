// What a room tells of itself.
#include "bridge/control/room.h"

namespace bridge {

const char* nameOf(ServerState state) {
    switch (state) {
    case ServerState::There:
        return "there";
    case ServerState::Busy:
        return "busy";
    case ServerState::Gone:
        return "gone";
    case ServerState::Refused:
        break;
    }
    return "refused";
}

RoomFigures Room::figures() const {
    RoomFigures all;
    all.instance = instance_;
    all.state = server_ ? nameOf(*server_) : "unknown";
    all.hasServer = hasServer();
    if (hasStatus_) all.server = status_;
    const double now = nowSeconds();
    all.skipped = skippedBefore_;
    for (const auto& [id, session] : sessions_) {
        const Delivery& delivery = session.delivery;
        all.sessions.push_back({.id = id,
                                .name = session.name,
                                .drives = roles_.drives(id),
                                .link = delivery.rate().report(),
                                .bitsPerSecond = delivery.rate().sentBits(now),
                                .sent = delivery.framesSent(),
                                .skipped = delivery.framesSkipped(),
                                .seconds = now - session.began});
        all.skipped += delivery.framesSkipped();
    }
    all.sent = framesSent_;
    all.parts = partsSent_;
    all.bytes = bytesSent_;
    all.publishToSocket = publishToSocket_;
    all.frames = frames_->figures();
    all.commands = commands_->figures();
    return all;
}

} // namespace bridge
