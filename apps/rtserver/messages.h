/// What the server prints for who started it. Never waits, however much there is to say and whoever does not
/// read it.
#pragma once

#include <chrono>
#include <string>

namespace rtserver {

/// One thread.
class Messages {
  public:
    /// On stderr, with the program's name. Left out when stderr takes no more; cut off after some 4000 bytes.
    static void print(const std::string& text);
    /// The same for what clients can bring about as often as they like: one a second, and how many there were
    /// beside it.
    void complain(const std::string& text);

  private:
    std::chrono::steady_clock::time_point last_;
    std::size_t others_ = 0; ///< not told since then
};

} // namespace rtserver
