// How soon RTServer answers, and what its clients cost it.
//   bench_server [SCENE]       Without a scene: our own nave.
#include "ipc/endpoint/client.h"
#include "support/child_process.h"
#include "support/ipc_instance.h"
#include "support/quantile.h"
#include "support/run_program.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>
#include <vector>

#include <csignal>
#include <ctime>
#include <unistd.h>

namespace {

using test::ChildProcess;
using test::quantile;
using namespace std::chrono_literals;
using ipc::Clock;

double milliseconds(Clock::duration time) { return std::chrono::duration<double, std::milli>(time).count(); }

class Bench {
  public:
    Bench(const std::string& scene, int threads)
        : server_(std::string(RT_PROGRAM_FOLDER) + "/RTServer",
                  {scene, "--instance=" + instance_.name(), "--resolution=640x480",
                   "--threads=" + std::to_string(threads)},
                  test::ProgramSettings{.timeoutSeconds = 600}) {
        if (!server_.waitForError("ready: ")) throw std::runtime_error(server_.wait().error);
        client_ = std::make_unique<ipc::Client>(instance_.name());
        ask("wait-idle");
        std::this_thread::sleep_for(1s); // an exact tree may be on its way
    }

    void commands() {
        std::vector<double> times;
        for (int i = 0; i < 5000; ++i) {
            const auto start = Clock::now();
            ask("ping");
            times.push_back(1000 * milliseconds(Clock::now() - start));
            if (i % 50 == 0) std::this_thread::sleep_for(3ms);
        }
        std::printf("command and answer, idle server: %.1f us median, %.1f p99\n", quantile(times, 0.5),
                    quantile(times, 0.99));
    }

    // Against what a frame takes from one to the next.
    void keys() {
        std::vector<double> first, following;
        ipc::Frame frame;
        for (int i = 0; i < 30; ++i) {
            ask("wait-idle");
            client_->readFrame(frame);
            const auto pressed = Clock::now();
            client_->pressKey(i % 2 == 0 ? 'W' : 'S');
            client_->waitForFrame(frame, 5s);
            auto last = Clock::now();
            first.push_back(milliseconds(last - pressed));
            for (int k = 0; k < 5; ++k) {
                client_->waitForFrame(frame, 5s);
                const auto now = Clock::now();
                following.push_back(milliseconds(now - last));
                last = now;
            }
            client_->releaseAllKeys();
        }
        ask("wait-idle");
        const double key = quantile(first, 0.5), each = quantile(following, 0.5);
        std::printf(
            "key to the first changed frame: %.1f ms median, %.1f p90; from frame to frame %.1f ms: %.2f "
            "frame times\n",
            key, quantile(first, 0.9), each, key / each);
    }

    void frames() {
        ask("resolution 1920 1080");
        ask("idle off");
        std::vector<double> times;
        ipc::Frame frame;
        while (times.size() < 60 && client_->waitForFrame(frame, 10s)) {
            const auto now = std::chrono::nanoseconds(Clock::now().time_since_epoch()).count();
            times.push_back(1e-6 * static_cast<double>(now - frame.info.nanoseconds));
        }
        std::printf("frame of 1920 x 1080 published to copied: %.2f ms median, %.2f p90\n",
                    quantile(times, 0.5), quantile(times, 0.9));
    }

    // The server's processor time for a frame, without clients and in a crowd, in turns. A process that only
    // spins takes the place of the one that floods, since whoever computes slows down its neighbours.
    void crowd() {
        ask("idle off");
        std::vector<double> alone, crowded;
        for (int round = 0; round < 3; ++round) {
            {
                const ChildProcess spinning([] {
                    while (std::time(nullptr) != 0) {
                    }
                });
                std::this_thread::sleep_for(500ms);
                alone.push_back(frameCost());
            }
            std::vector<ChildProcess> clients;
            for (int i = 0; i < 16; ++i) clients.emplace_back([this, i] { use(i); });
            std::this_thread::sleep_for(500ms);
            clients[0].send(SIGSTOP);
            crowded.push_back(frameCost());
        }
        const double one = quantile(alone, 0.5), many = quantile(crowded, 0.5);
        std::printf(
            "processor time for a frame: %.2f ms without clients, %.2f ms with 16, one of them stopped and "
            "one flooding: %+.1f%%\n",
            one, many, (many / one - 1) * 100);
    }

  private:
    void ask(const std::string& command) {
        const ipc::Reply reply = client_->request(command, 60s);
        if (reply.status != ipc::ReplyStatus::Done) throw std::runtime_error(command + ": " + reply.text);
    }

    void use(int number) {
        ipc::Client client(instance_.name());
        while (true) {
            if (number == 1) {
                client.send("get width");
                continue;
            }
            client.request("get width", 100ms);
            client.status();
            std::this_thread::sleep_for(50ms);
        }
    }

    double cpuSeconds() {
        std::ifstream file("/proc/" + std::to_string(client_->serverProcess()) + "/stat");
        std::string text;
        std::getline(file, text);
        std::istringstream fields(text.substr(text.rfind(')') + 2));
        std::string skipped;
        for (int i = 0; i < 11; ++i) fields >> skipped;
        double user = 0, system = 0;
        fields >> user >> system;
        return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
    }

    double frameCost() {
        ipc::Frame frame;
        client_->waitForFrame(frame, 10s);
        const std::uint64_t number = frame.info.number;
        const double before = cpuSeconds();
        std::this_thread::sleep_for(4s);
        const double spent = cpuSeconds() - before;
        client_->waitForFrame(frame, 10s);
        return 1000 * spent / static_cast<double>(frame.info.number - number);
    }

    test::IpcInstance instance_;
    test::RunningProgram server_;
    std::unique_ptr<ipc::Client> client_;
};

} // namespace

int main(int count, char** words) {
    try {
        const std::string scene = count > 1 ? words[1] : RT_SOURCE_FOLDER "/data/nave/nave.scn";
        {
            Bench bench(scene, 0);
            bench.commands();
            bench.keys();
            bench.frames();
        }
        Bench(scene, 1).crowd(); // threads that wait for each other spin, which is no work
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_server: %s\n", error.what());
        return 1;
    }
}
