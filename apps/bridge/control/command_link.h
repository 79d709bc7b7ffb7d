/// Commands and keys of one instance, by a client of its own: one that waits for frames cannot press keys
/// meanwhile.
#pragma once

#include "bridge/control/server_commands.h"

#include "common/commands/key_restraint.h"

#include <memory>

namespace bridge {

/// One thread of its own, from which events and answers are told. Without anyone it only looks whether the
/// server lives.
class CommandLink : public ServerCommands {
  public:
    CommandLink(std::string instance, app::KeyRestraint restraint, ServerEvents events);
    /// Releases the keys.
    ~CommandLink() override;
    CommandLink(const CommandLink&) = delete;
    CommandLink& operator=(const CommandLink&) = delete;

    void setAnyone(bool anyone) override;
    void setKeys(const KeySet& down) override;
    void tap(std::span<const std::uint8_t> keys) override;
    void turn(double right, double up) override;
    void dropTurn() override;
    void request(std::string command, std::function<void(ipc::Reply)> done) override;
    void refresh() override;
    CommandFigures figures() const override;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace bridge
