/// One instance: its server, and all pages that look at it.
#pragma once

#include "bridge/control/roles.h"
#include "bridge/net/doorkeeper.h"
#include "bridge/net/outlet.h"
#include "bridge/paths/resting_view.h"
#include "bridge/room/driver_input.h"
#include "bridge/room/known_server.h"
#include "bridge/room/room_figures.h"
#include "bridge/room/room_requests.h"
#include "bridge/room/room_stream.h"
#include "bridge/room/services.h"

#include "rtcore/platform/sentence.h"

#include <nlohmann/json.hpp>

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace bridge {

struct PageRequest;

/// A page that comes in.
struct Arrival {
    SessionId id = 0;
    std::string name;
    bool mayDrive = false;
    PageView view;
    std::shared_ptr<Outlet> outlet;
    nlohmann::json welcome; ///< is sent first; the room adds the role
};

/// Who is there, who drives, and what all are told of the server. Frames are RoomStream's, commands that
/// pages ask for RoomRequests'. All of it on the thread of the sockets.
class Room {
  public:
    /// `limits` must outlive it.
    Room(std::string instance, const Limits& limits, const StreamOptions& stream,
         const RoomServices& services);
    /// Ends its threads; nothing that they posted does anything afterwards.
    ~Room();
    Room(const Room&) = delete;
    Room& operator=(const Room&) = delete;

    const std::string& instance() const { return instance_; }
    /// Nothing until it was looked for.
    std::optional<ServerLink> server() const { return server_.link; }
    bool hasServer() const { return server_.isThere(); }

    void join(Arrival arrival);
    void leave(SessionId id);

    void text(SessionId id, std::string_view message);
    void binary(SessionId id, std::span<const std::uint8_t> message);
    void ponged(SessionId id, double seconds) { stream_.ponged(id, seconds); }
    void writable(SessionId id) { stream_.writable(id); }
    void tick(); ///< about every 50 ms

    RoomFigures figures() const; ///< for reports

  private:
    struct Session {
        std::shared_ptr<Outlet> outlet;
        TokenBucket own{4, 8}; ///< of requests that the bridge answers itself, a second
        std::string lastStatus;
    };
    Session* find(SessionId id);
    std::optional<SessionId> driver() const { return roles_.driver(); }
    std::string nameOfPerson(SessionId id) const;
    double now() const { return clock_.seconds(); }

    // Events for pages.
    void send(SessionId id, const nlohmann::json& event);
    void sendAll(const nlohmann::json& event);
    void sendServer(SessionId id);
    void sendState(SessionId id, const nlohmann::json& content);
    void sendAsked(SessionId driver, SessionId by);
    void notice(SessionId id, const char* code, const rtcore::Sentence& said);
    void sendStatus();
    nlohmann::json imageEvent() const;
    void tellImage();

    // Who drives.
    void rolesChanged(std::optional<SessionId> before);
    void tellRoles();
    nlohmann::json rolesEvent() const;
    void applyInput(SessionId id, const InputMessage& sent);
    void noteOwnMovement();
    /// False: it is another request.
    bool answerItself(SessionId id, const PageRequest& request);

    // The server.
    RequestLinks requestLinks();
    ServerEvents serverEvents();
    FrameEvents frameEvents();
    RestingView::Links restingLinks();
    void serverChanged(ServerLink link, const rtcore::Sentence& why);
    void statusChanged(const ipc::Status& status);
    void stateChanged(const std::string& report);

    const std::string instance_;
    const Clock& clock_;
    const std::function<void(const std::string&)> note_;
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
    const Post post_; ///< for what does nothing once the room is gone
    std::map<SessionId, Session> sessions_;
    Roles roles_;
    bool rolesUntold_ = false;
    KnownServer server_;
    DriverInput input_;
    double lastStatusSent_ = 0;
    RoomStream stream_;
    RoomRequests requests_;
    RestingView resting_;
    std::string imageSent_; ///< the last event of what is shown
    std::unique_ptr<ServerFrames> frames_;
    std::unique_ptr<ServerCommands> commands_; ///< last: their threads post to this
};

} // namespace bridge
