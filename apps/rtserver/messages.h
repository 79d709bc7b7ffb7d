/// Messages of the server: on stderr, and by the command `messages` for clients. Never waits, even when
/// stderr is not read.
#pragma once

#include "rtcore/platform/sentence.h"

#include <chrono>
#include <cstdint>
#include <deque>
#include <string>

namespace rtserver {

/// One thread.
class Messages {
  public:
    /// On stderr alone, with the program's name. Left out when stderr takes no more; cut off after some 4000
    /// bytes.
    static void print(const rtcore::Sentence& said);
    /// A warning: on stderr, and kept for clients.
    void warn(const rtcore::Sentence& said);
    /// The same for what clients can bring about as often as they like: one a second, and how many there were
    /// beside it.
    void complain(const rtcore::Sentence& said);
    /// A decision made for the user, and the command that decides otherwise, in quotes. Kept for clients,
    /// not printed.
    void offer(const rtcore::Sentence& said);
    /// The user has decided: no offer holds any more.
    void withdrawOffers();
    /// The effect of a key. Kept for clients, not printed.
    void tell(const rtcore::Sentence& said);

    /// How many were kept so far: grows with each, and never falls.
    std::uint32_t count() const { return count_; }
    /// Those after the first `known` ones, as far as they are still there (the last 100 are), a line each:
    /// its number, "warning", "offer" or "event", the text.
    std::string since(std::uint32_t known) const;
    /// The sentences of these lines for programs (rtcore/io/text/sentence_json.h), a line each.
    std::string detailsSince(std::uint32_t known) const;
    /// Another scene is shown: messages of the last one are dropped.
    void forget() { kept_.clear(); }

  private:
    struct Kept {
        std::string line, detail;
    };
    void keep(const char* kind, const rtcore::Sentence& said);
    std::string since(std::uint32_t known, std::string Kept::*which) const;

    std::chrono::steady_clock::time_point last_;
    std::size_t others_ = 0; ///< not told since then
    std::deque<Kept> kept_;  ///< the last one is number count_
    std::uint32_t count_ = 0;
};

} // namespace rtserver
