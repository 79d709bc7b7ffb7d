// What the bridge costs, and how soon it is: each figure beside its goal.
//   bench_bridge [--seconds=N] [--scene=FILE] [--server=RTSERVER]
// Viewers read and acknowledge at once and decode nothing. A server that publishes a frame of the scene at
// once, or 30 times a second, shows what is the bridge's alone; then RTServer draws every frame, for 0, 1 and
// 10 viewers.
#include "process/bridge/web_client.h"

#include "ipc/endpoint/client.h"
#include "ipc/endpoint/server.h"
#include "support/child_process.h"
#include "support/ipc_instance.h"
#include "support/quantile.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/resource.h>

namespace {

using namespace test;

constexpr const char* kToken = "bench-driver-bench-driver-bench";
constexpr double kMs = 1000;

struct Wishes {
    double seconds = 8;
    std::string scene = RT_SOURCE_FOLDER "/data/nave/nave.scn", server = RT_PROGRAM_FOLDER "/RTServer";
};

void tell(const char* what, const std::string& goal, double value, const char* unit) {
    fmt::print("{:58} {:9.2f} {:6}  goal {}\n", what, value, unit, goal);
    std::fflush(stdout);
}

/// Processor time of all threads of a process so far, seconds.
double processorSeconds(pid_t process) {
    double sum = 0;
    for (const auto& task : std::filesystem::directory_iterator(fmt::format("/proc/{}/task", process))) {
        double nanoseconds = 0;
        std::ifstream(task.path() / "schedstat") >> nanoseconds;
        sum += 1e-9 * nanoseconds;
    }
    return sum;
}

double memoryMb(pid_t process) {
    std::ifstream status(fmt::format("/proc/{}/status", process));
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024;
    return 0;
}

double ownSeconds() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

class Bridge {
  public:
    explicit Bridge(const IpcInstance& instance) {
        const std::string tokens = (instance.folder() / "tokens").string(),
                          links = (instance.folder() / "links").string();
        std::ofstream(tokens) << kToken << "\nbench-viewer-bench-viewer-bench\n";
        std::filesystem::permissions(tokens, std::filesystem::perms(0600));
        process_ =
            ChildProcess(RT_PROGRAM_FOLDER "/RTBridge",
                         {"--instance=" + instance.name(), "--listen=127.0.0.1:0", "--token-file=" + tokens},
                         {.outputFile = links});
        std::string text;
        eventually(
            [&] {
                std::ostringstream all;
                all << std::ifstream(links).rdbuf();
                text = all.str();
                return text.find("Viewer:") != std::string::npos;
            },
            10s);
        const std::size_t at = text.find("127.0.0.1:");
        if (at == std::string::npos) throw std::runtime_error("the bridge does not start: " + text);
        port_ = std::atoi(text.c_str() + at + 10);
    }
    int port() const { return port_; }
    pid_t process() const { return process_.process(); }

  private:
    ChildProcess process_;
    int port_ = 0;
};

/// A viewer with a thread of its own.
class Viewer {
  public:
    explicit Viewer(int port) : thread_([this, port] { run(port); }) {}
    ~Viewer() {
        stopping_ = true;
        thread_.join();
    }
    std::atomic<int> frames = 0;
    std::atomic<std::uint64_t> bytes = 0;
    /// After the thread is gone, or while nothing is sent.
    std::vector<double> ages; ///< ms

  private:
    void run(int port) {
        WebClient client(port);
        client.hello(kToken);
        while (!stopping_) {
            const auto message = client.next(50ms);
            if (!message || message->opcode != 2) continue;
            client.acknowledge(*message, 0);
            const FrameHeader header = headerOf(message->payload);
            bytes += message->payload.size();
            if (header.type != 1) continue;
            ++frames;
            ages.push_back(1e-3 * header.age);
        }
    }
    std::atomic<bool> stopping_ = false;
    std::thread thread_;
};

void sleepFor(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// The seconds of one frame of the renderer with so many viewers.
double measureViewers(const Wishes& wishes, const Bridge& bridge, const std::string& instance, int count,
                      double alone) {
    std::vector<std::unique_ptr<Viewer>> viewers;
    for (int i = 0; i < count; ++i) viewers.push_back(std::make_unique<Viewer>(bridge.port()));
    sleepFor(2);
    ipc::Viewer look(instance);
    ipc::Frame frame;
    look.waitForFrame(frame, 5s);
    const std::uint64_t first = frame.info.number;
    const double cpu = processorSeconds(bridge.process()), own = ownSeconds();
    const auto start = Clock::now();
    std::uint64_t bytes = 0;
    int sent = 0;
    for (const auto& each : viewers) {
        bytes -= each->bytes;
        sent -= each->frames;
    }
    sleepFor(wishes.seconds);
    const double time = std::chrono::duration<double>(Clock::now() - start).count();
    look.readFrame(frame);
    const auto published = static_cast<double>(frame.info.number - first);
    const double used = processorSeconds(bridge.process()) - cpu, viewersUsed = ownSeconds() - own;
    for (const auto& each : viewers) {
        bytes += each->bytes;
        sent += each->frames;
    }
    const double seconds = time / published;
    fmt::print("--- {} viewer(s): {:.1f} frames/s of the server, {:.1f} a viewer, {:.1f} Mbit/s in all, "
               "viewers' own CPU {:.2f} cores\n",
               count, published / time, count == 0 ? 0.0 : sent / time / count,
               8e-6 * static_cast<double>(bytes) / time, viewersUsed / time);
    if (count == 0) return seconds;
    tell("CPU of the bridge for a published frame, ms",
         count == 1    ? "4"
         : count == 10 ? "6"
                       : "-",
         kMs * used / published, "ms");
    tell("CPU of the bridge, % of a core", count == 1 ? "12 at 30/s" : "-", 100 * used / time, "%");
    constexpr double kCores = 2, kSlack = 0.03;
    if (alone > 0)
        tell("growth of the renderer's frame time, viewers' CPU included",
             fmt::format("{:.1f} beyond the viewers' own", 100 * (used / time / kCores + kSlack)),
             100 * (seconds / alone - 1), "%");
    std::vector<double> ages;
    std::uint64_t all = 0;
    for (auto& each : viewers) {
        all += each->bytes;
        Viewer& viewer = *each;
        ages.insert(ages.end(), viewer.ages.begin(),
                    viewer.ages.begin() +
                        static_cast<std::ptrdiff_t>(std::min<std::size_t>(viewer.ages.size(), 100000)));
    }
    tell("published to socket, median", "4", quantile(ages, 0.5), "ms");
    tell("published to socket, 99 %", "8", quantile(ages, 0.99), "ms");
    tell("memory of the bridge", "30 + 2 frames", memoryMb(bridge.process()), "MB");
    return seconds;
}

constexpr std::uint32_t kWidth = 1280, kHeight = 720;

/// A server that publishes a frame as soon as a key goes down, and so many a second besides.
class InstantServer {
  public:
    InstantServer(const std::string& instance, std::vector<std::byte> pixels, int rate)
        : pixels_(std::move(pixels)), rate_(rate), thread_([this, instance] { run(instance); }) {
        eventually([&] { return ready_.load(); });
    }
    ~InstantServer() {
        stopping_ = true;
        thread_.join();
    }
    std::atomic<std::int64_t> pressedNs = 0; ///< when the last key was seen

  private:
    void run(const std::string& instance) {
        ipc::Server server({.instance = instance, .width = kWidth, .height = kHeight});
        ipc::FrameInfo info;
        info.width = kWidth;
        info.height = kHeight;
        ipc::Status status;
        status.width = kWidth;
        status.height = kHeight;
        status.idle = 1;
        server.setStatus(status);
        server.publishFrame(info, pixels_);
        ready_ = true;
        auto next = Clock::now();
        while (!stopping_) {
            server.wait(rate_ > 0 ? 1ms : 5ms);
            for (const ipc::Command& command : server.takeCommands()) server.answer(command);
            const bool pressed = server.keys().presses['W'] != 0;
            if (pressed) pressedNs = Clock::now().time_since_epoch().count();
            const bool due = rate_ > 0 && Clock::now() >= next;
            if (due) next += std::chrono::microseconds(1'000'000 / rate_);
            if (!pressed && !due) continue;
            // Another row on top: the frame differs from the last, and costs as much.
            std::rotate(pixels_.begin(), pixels_.begin() + std::ptrdiff_t(4) * kWidth * 2, pixels_.end());
            server.publishFrame(info, pixels_);
        }
    }
    std::vector<std::byte> pixels_;
    int rate_;
    std::atomic<bool> ready_ = false, stopping_ = false;
    std::thread thread_;
};

void measureInput(const std::vector<std::byte>& pixels) {
    const IpcInstance instance;
    InstantServer server(instance.name(), pixels, 0);
    const Bridge bridge(instance);
    WebClient client(bridge.port());
    client.hello(kToken);
    if (client.event("welcome").is_null()) throw std::runtime_error("no welcome");
    sleepFor(1);
    while (const auto rest = client.next(300ms))
        if (rest->opcode == 2) client.acknowledge(*rest);
    std::vector<double> toKey, toFrame, toStill;
    constexpr int kPresses = 100;
    for (int i = 0; i < kPresses; ++i) {
        const auto start = Clock::now();
        client.input({}, 0, 0, {'W'});
        const auto frame = client.binary(1);
        if (!frame) throw std::runtime_error("no frame after a key");
        const auto came = Clock::now();
        toFrame.push_back(kMs * std::chrono::duration<double>(came - start).count());
        toKey.push_back(1e-6 * static_cast<double>(server.pressedNs - start.time_since_epoch().count()));
        client.acknowledge(*frame);
        std::this_thread::sleep_for(
            std::chrono::milliseconds(20 + 7 * i % 31)); // the bridge takes 60 per second
        if (i % 10 != 0) continue;
        for (auto part = client.binary(2); part; part = client.binary(2)) {
            client.acknowledge(*part);
            if ((headerOf(part->payload).flags & 4) != 0) break;
        }
        toStill.push_back(kMs * std::chrono::duration<double>(Clock::now() - came).count());
    }
    sleepFor(2);
    const double cpu = processorSeconds(bridge.process());
    constexpr double kRest = 5;
    const auto end = Clock::now() + std::chrono::duration<double>(kRest);
    while (Clock::now() < end) client.next(100ms);
    const double rest = 100 * (processorSeconds(bridge.process()) - cpu) / kRest;
    fmt::print("--- a server that publishes at once\n");
    tell("CPU of the bridge at rest, one viewer, % of a core", "1", rest, "%");
    tell("input message to key bit, median", "0.3", quantile(toKey, 0.5), "ms");
    tell("input message to key bit, 99 %", "2", quantile(toKey, 0.99), "ms");
    tell("input message to whole frame at the client, median", "15 with decoding", quantile(toFrame, 0.5),
         "ms");
    tell("last movement to exact image, median", "250", quantile(toStill, 0.5), "ms");
}

/// Frames as the renderer draws them, 30 a second, whatever else the machine does.
void measureAtThirty(const Wishes& wishes, const std::vector<std::byte>& pixels) {
    const IpcInstance instance;
    InstantServer server(instance.name(), pixels, 30);
    const Bridge bridge(instance);
    fmt::print("=== a frame of the scene, published 30 times a second\n");
    for (const int viewers : {1, 10, 50}) measureViewers(wishes, bridge, instance.name(), viewers, 0);
}

void measureWithRenderer(const Wishes& wishes) {
    const IpcInstance instance;
    ChildProcess server(wishes.server,
                        {"--instance=" + instance.name(), "--resolution=1280x720", wishes.scene},
                        {.outputFile = (instance.folder() / "server.log").string()});
    ipc::Client client(instance.name(), 60s);
    client.request("set antialiasing 1", 60s);
    client.request("wait-idle", 60s);
    ipc::Frame frame;
    client.waitForFrame(frame, 10s);
    if (frame.info.width != kWidth || frame.info.height != kHeight)
        throw std::runtime_error("the renderer shows no frame of 1280 x 720");
    measureInput(frame.pixels);
    measureAtThirty(wishes, frame.pixels);
    fmt::print("=== the renderer, drawing every frame\n");
    client.request("idle off", 60s);
    client.request("frame-time off", 60s);
    const Bridge bridge(instance);
    const double alone = measureViewers(wishes, bridge, instance.name(), 0, 0);
    measureViewers(wishes, bridge, instance.name(), 1, alone);
    measureViewers(wishes, bridge, instance.name(), 10, alone);
}

Wishes wishesOf(int argc, char** argv) {
    Wishes wishes;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const std::string value = word.substr(std::min(word.find('=') + 1, word.size()));
        if (word.starts_with("--seconds="))
            wishes.seconds = std::stod(value);
        else if (word.starts_with("--scene="))
            wishes.scene = value;
        else if (word.starts_with("--server="))
            wishes.server = value;
        else
            throw std::runtime_error("usage: bench_bridge [--seconds=N] [--scene=FILE] [--server=RTSERVER]");
    }
    return wishes;
}

} // namespace

int main(int argc, char** argv) {
    try {
        const Wishes wishes = wishesOf(argc, argv);
        measureWithRenderer(wishes);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_bridge: {}\n", error.what());
        return 1;
    }
}
