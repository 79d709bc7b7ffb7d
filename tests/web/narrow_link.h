/// A long and narrow way to a port of this machine.
#pragma once

#include <atomic>
#include <thread>

namespace test {

/// Takes connections on a port of its own and passes on what comes, both ways: so many bytes a second for all
/// of them together, after half of the round trip, with as much memory under way as a router has. One thread.
class NarrowLink {
  public:
    NarrowLink(double bytesPerSecond, double roundTripSeconds);
    ~NarrowLink();
    NarrowLink(const NarrowLink&) = delete;
    NarrowLink& operator=(const NarrowLink&) = delete;

    int port() const { return port_; }
    /// Where connections lead: free when the link was made.
    int target() const { return target_; }
    /// Ends all connections, and each new one at once, until the link is mended.
    void cut() { cut_ = true; }
    void mend() { cut_ = false; }

  private:
    void run();

    double rate_, delay_;
    int listener_ = -1, port_ = 0, target_ = 0;
    std::atomic<bool> cut_ = false, stopping_ = false;
    std::thread thread_;
};

} // namespace test
