/// The rooms of all instances, who comes in by which token, and what /status tells. On the thread of the
/// sockets.
#pragma once

#include "bridge/admission.h"
#include "bridge/bridge_options.h"
#include "bridge/reception.h"
#include "bridge/report/watch.h"
#include "bridge/room/room.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace bridge {

class Visitor;

class Hub : public Reception {
  public:
    /// `linkUsed` is told the driver's next link's token. `options` must outlive it.
    Hub(const BridgeOptions& options, const Tokens& tokens, RoomServices services,
        std::function<void(const std::string& driver)> linkUsed);

    std::shared_ptr<Receiver> opened(const std::shared_ptr<Outlet>& outlet);
    /// A line for each instance, for a terminal.
    std::string watchLines();
    HttpAnswer answer(std::string_view path, std::string_view bearer, const std::string& address);
    /// Whether there is a place for the next WebSocket. Another one without a word makes room for it.
    bool enters();
    void tick();

    /// All pages are closed; the old links lead nowhere.
    void renew(const Tokens& tokens);
    void end();

    Right rightOf(std::string_view token) override;
    Room* room(const std::string& name) override;
    std::string instanceList() const override;
    Entrance enter(const Room& room, std::string_view token, Right right) override;
    void left(std::string_view own, bool inOrder) override;
    void closed() override { --visitors_; }
    void refused(const char* reason, const std::string& address) override;
    void note(const std::string& text) override { services_.note(text); }

  private:
    nlohmann::json welcome(const Room& room, const Entrance& entrance, Right right) const;
    nlohmann::json status() const;
    std::vector<RoomFigures> figures() const;
    bool makeRoom();
    void noteServers();

    const BridgeOptions& options_;
    const RoomServices services_;
    Admission admission_;
    std::function<void(const std::string& driver)> linkUsed_;
    std::vector<std::unique_ptr<Room>> rooms_;
    nlohmann::json tables_, rungs_; ///< of each welcome
    Watch watch_;
    std::map<std::string, ServerLink> noted_; ///< of each instance, in the journal
    std::map<std::string, std::uint64_t> refused_;
    std::size_t visitors_ = 0;
    SessionId lastId_ = 0;
    double began_;
    std::vector<std::weak_ptr<Outlet>> outlets_;
    std::vector<std::weak_ptr<Visitor>> came_; ///< as they came
};

} // namespace bridge
