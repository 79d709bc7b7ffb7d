#include "rtserver/commands/command_book.h"

#include <algorithm>
#include <map>

namespace rtserver {

namespace {

bool among(const std::vector<std::uint64_t>& clients, std::uint64_t client) {
    return std::find(clients.begin(), clients.end(), client) != clients.end();
}

} // namespace

void CommandBook::add(ipc::Command command) {
    pending_.push_back(std::move(command));
    new_ = true;
}

void CommandBook::serve(const Run& run) {
    new_ = false;
    waiting_.clear();
    std::deque<ipc::Command> rest;
    for (ipc::Command& command : std::exchange(pending_, {})) {
        const std::uint64_t client = command.client;
        if (!among(waiting_, client) && !among(beside_, client)) {
            const Served served = run(command);
            if (served == Served::Beside) beside_.push_back(client);
            if (served != Served::Again) continue;
            waiting_.push_back(client);
        }
        rest.push_back(std::move(command));
    }
    pending_ = std::move(rest);
}

bool CommandBook::isBeside(std::uint64_t client) const { return among(beside_, client); }

bool CommandBook::hasMore(std::uint64_t client) const {
    return isBeside(client) || std::any_of(pending_.begin(), pending_.end(), [client](const auto& command) {
               return command.client == client;
           });
}

std::vector<const ipc::Command*> CommandBook::ofClientsWith(std::size_t number) const {
    std::map<std::uint64_t, std::size_t> counts;
    std::vector<const ipc::Command*> found;
    for (const ipc::Command& command : pending_) {
        if (++counts[command.client] == number) found.push_back(&command);
    }
    return found;
}

void CommandBook::forgetWaiting(const std::function<bool(const ipc::Command&)>& forgotten) {
    std::vector<std::uint64_t> clients;
    for (const std::uint64_t client : waiting_) {
        const auto first = std::ranges::find(pending_, client, &ipc::Command::client);
        if (first != pending_.end() && forgotten(*first)) clients.push_back(client);
    }
    takeFirst(std::move(clients));
}

std::vector<ipc::Command> CommandBook::takeWaiting() { return takeFirst(waiting_); }

bool CommandBook::obstructs() const { return !obstructed().empty(); }

std::vector<ipc::Command> CommandBook::takeObstructing() { return takeFirst(obstructed()); }

std::vector<std::uint64_t> CommandBook::obstructed() const {
    std::vector<std::uint64_t> clients = waiting_;
    std::erase_if(clients, [this](std::uint64_t client) {
        return std::count_if(pending_.begin(), pending_.end(),
                             [client](const auto& command) { return command.client == client; }) < 2;
    });
    return clients;
}

std::vector<ipc::Command> CommandBook::takeFirst(std::vector<std::uint64_t> clients) {
    std::vector<ipc::Command> taken;
    std::erase_if(pending_, [&](ipc::Command& command) {
        if (std::erase(clients, command.client) == 0) return false;
        std::erase(waiting_, command.client);
        taken.push_back(std::move(command));
        return true;
    });
    return taken;
}

} // namespace rtserver
