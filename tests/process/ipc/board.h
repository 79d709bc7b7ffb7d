/// Reports of a fault test's participants to the test: counters in a mapped file, which no kill -9 can lose.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <stdexcept>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace test {

struct Counters {
    std::atomic<std::uint64_t> progress; ///< server: frames; client: commands answered; viewer: frames seen
    std::atomic<std::uint64_t> frames;   ///< whole frames seen
    std::atomic<std::uint64_t> torn;     ///< frames or statuses that are a mixture
    std::atomic<std::uint64_t> wrong;    ///< answers to another question, and other broken promises
    std::atomic<std::uint64_t> epochs;   ///< servers met
    std::atomic<std::uint64_t> timeouts; ///< questions without an answer in time
};

constexpr int kParticipants = 64;

class Board {
  public:
    explicit Board(const std::filesystem::path& path) {
        const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
        if (file < 0 || ::ftruncate(file, sizeof(Counters) * kParticipants) != 0)
            throw std::runtime_error("no board");
        void* memory =
            ::mmap(nullptr, sizeof(Counters) * kParticipants, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        ::close(file);
        if (memory == MAP_FAILED) throw std::runtime_error("no board");
        counters_ = static_cast<Counters*>(memory);
    }
    ~Board() { ::munmap(counters_, sizeof(Counters) * kParticipants); }
    Board(const Board&) = delete;
    Board& operator=(const Board&) = delete;
    Counters& operator[](int index) { return counters_[index]; }

  private:
    Counters* counters_;
};

} // namespace test
