/// The rooms of all instances, who comes in by which token, and what /status tells. On the thread of the
/// sockets.
#pragma once

#include "bridge/admission.h"
#include "bridge/bridge_options.h"
#include "bridge/control/room.h"
#include "bridge/report/journal.h"
#include "bridge/report/watch.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace bridge {

class Visitor;

class Hub {
  public:
    /// `linkUsed` is told the driver's next link's token.
    Hub(const BridgeOptions& options, const Tokens& tokens, const Post& post,
        std::function<void(const std::string& driver)> linkUsed);

    std::shared_ptr<Receiver> opened(const std::shared_ptr<Outlet>& outlet);
    /// A line for each instance, for a terminal.
    std::string watchLines();
    HttpAnswer answer(std::string_view path, std::string_view bearer, const std::string& address);
    /// Whether there is a place for the next WebSocket. Another one without a word makes room for it.
    bool enters();
    void refused(const char* reason, const std::string& address);
    void tick();

    /// All pages are closed; the old links lead nowhere.
    void renew(const Tokens& tokens);
    void end();

    // For visitors.
    Right rightOf(std::string_view token);
    /// A page comes in by a token that has a right. Its own one then, for left(); "" without.
    std::string enter(std::string_view token);
    void left(std::string_view own, bool inOrder);
    Room* room(const std::string& name); ///< "": the first; null: none
    SessionId newId() { return ++lastId_; }
    nlohmann::json welcome(const Room& room, SessionId id, Right right, const std::string& own) const;
    std::string instanceList() const;
    void visitorCame() { ++visitors_; }
    void visitorLeft() { --visitors_; }
    void note(const std::string& text) { journal_.note(text); }

  private:
    nlohmann::json status() const;
    std::vector<RoomFigures> figures() const;
    bool makeRoom();
    void noteServers();

    const BridgeOptions& options_;
    Admission admission_;
    std::function<void(const std::string& driver)> linkUsed_;
    std::vector<std::unique_ptr<Room>> rooms_;
    nlohmann::json tables_, rungs_; ///< of each welcome
    Watch watch_;
    Journal journal_;
    std::map<std::string, ServerState> noted_; ///< of each instance, in the journal
    std::map<std::string, std::uint64_t> refused_;
    std::size_t visitors_ = 0;
    SessionId lastId_ = 0;
    double began_;
    std::vector<std::weak_ptr<Outlet>> outlets_;
    std::vector<std::weak_ptr<Visitor>> came_; ///< as they came
};

} // namespace bridge
