// What the bridge costs, and how soon it reacts: each figure beside its goal.
//   bench_bridge [--seconds=N] [--rounds=N] [--scene=FILE] [--server=RTSERVER] [--only=PART]
// PART: encoders, input, browser, thirty, renderer. A server that publishes a frame of the scene at once, or
// 30 times a second, shows what is the bridge's alone; then RTServer draws every frame, for 0, 1 and 10
// viewers in turn.
#include "bench/bridge/bench_parts.h"

#include "ipc/endpoint/client.h"

#include <fmt/core.h>

namespace {

using namespace bridgebench;

struct Wishes {
    double seconds = 6;
    int rounds = 5;
    std::string scene = RT_SOURCE_FOLDER "/data/nave/nave.scn", server = RT_PROGRAM_FOLDER "/RTServer", only;

    bool wants(const std::string& part) const { return only.empty() || only == part; }
};

Wishes wishesOf(int argc, char** argv) {
    Wishes wishes;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const std::string value = word.substr(std::min(word.find('=') + 1, word.size()));
        if (word.starts_with("--seconds="))
            wishes.seconds = std::stod(value);
        else if (word.starts_with("--rounds="))
            wishes.rounds = std::stoi(value);
        else if (word.starts_with("--scene="))
            wishes.scene = value;
        else if (word.starts_with("--server="))
            wishes.server = value;
        else if (word.starts_with("--only="))
            wishes.only = value;
        else
            throw std::runtime_error("usage: bench_bridge [--seconds=N] [--rounds=N] [--scene=FILE] "
                                     "[--server=RTSERVER] [--only=PART]");
    }
    return wishes;
}

void measureAll(const Wishes& wishes) {
    const IpcInstance instance;
    const ChildProcess server(wishes.server,
                              {"--instance=" + instance.name(), "--resolution=1280x720", wishes.scene},
                              {.outputFile = (instance.folder() / "server.log").string()});
    ipc::Client client(instance.name(), 60s);
    client.request("set antialiasing 1", 60s);
    client.request("wait-idle", 60s);
    ipc::Frame frame;
    client.waitForFrame(frame, 10s);
    if (frame.info.width != kWidth || frame.info.height != kHeight)
        throw std::runtime_error("the renderer shows no frame of 1280 x 720");
    if (wishes.wants("encoders")) measureEncoders(frame.pixels);
    if (wishes.wants("input")) measureInput(frame.pixels);
    if (wishes.wants("browser")) measureBrowser(frame.pixels);
    if (wishes.wants("thirty")) measureAtThirty(frame.pixels, wishes.seconds);
    if (!wishes.wants("renderer")) return;
    client.request("idle off", 60s);
    client.request("frame-time off", 60s);
    measureRenderer(instance, wishes.seconds, wishes.rounds);
}

} // namespace

int main(int argc, char** argv) {
    try {
        measureAll(wishesOf(argc, argv));
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_bridge: {}\n", error.what());
        return 1;
    }
}
