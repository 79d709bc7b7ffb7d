/// When a client asks a server for its state: whenever ipc::Status tells another revision, after its own
/// edits, and never twice at once. Pure; one thread.
#pragma once

#include <cstdint>
#include <optional>

namespace app {

/// The client sends `state` when asks() says so, and gives each answer to answered().
class StateFollower {
  public:
    /// Takes the revision of the server's latest status.
    void revision(std::uint64_t now) {
        wanted_ = wanted_ || known_ != now;
        known_ = now;
    }
    /// The state is wanted in any case.
    void want() { wanted_ = true; }
    /// An edit of the client's own is sent or answered: the answer to an older question would take it back in
    /// what is shown.
    void edits() { ++edits_; }
    /// True: `state` is to be sent now.
    bool asks() {
        if (!wanted_ || underWay_) return false;
        wanted_ = false;
        underWay_ = true;
        askedAt_ = edits_;
        return true;
    }
    /// The answer is there, or failed. True: what it says holds; else asks() asks again, of a server that
    /// failed to answer with its next status.
    bool answered(bool done) {
        underWay_ = false;
        const bool holds = done && askedAt_ == edits_;
        wanted_ = wanted_ || (done && !holds);
        if (!done) known_.reset();
        return holds;
    }
    /// The known state is up to date, as far as the client can tell.
    bool isCurrent() const { return !wanted_ && !underWay_; }
    /// Another server, or none: what is under way is not answered any more.
    void forget() { *this = StateFollower(); }

  private:
    std::optional<std::uint64_t> known_;
    std::uint64_t edits_ = 0, askedAt_ = 0;
    bool wanted_ = false, underWay_ = false;
};

} // namespace app
