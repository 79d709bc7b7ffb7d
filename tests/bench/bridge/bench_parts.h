/// Parts shared by the measurements of bench_bridge: a bridge, viewers, a server that needs no time.
#pragma once

#include "process/bridge/web_client.h"

#include "ipc/endpoint/server.h"
#include "support/child_process.h"
#include "support/ipc_instance.h"

#include <nlohmann/json.hpp>

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

namespace bridgebench {

using namespace test;

inline constexpr std::uint32_t kWidth = 1280, kHeight = 720;
inline constexpr double kMs = 1000;
inline constexpr const char* kToken = "bench-driver-bench-driver-bench";

using PixelBytes = std::vector<std::byte>; ///< of a frame of kWidth x kHeight

void sleepFor(double seconds);
inline double secondsFrom(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}
/// Processor time of all threads of a process so far, of this one, and of the calling thread; seconds.
double processorSeconds(pid_t process);
double ownSeconds();
double memoryMb(pid_t process);

/// An RTBridge beside a server. Throws std::runtime_error when it does not start.
class Bridge {
  public:
    explicit Bridge(const IpcInstance& instance);
    int port() const { return port_; }
    pid_t process() const { return process_.process(); }
    double cpu() const { return processorSeconds(process()); }
    /// The entry of its instance in /status.
    nlohmann::json status() const;
    std::string link() const;

  private:
    ChildProcess process_;
    int port_ = 0;
};

/// A viewer with a thread of its own: reads and acknowledges at once, decodes nothing.
class Viewer {
  public:
    explicit Viewer(int port) : thread_([this, port] { run(port); }) {}
    ~Viewer() {
        stopping_ = true;
        thread_.join();
    }
    std::atomic<bool> joined = false;
    std::atomic<int> frames = 0;
    std::atomic<std::uint64_t> bytes = 0;

  private:
    void run(int port);
    std::atomic<bool> stopping_ = false;
    std::thread thread_;
};
using Viewers = std::vector<std::unique_ptr<Viewer>>;
Viewers startViewers(int port, int count);

/// Sums over all of them.
struct ViewerCounts {
    double frames = 0, bytes = 0;
};
ViewerCounts countsOf(const Viewers& viewers);

/// A server that publishes a frame as soon as a key goes down, and so many a second besides.
class InstantServer {
  public:
    InstantServer(const std::string& instance, PixelBytes pixels, int rate);
    ~InstantServer() {
        stopping_ = true;
        thread_.join();
    }
    std::atomic<std::int64_t> pressedNs = 0; ///< when the last key was seen, by the steady clock
    std::atomic<int> published = 0;

  private:
    void run(const std::string& instance);
    PixelBytes pixels_, next_;
    int rate_;
    std::atomic<bool> ready_ = false, stopping_ = false;
    std::thread thread_;
};

// The measurements; each prints its figures. `pixels`: a frame of the scene.

/// `goalMs`: of the first rung.
void measureEncoders(const std::string& scene, const PixelBytes& pixels, double goalMs);
void measureInput(const PixelBytes& pixels);
void measureAtThirty(const PixelBytes& pixels, double seconds);
void measureBrowser(const PixelBytes& pixels);
/// With a renderer at `instance` that draws without end, at a fixed size.
void measureRenderer(const IpcInstance& instance, double seconds, int rounds);

} // namespace bridgebench
