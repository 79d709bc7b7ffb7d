// The cost of the bridge, and how soon it reacts: each figure beside its goal.
//   bench_bridge [--seconds=N] [--rounds=N] [--scene=FILE] [--server=RTSERVER] [--only=PART]
// PART: encoders, input, browser, thirty, renderer. A server that publishes a frame of the scene at once, or
// 30 times a second, shows the bridge's own cost; then RTServer draws every frame, for 0, 1 and 10 viewers in
// turn. Where RT_TEST_SCENES names a folder with models, encoders meet Sponza, too.
#include "bench/bridge/bench_parts.h"
#include "bench/bridge/goals.h"

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

/// A renderer of a scene, at rest.
struct Renderer {
    Renderer(const std::string& server, const std::string& scene)
        : process(server, {"--instance=" + instance.name(), "--resolution=1280x720", scene},
                  {.outputFile = (instance.folder() / "server.log").string()}),
          client(instance.name(), 60s) {
        client.request("set antialiasing 1", 60s);
    }
    PixelBytes pixels() {
        client.request("wait-idle", 60s);
        ipc::Frame frame;
        client.waitForFrame(frame, 10s);
        if (frame.info.width != kWidth || frame.info.height != kHeight)
            throw std::runtime_error("the renderer shows no frame of 1280 x 720");
        return frame.pixels;
    }

    const IpcInstance instance;
    const ChildProcess process;
    ipc::Client client;
};

void measureSponza(const std::string& server) {
    const char* const scenes = std::getenv("RT_TEST_SCENES");
    if (scenes == nullptr) return tellMissing("rung 1 of Sponza", "RT_TEST_SCENES is not set");
    Renderer renderer(server, std::string(scenes) + "/sponza_crytek/sponza.obj");
    renderer.client.request("camera look-at -1100 350 -40 800 350 0", 60s);
    measureEncoders("Sponza", renderer.pixels(), 2.0);
}

void measureAll(const Wishes& wishes) {
    if (wishes.wants("encoders")) measureSponza(wishes.server);
    Renderer renderer(wishes.server, wishes.scene);
    const PixelBytes pixels = renderer.pixels();
    if (wishes.wants("encoders")) measureEncoders("the scene", pixels, 2.6);
    if (wishes.wants("input")) measureInput(pixels);
    if (wishes.wants("browser")) measureBrowser(pixels);
    if (wishes.wants("thirty")) measureAtThirty(pixels, wishes.seconds);
    if (!wishes.wants("renderer")) return;
    renderer.client.request("idle off", 60s);
    renderer.client.request("frame-time off", 60s);
    measureRenderer(renderer.instance, wishes.seconds, wishes.rounds);
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
