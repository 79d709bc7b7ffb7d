/// Images that another program asks for on standard input, one after another.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

namespace renderer {

struct Request {
    std::uint64_t run = 0;               ///< marks all frames of its preview
    std::filesystem::path scene, camera; ///< a .cam file; empty: the scene's own view
};

/// "RUN<TAB>SCENE<TAB>CAMERA". Throws rtcore::FileError BadData for what is no such line.
Request parseRequest(std::string_view line);

/// Reads lines of standard input in a thread of its own, from the beginning on. Each of them ends the work at
/// hand (app::endWork()); an empty one asks for nothing else.
class Requests {
  public:
    Requests();
    /// Ends within some 50 ms.
    ~Requests();
    Requests(const Requests&) = delete;
    Requests& operator=(const Requests&) = delete;

    /// Waits for a request; of several it gives the last. Nothing once the input has ended, or a signal asked
    /// to stop. Throws what parseRequest() throws. One thread.
    std::optional<Request> next();
    /// Whether something came that next() has not given yet.
    bool pending();

  private:
    void read(const std::stop_token& stop);
    void take(std::string_view line);

    std::mutex mutex_; ///< guards all below
    std::condition_variable_any wake_;
    std::string unfinished_; ///< line
    std::optional<Request> newest_;
    bool ended_ = false, came_ = false;
    std::exception_ptr failure_;
    std::jthread thread_; ///< last: it starts when all else stands
};

} // namespace renderer
