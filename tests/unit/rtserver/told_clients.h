/// Clients that need no ipc: what they send, and what they are told.
#pragma once

#include "rtserver/commands/requests.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// Writes down what each client is told.
class ToldClients final : public rtserver::Replies {
  public:
    void answer(const ipc::Command& command, const std::string& text, const std::string&) override {
        lines.push_back(command.text + ": " + text);
    }
    void refuse(const ipc::Command& command, int code, const rtcore::Sentence& why) override {
        lines.push_back(command.text + ": " + std::to_string(code) + " " + why.english());
    }
    bool isConnected(const ipc::Command& command) const override { return command.client != gone; }
    std::vector<std::string> take() { return std::exchange(lines, {}); }

    std::vector<std::string> lines;
    std::uint64_t gone = 0;
};

inline ipc::Command commandOf(const std::string& text, std::uint64_t client = 1, bool wantsAnswer = true) {
    ipc::Command command;
    command.text = text;
    command.client = client;
    command.slot = static_cast<int>(client);
    command.wantsAnswer = wantsAnswer;
    return command;
}

} // namespace test
