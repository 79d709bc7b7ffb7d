// How fast the shared memory between the programs is: command round trips, frames, and what clients cost a
// server.
//   bench_ipc [--guard]     --guard: exit code 1 when commands or frames take longer than they may
#include "ipc/endpoint/client.h"
#include "ipc/endpoint/server.h"
#include "ipc/endpoint/viewer.h"
#include "support/child_process.h"
#include "support/ipc_instance.h"
#include "support/quantile.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <functional>
#include <thread>
#include <vector>

#include <csignal>
#include <ctime>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using test::ChildProcess;
using test::quantile;
using namespace std::chrono_literals;
using ipc::Clock;

constexpr std::uint32_t kWidth = 1920, kHeight = 1080;
constexpr double kMaxForCommand = 50, kMaxForFrame = 2000; // microseconds, medians
constexpr std::size_t kFrameBytes = 4u * kWidth * kHeight;

double microseconds(Clock::duration time) { return std::chrono::duration<double, std::micro>(time).count(); }
double cpuMicroseconds() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

// Each time of these two: the median.
double roundTrips() {
    const test::IpcInstance instance;
    const ChildProcess serving([&] {
        ipc::Server server({.instance = instance.name(), .width = 64, .height = 64});
        while (true) {
            server.wait(1s);
            for (const ipc::Command& command : server.takeCommands()) server.answer(command);
        }
    });
    ipc::Client client(instance.name());
    std::vector<double> times;
    for (int i = 0; i < 10000; ++i) {
        const auto start = Clock::now();
        client.request("ping");
        times.push_back(microseconds(Clock::now() - start));
        if (i % 100 == 0) std::this_thread::sleep_for(2ms); // the server falls asleep
    }
    std::printf("command and answer, idle server: %.1f us median, %.1f p99\n", quantile(times, 0.5),
                quantile(times, 0.99));
    return quantile(times, 0.5);
}

void frames() {
    const test::IpcInstance instance;
    ipc::Server server({.instance = instance.name(), .width = kWidth, .height = kHeight});
    std::vector<std::byte> pixels(kFrameBytes), copy(kFrameBytes);
    std::vector<double> publishing, copying, reading;
    ipc::Viewer viewer(instance.name());
    ipc::Frame frame;
    for (int i = 0; i < 300; ++i) {
        pixels[static_cast<std::size_t>(i)] = std::byte{1};
        auto start = Clock::now();
        server.publishFrame({.width = kWidth, .height = kHeight}, pixels);
        publishing.push_back(microseconds(Clock::now() - start));
        start = Clock::now();
        std::memcpy(copy.data(), pixels.data(), kFrameBytes);
        copying.push_back(microseconds(Clock::now() - start));
        start = Clock::now();
        viewer.readFrame(frame);
        reading.push_back(microseconds(Clock::now() - start));
    }
    const double plain = quantile(copying, 0.5);
    std::printf(
        "frame of %u x %u: published by copy %.0f us median (%.2f of a memcpy), read %.0f us (%.2f)\n",
        kWidth, kHeight, quantile(publishing, 0.5), quantile(publishing, 0.5) / plain, quantile(reading, 0.5),
        quantile(reading, 0.5) / plain);
}

// In another process, 60 frames per second, drawn in place.
double frameLatency() {
    const test::IpcInstance instance;
    const ChildProcess serving([&] {
        ipc::Server server({.instance = instance.name(), .width = kWidth, .height = kHeight});
        while (true) {
            server.takeCommands();
            std::memset(server.beginFrame(kWidth, kHeight).data(), 7, kFrameBytes);
            server.publishFrame();
            server.wait(16ms);
        }
    });
    ipc::Client client(instance.name());
    ipc::Frame frame;
    std::vector<double> times;
    while (times.size() < 300 && client.waitForFrame(frame, 1s)) {
        const auto now = std::chrono::nanoseconds(Clock::now().time_since_epoch()).count();
        times.push_back(static_cast<double>(now - frame.info.nanoseconds) / 1000);
    }
    std::printf("frame published to copied by a client: %.0f us median, %.0f p99\n", quantile(times, 0.5),
                quantile(times, 0.99));
    return quantile(times, 0.5);
}

// The processor time that serving and publishing takes the server, per frame of 10 ms.
double serverCost(ipc::Server& server, int count) {
    std::vector<std::byte> pixels(kFrameBytes);
    std::vector<double> costs;
    for (int i = 0; i < count; ++i) {
        std::this_thread::sleep_for(9ms);
        const double start = cpuMicroseconds();
        for (const ipc::Command& command : server.takeCommands()) server.answer(command);
        server.keys();
        server.publishFrame({.width = kWidth, .height = kHeight}, pixels);
        server.setStatus({});
        costs.push_back(cpuMicroseconds() - start);
    }
    return quantile(costs, 0.5);
}

void crowd() {
    const test::IpcInstance instance;
    ipc::Server server({.instance = instance.name(), .width = kWidth, .height = kHeight});
    const double alone = serverCost(server, 100);
    std::vector<ChildProcess> clients;
    for (int i = 0; i < 16; ++i) {
        clients.emplace_back([&, i] {
            ipc::Client client(instance.name());
            while (true) {
                if (i == 1) {
                    client.send("flood");
                    continue;
                }
                client.request("ping", 100ms);
                client.pressKey(i);
                std::this_thread::sleep_for(50ms);
            }
        });
    }
    serverCost(server, 50);
    clients[0].send(SIGSTOP);
    const double crowded = serverCost(server, 200);
    std::printf("serving and publishing, per frame: %.0f us alone, %.0f us with 16 clients, one of them "
                "stopped and one "
                "flooding: %.2f%% of a frame of 16.7 ms more\n",
                alone, crowded, (crowded - alone) / 16700 * 100);
}

// The load of a core by a sleeping server.
void idle() {
    const test::IpcInstance instance;
    ipc::Server server({.instance = instance.name(), .width = 64, .height = 64});
    const ChildProcess client([&] {
        const ipc::Client quiet(instance.name());
        ::pause();
    });
    const double start = cpuMicroseconds();
    const auto end = Clock::now() + 3s;
    while (Clock::now() < end) {
        server.wait(100ms);
        server.takeCommands();
    }
    std::printf("an idle server takes %.3f%% of a core\n", (cpuMicroseconds() - start) / 3e6 * 100);
}

bool within(const char* what, double median, double max) {
    if (median <= max) return true;
    std::fprintf(stderr, "bench_ipc: %s takes %.0f us, more than %.0f\n", what, median, max);
    return false;
}

} // namespace

int main(int count, char** words) {
    const bool guard = count == 2 && std::strcmp(words[1], "--guard") == 0;
    if (count > 1 && !guard) {
        std::fprintf(stderr, "usage: bench_ipc [--guard]\n");
        return 2;
    }
    try {
        const double command = roundTrips();
        frames();
        const double frame = frameLatency();
        if (guard) {
            const bool quick = within("a command with its answer", command, kMaxForCommand);
            return within("a frame from server to client", frame, kMaxForFrame) && quick ? 0 : 1;
        }
        crowd();
        idle();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_ipc: %s\n", error.what());
        return 1;
    }
}
