/// Edits that follow a hand: of each thing one is under way, and of what was wanted meanwhile the newest is
/// sent next. Those of one gesture are one step of undo. Pure; one thread.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>

namespace app {

class EditQueue {
  public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds kOneGesture{1000}; ///< changes within are one step of undo

    /// `thing` is what the step of undo is known by, "light move 2". The line to be sent now; nothing: one of
    /// that thing is under way. `goesOn`: it belongs to the step of the last one, if that was of the same
    /// thing; nothing: by the time in between.
    std::optional<std::string> edit(const std::string& thing, const std::string& line,
                                    std::optional<bool> goesOn = {}, Clock::time_point now = Clock::now());
    /// The answer to the last line of that thing is there: the next line to be sent; nothing: none waits.
    std::optional<std::string> answered(const std::string& thing);
    /// Whether one is under way, so that what the server says of it is already old.
    bool isBusy(const std::string& thing) const { return waiting_.contains(thing); }
    /// The next edit begins a step of its own.
    void endGesture() { last_.clear(); }
    /// Another server, or none: nothing is under way.
    void forget() { *this = EditQueue(); }

  private:
    struct Waiting {
        std::optional<std::string> line;
        bool goesOn = false;
    };

    std::map<std::string, Waiting> waiting_; ///< of what is under way
    std::string last_;                       ///< the thing whose gesture may go on
    Clock::time_point since_{};
};

} // namespace app
