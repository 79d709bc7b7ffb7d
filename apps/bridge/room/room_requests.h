/// Requests of a room's pages for commands, on their way to the server and back.
#pragma once

#include "bridge/clock.h"
#include "bridge/control/own_edits.h"
#include "bridge/control/requests.h"
#include "bridge/control/roles.h"
#include "bridge/net/doorkeeper.h"
#include "bridge/room/heavy_edits.h"
#include "bridge/room/known_server.h"

#include "ipc/endpoint/client.h"

#include "rtcore/platform/sentence.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace bridge {

/// The ways that lead out of RoomRequests. None throws but std::bad_alloc.
struct RequestLinks {
    /// A command for the server. The reply is told later on the room's thread, or never once the room is
    /// gone.
    std::function<void(const std::string& line, std::function<void(const ipc::Reply&)> done)> ask;
    std::function<void()> refresh; ///< the server's state is wanted soon
    std::function<void(SessionId to, const nlohmann::json& event)> send;
    std::function<void(const nlohmann::json& event)> sendAll;
    std::function<void()> moves; ///< a request may move the camera now
};

/// One thread.
class RoomRequests {
  public:
    /// All of them must outlive it; `server` is kept true by the room.
    RoomRequests(const Limits& limits, const KnownServer& server, const Clock& clock, RequestLinks links);

    void join(SessionId id) { askers_[id]; }
    /// Answers to what it asked for are dropped from then on.
    void leave(SessionId id) { askers_.erase(id); }

    /// Plans it and sends it on; its answer follows. Throws Refused.
    void request(SessionId by, bool drives, const nlohmann::json& content, std::uint32_t id);
    /// `content`, if any, with `text` and `sentence` (control/page_sentence.h) as they are, or of `said`.
    void answer(SessionId to, std::uint32_t id, bool ok, const rtcore::Sentence& said);

    /// Whether something is under way that may move the camera.
    bool moving() const { return moving_ > 0; }
    bool mayUndo(SessionId by) const { return edits_.mayUndo(by); }
    bool mayRedo(SessionId by) const { return edits_.mayRedo(by); }

    /// The server has told its state. True: what may be undone is known now, and was not before.
    bool stateRead();
    void serverGone();
    /// Takes edits back after which a frame lasts too long.
    void tick();

  private:
    struct Asker {
        int open = 0;               ///< requests without an answer
        TokenBucket asked{50, 100}; ///< of those that viewers may send, a second
        TokenBucket notes{0.05, 3}; ///< that it added without driving, a second
    };
    bool isVisitorsNote(const PlannedCommand& planned, bool drives) const;
    void takeNote(Asker& asker, const PlannedCommand& planned, double now);
    void noteAnswered(SessionId by, bool visits, const ipc::Reply& reply);
    std::string lineOf(SessionId by, const PlannedCommand& planned) const;
    void send(SessionId to, std::uint32_t id, bool ok, nlohmann::json content);
    void answered(SessionId by, std::uint32_t id, const PlannedCommand& planned, bool visits,
                  const ipc::Reply& reply);

    const Limits& limits_;
    const KnownServer& server_;
    const Clock& clock_;
    const RequestLinks links_;
    std::map<SessionId, Asker> askers_;
    TokenBucket notes_{0.2, 10}; ///< that all add who do not drive, a second: a page may come again and again
    std::size_t noteCount_ = 0;  ///< of the scene, as the server told last
    std::size_t notesSent_ = 0;  ///< of visitors, without an answer
    OwnEdits edits_;
    HeavyEdits heavy_;
    int moving_ = 0; ///< requests without an answer that may move the camera
};

} // namespace bridge
