/// Who is let in by which token: those of the links, and those that pages have of their own. Pure.
#pragma once

#include "bridge/tokens.h"

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bridge {

/// The right that a token grants.
enum class Right : std::uint8_t {
    None,
    Used, ///< a driver's link that has let a page in: nothing
    View,
    Drive,
};

/// The driver's link is good once, since browsers keep addresses: the page that it lets in gets a token of
/// its own, and another link takes its place. That token is good while the page is connected and for an hour
/// after its connection was lost, but for a minute only after the page was left: for one that is loaded
/// again. Links of a file are good for ever, and give no tokens. Seconds of any clock; one thread.
class Admission {
  public:
    explicit Admission(Tokens tokens) : tokens_(std::move(tokens)) {}

    const Tokens& links() const { return tokens_; }
    Right rightOf(std::string_view token, double now);

    struct Entered {
        std::string own;       ///< the page's token; "": the link stays good
        bool linkUsed = false; ///< links() has another one now
    };
    /// A page comes in by a token, which has a right. Each call with an own token is answered by one of
    /// left().
    Entered enter(std::string_view token, double now);
    /// `inOrder`: the page said so, as browsers do when it is closed or loaded again.
    void left(std::string_view own, bool inOrder, double now);

  private:
    struct OwnToken {
        std::string token;
        int pages = 0;    ///< that are connected by it
        double until = 0; ///< when there is none
    };
    OwnToken* find(std::string_view token, double now);

    Tokens tokens_;
    std::vector<OwnToken> own_;
    std::deque<std::string> used_; ///< links, the last ones
};

} // namespace bridge
