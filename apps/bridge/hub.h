/// The rooms of all instances, who comes in by which token, and what /status tells. On the thread of the
/// sockets.
#pragma once

#include "bridge/bridge_options.h"
#include "bridge/control/room.h"
#include "bridge/report/journal.h"
#include "bridge/report/watch.h"
#include "bridge/tokens.h"

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace bridge {

class Visitor;

class Hub {
  public:
    Hub(const BridgeOptions& options, Tokens tokens, const Post& post);

    std::shared_ptr<Receiver> opened(const std::shared_ptr<Outlet>& outlet);
    /// A line for each instance, for a terminal.
    std::string watchLines();
    HttpAnswer answer(std::string_view path, std::string_view bearer, const std::string& address);
    /// Of the next WebSocket from there. Others that wait without a word make room for it.
    Entry entry(const std::string& address);
    void refused(const char* reason, const std::string& address);
    void tick();

    /// All pages are closed; the old links lead nowhere.
    void renew(Tokens tokens);
    void end();

    // For visitors.
    enum class Right { None, View, Drive };
    Right rightOf(std::string_view token) const;
    void wrongToken(const std::string& address);
    Room* room(const std::string& name); ///< "": the first; null: none
    SessionId newId() { return ++lastId_; }
    nlohmann::json welcome(const Room& room, SessionId id, Right right) const;
    std::string instanceList() const;
    void visitorCame() { ++visitors_; }
    void visitorLeft() { --visitors_; }
    void note(const std::string& text) { journal_.note(text); }

  private:
    nlohmann::json status() const;
    std::vector<RoomFigures> figures() const;
    std::vector<std::shared_ptr<Visitor>> newcomers(const std::string& address) const; ///< "": of all
    bool makeRoom(const std::string& address, double patience);
    void noteServers();

    const BridgeOptions& options_;
    Tokens tokens_;
    std::vector<std::unique_ptr<Room>> rooms_;
    nlohmann::json settings_, rungs_;
    Watch watch_;
    Journal journal_;
    std::map<std::string, ServerState> noted_; ///< of each instance, in the journal
    WrongTokens wrong_;
    std::map<std::string, std::uint64_t> refused_;
    std::size_t visitors_ = 0;
    SessionId lastId_ = 0;
    double began_;
    std::vector<std::weak_ptr<Outlet>> outlets_;
    std::vector<std::weak_ptr<Visitor>> came_; ///< as they came
};

} // namespace bridge
