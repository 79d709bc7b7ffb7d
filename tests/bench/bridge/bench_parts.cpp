#include "bench/bridge/bench_parts.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/resource.h>

namespace bridgebench {

void sleepFor(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

double processorSeconds(pid_t process) {
    double sum = 0;
    for (const auto& task : std::filesystem::directory_iterator(fmt::format("/proc/{}/task", process))) {
        double nanoseconds = 0;
        std::ifstream(task.path() / "schedstat") >> nanoseconds;
        sum += 1e-9 * nanoseconds;
    }
    return sum;
}

double ownSeconds() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double memoryMb(pid_t process) {
    std::ifstream status(fmt::format("/proc/{}/status", process));
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024;
    return 0;
}

Bridge::Bridge(const IpcInstance& instance) {
    const std::string tokens = (instance.folder() / "tokens").string(),
                      links = (instance.folder() / "links").string();
    std::ofstream(tokens) << kToken << "\nbench-viewer-bench-viewer-bench\n";
    std::filesystem::permissions(tokens, std::filesystem::perms(0600));
    std::filesystem::remove(links);
    process_ = ChildProcess(
        RT_PROGRAM_FOLDER "/RTBridge",
        {"--instance=" + instance.name(), "--listen=127.0.0.1:0", "--rest=live", "--token-file=" + tokens},
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

std::string Bridge::link() const { return fmt::format("http://127.0.0.1:{}/#t={}", port_, kToken); }

nlohmann::json Bridge::status() const {
    RawSocket socket(port_);
    socket.write(fmt::format("GET /status HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nConnection: close\r\n"
                             "Authorization: Bearer {}\r\n\r\n",
                             port_, kToken));
    const std::string answer = socket.readAll(5s);
    const std::size_t body = answer.find("\r\n\r\n");
    if (body == std::string::npos) throw std::runtime_error("no status of the bridge");
    return nlohmann::json::parse(answer.substr(body))["instances"][0];
}

void Viewer::run(int port) {
    WebClient client(port);
    client.hello(kToken);
    joined = !client.event("welcome").is_null();
    while (!stopping_) {
        const auto message = client.next(50ms);
        if (!message || message->opcode != 2) continue;
        client.acknowledge(*message, 0);
        bytes += message->payload.size();
        if (headerOf(message->payload).type == 1) ++frames;
    }
}

Viewers startViewers(int port, int count) {
    Viewers viewers;
    // One after the other: the bridge lets in few at once of one address.
    for (int i = 0; i < count; ++i) {
        viewers.push_back(std::make_unique<Viewer>(port));
        if (!eventually([&] { return viewers.back()->joined.load(); }, 5s))
            throw std::runtime_error("a viewer is not let in");
    }
    return viewers;
}

ViewerCounts countsOf(const Viewers& viewers) {
    ViewerCounts sum;
    for (const auto& each : viewers) {
        sum.frames += each->frames;
        sum.bytes += static_cast<double>(each->bytes);
    }
    return sum;
}

InstantServer::InstantServer(const std::string& instance, PixelBytes pixels, int rate)
    : pixels_(std::move(pixels)), rate_(rate), thread_([this, instance] { run(instance); }) {
    eventually([&] { return ready_.load(); });
}

void InstantServer::run(const std::string& instance) {
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
    // Other rows on top: the frame differs from the last, and costs as much.
    next_ = pixels_;
    std::rotate(next_.begin(), next_.begin() + std::ptrdiff_t(4) * kWidth * 2, next_.end());
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
        pixels_.swap(next_);
        server.publishFrame(info, pixels_);
        ++published;
    }
}

} // namespace bridgebench
