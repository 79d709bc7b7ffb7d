/// A Chromium without a window that a test drives by its developer protocol, over a pipe: no port, no other
/// process can join. Dies with the test.
#pragma once

#include "support/child_process.h"
#include "support/temporary_folder.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace test {

using Json = nlohmann::json;

/// The Chromium of RT_CHROMIUM (empty: as if there were none) or of PATH; nothing where there is none.
std::optional<std::string> chromiumProgram();

class Chromium {
  public:
    /// `options` are added to its command line. Throws std::runtime_error when it does not answer.
    explicit Chromium(const std::vector<std::string>& options = {});
    ~Chromium();
    Chromium(const Chromium&) = delete;
    Chromium& operator=(const Chromium&) = delete;

    /// A method of the protocol; its result. Throws std::runtime_error with the browser's own words, or when
    /// no answer comes within a minute.
    Json call(const std::string& method, const Json& parameters = Json::object(),
              const std::string& session = {});
    /// Takes in what the browser says meanwhile.
    void listen(std::chrono::milliseconds time);
    /// All events of a session so far.
    std::vector<Json> events(const std::string& session) const;
    /// All that were opened, with what they keep; their events are forgotten.
    void closePages();
    const std::filesystem::path& profile() const { return profile_.path(); }
    void kill();
    bool killed() const { return process_->process() < 0; }

  private:
    std::optional<Json> read(Clock::time_point deadline);

    TemporaryFolder profile_;
    std::unique_ptr<ChildProcess> process_;
    pid_t group_ = 0; ///< of the browser and its helpers
    int commands_ = -1, answers_ = -1;
    int lastId_ = 0;
    std::string unread_;
    std::vector<Json> events_;
};

/// The one that the tests of a program share, since it takes seconds to start: it has these options and no
/// page.
Chromium& sharedChromium(const std::vector<std::string>& options = {});

} // namespace test
