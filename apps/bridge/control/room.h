/// One instance: its server, and all pages that look at it.
#pragma once

#include "bridge/control/camera_watch.h"
#include "bridge/control/caps.h"
#include "bridge/control/command_link.h"
#include "bridge/control/locked_keys.h"
#include "bridge/control/own_edits.h"
#include "bridge/control/requests.h"
#include "bridge/control/roles.h"
#include "bridge/control/room_figures.h"
#include "bridge/control/scene_facts.h"
#include "bridge/control/session.h"
#include "bridge/stream/frame_source.h"
#include "bridge/stream/stream_options.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace bridge {

/// Runs a function on the thread of the sockets, soon; safe from any thread.
using Post = std::function<void(std::function<void()>)>;

/// All of it on the thread of the sockets.
class Room {
  public:
    /// `limits` must outlive it.
    Room(std::string instance, const Limits& limits, const StreamOptions& stream, Post post);
    /// Ends its threads; nothing that they posted does anything afterwards.
    ~Room();
    Room(const Room&) = delete;
    Room& operator=(const Room&) = delete;

    const std::string& instance() const { return instance_; }
    /// Nothing until it was looked for.
    std::optional<ServerState> server() const { return server_; }
    bool hasServer() const { return server_ == ServerState::There || server_ == ServerState::Busy; }

    /// `welcome` is sent first; the room adds the role.
    void join(SessionId id, std::string name, bool mayDrive, const PageView& view,
              std::shared_ptr<Outlet> outlet, nlohmann::json welcome);
    void leave(SessionId id);

    void text(SessionId id, std::string_view message);
    void binary(SessionId id, std::span<const std::uint8_t> message);
    void ponged(SessionId id, double seconds);
    void writable(SessionId id);
    void tick(); ///< about every 50 ms

    RoomFigures figures() const; ///< for reports

  private:
    Session* find(SessionId id);
    void send(Session& session, const nlohmann::json& event);
    void sendAll(const nlohmann::json& event);
    void sendState(Session& session, const nlohmann::json& content);
    void notice(Session& session, const char* code, const std::string& text);

    // Frames.
    void newFrames(FrameSet set);
    /// `fresh`: because a frame came.
    void pump(Session& session, bool fresh = false);
    void updateDemand();
    void measureFrameTime(std::int64_t publishedNs);
    double sentBits(double now) const; ///< to all pages, within the last second or so
    /// The bits per second above which a page must wait: its share, where all pages together are above their
    /// limit; else none.
    double allowance(double now) const;
    void shareLimit();
    static void pingAfter(Session& session, double seconds, double now);

    // Roles and input.
    void rolesChanged(std::optional<SessionId> before);
    void tellRoles();
    nlohmann::json rolesEvent() const;
    void applyInput(Session& session, const InputMessage& sent);
    void releaseKeys();
    bool roleRequest(Session& session, const nlohmann::json& request, std::uint32_t id);

    // Requests.
    void answer(Session& session, std::uint32_t id, bool ok, const std::string& text, nlohmann::json content);
    void request(Session& session, const nlohmann::json& request, std::uint32_t id);
    std::string lineOf(const Session& session, const PlannedCommand& planned) const;
    void answered(SessionId id, std::uint32_t request, const PlannedCommand& planned,
                  const ipc::Reply& reply);
    void watchEdit(const PlannedCommand& planned);
    void guardEdits();

    // The server.
    void serverChanged(ServerState state, const std::string& why);
    void statusChanged(const ipc::Status& status);
    void stateChanged(const std::string& report);
    void watchOthers(const ipc::Status& status);
    void noteOwnMovement();

    const std::string instance_;
    const Limits& limits_;
    const StreamOptions stream_;
    const RungTable rungs_;
    Post post_;
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
    std::map<SessionId, Session> sessions_;
    Roles roles_;
    bool rolesUntold_ = false;
    SceneFacts facts_;
    OwnEdits edits_;
    std::optional<ServerState> server_;
    std::string serverWhy_;
    ipc::Status status_;
    bool hasStatus_ = false;
    CameraWatch camera_;
    LockedKeys lockedKeys_;
    int moving_ = 0; ///< requests without an answer that may move the camera
    FrameSet newest_;
    std::int64_t lastPublishedNs_ = 0;
    double frameTime_ = 1.0 / 30;
    double lastFrame_ = 0, statusAt_ = 0, lastStatusSent_ = 0, lastElsewhere_ = -1e9;
    std::array<std::uint64_t, kRungCount> framesSent_{};
    std::uint64_t partsSent_ = 0, bytesSent_ = 0, skippedBefore_ = 0;
    Histogram publishToSocket_;
    struct WatchedEdit {
        std::string back; ///< the command that brings back what was before
        double since;     ///< the last time that it was made
    };
    std::map<std::string, WatchedEdit> watched_; ///< by what it changed
    std::unique_ptr<FrameSource> frames_;
    std::unique_ptr<CommandLink> commands_; ///< last: their threads post to this
};

/// For messages and reports.
const char* nameOf(ServerState state);

/// The steady clock.
double nowSeconds();
std::int64_t nowNanoseconds();

} // namespace bridge
