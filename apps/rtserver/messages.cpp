#include "rtserver/messages.h"

#include "rtserver/server_options.h"

#include "common/run_program.h"
#include "common/terminal.h"

namespace rtserver {

namespace {

constexpr std::size_t kLongest = 4000;
constexpr auto kInterval = std::chrono::seconds(1);

} // namespace

void Messages::print(const std::string& text) {
    if (app::errorTakesMore()) app::printMessage(serverSpec().name, text.substr(0, kLongest));
}

void Messages::complain(const std::string& text) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < kInterval) {
        ++others_;
        return;
    }
    last_ = now;
    print(text + (others_ == 0 ? "" : " (and " + std::to_string(others_) + " other failures before)"));
    others_ = 0;
}

} // namespace rtserver
