#include "common/process/secrets.h"

#include <sys/prctl.h>
#include <sys/random.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <stdexcept>

namespace app {

namespace {

std::atomic<bool> renewalRequested = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler stores it");

} // namespace

void protectSecrets() noexcept {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
}

void fillWithRandomBytes(std::span<unsigned char> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::getrandom(bytes.data(), bytes.size(), 0);
        if (count < 0 && errno != EINTR) throw std::runtime_error("the system has no random numbers");
        if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
}

void installRenewalHandler() {
    struct sigaction action {};
    action.sa_handler = [](int) { renewalRequested = true; };
    action.sa_flags = SA_RESTART;
    ::sigaction(SIGUSR1, &action, nullptr);
}

bool takeRenewalRequest() noexcept { return renewalRequested.exchange(false); }

std::string hostName() {
    constexpr std::size_t kMax = 256;
    std::array<char, kMax> name{};
    ::gethostname(name.data(), name.size() - 1);
    return name.data();
}

} // namespace app
