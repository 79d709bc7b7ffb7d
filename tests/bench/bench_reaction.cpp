// How soon RTServer shows that something changed, whatever it is drawing: keys, settings, lights, parts,
// scenes.
//   bench_reaction [--keys=N] [--settings=N] [--lights=N] [--parts=N] [--loads=N] [--seed=N] [--size=WxH]
//                  [--scene=FILE] [--turns=FILE] [--each] [SERVER]...
// Each SERVER is an RTServer, such as one of before a change; they take turns, so that whatever else the
// machine does hits all alike. Without one: the one that was built. With the same FILE several
// bench_reactions take turns, too: each speaks one version of the protocol.
#include "ipc/endpoint/client.h"
#include "support/ipc_instance.h"
#include "support/quantile.h"
#include "support/run_program.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace {

using namespace std::chrono_literals;
using ipc::Clock;
using test::quantile;

constexpr double kFrameTime = 33; ///< ms
constexpr auto kLongest = 5s;     ///< an image that does not come in this time counts as this long
constexpr int kOneTurn = 20;      ///< measurements of one server, then it is the next one's turn

struct Wishes {
    int keys = 500, settings = 100, lights = 100, parts = 0, loads = 10;
    unsigned seed = 1;
    std::string size = "1920x1080";
    std::string scene = RT_SOURCE_FOLDER "/data/nave/nave.scn";
    bool each = false; ///< each is told
    std::string turns; ///< a file; "" = nobody else measures
    std::vector<std::string> servers;
};

/// As long as it lives, no other bench_reaction with the same file has one.
class Turn {
  public:
    explicit Turn(const std::string& path) {
        if (path.empty()) return;
        file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
        if (file_ < 0 || ::flock(file_, LOCK_EX) != 0) throw std::runtime_error("cannot lock " + path);
    }
    ~Turn() {
        if (file_ < 0) return;
        ::close(file_);
        std::this_thread::sleep_for(200ms); // so that the others have theirs
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

  private:
    int file_ = -1;
};

double milliseconds(Clock::duration time) { return std::chrono::duration<double, std::milli>(time).count(); }

/// Settings that are turned on and off, expensive ones among them.
constexpr std::array<const char*, 20> kSettings{"ambientOcclusion.on true",
                                                "ambientOcclusion.samples 4096",
                                                "ambientOcclusion.samples 9",
                                                "ambientOcclusion.on false",
                                                "antialiasing 16",
                                                "antialiasing 1",
                                                "shadows false",
                                                "shadows true",
                                                "depthOfField.on true",
                                                "depthOfField.on false",
                                                "areaLights.samples 64",
                                                "areaLights.samples 4",
                                                "exposure.key 0.4",
                                                "exposure.key 0.18",
                                                "maxDepth 0",
                                                "maxDepth 5",
                                                "textures false",
                                                "textures true",
                                                "toneMapping channels",
                                                "toneMapping luminance"};

class Measured {
  public:
    Measured(const Wishes& wishes, const test::IpcInstance& instance, std::string program, int number)
        : wishes_(wishes), program_(std::move(program)),
          name_(instance.name() + "-" + std::to_string(number)) {
        start();
    }

    void keys(int count, std::mt19937& random) {
        std::uniform_int_distribution<int> walks(100, 1000), stands(0, 2500);
        for (int i = 0; i < count; ++i, forwards_ = !forwards_) {
            const int key = forwards_ ? 'W' : 'S';
            keys_.push_back(reaction([&] { client_->pressKey(key); }, true));
            tellEach("key", keys_.back());
            std::this_thread::sleep_for(std::chrono::milliseconds(walks(random)));
            client_->releaseKey(key);
            std::this_thread::sleep_for(std::chrono::milliseconds(stands(random)));
        }
    }

    void settings(int count, std::mt19937& random) {
        std::uniform_int_distribution<int> stands(0, 2500);
        for (int i = 0; i < count; ++i) {
            const std::string command = std::string("set ") + kSettings[setting_++ % kSettings.size()];
            settings_.push_back(reaction([&] { client_->send(command); }, false));
            tellEach(command.c_str(), settings_.back());
            const bool stuck = settings_.size() > 1 && settings_.back() >= milliseconds(kLongest) &&
                               settings_[settings_.size() - 2] >= milliseconds(kLongest);
            if (stuck) start();
            std::this_thread::sleep_for(std::chrono::milliseconds(stands(random)));
        }
    }

    /// A light that a hand drags, beside the camera.
    void lights(int count, std::mt19937& random) {
        std::uniform_int_distribution<int> rests(0, 150);
        std::uniform_real_distribution<double> places(-1, 1);
        if (light_.empty()) light_ = client_->request("light add point here", 60s).text;
        for (int i = 0; i < count; ++i) {
            const std::string command = "also light move " + light_ + " at " +
                                        std::to_string(places(random)) + " 2 " +
                                        std::to_string(places(random));
            lights_.push_back(reaction([&] { client_->send(command); }, false));
            tellEach(command.c_str(), lights_.back());
            std::this_thread::sleep_for(std::chrono::milliseconds(rests(random)));
        }
    }

    /// Every second one is hidden, then all are shown again.
    void parts(int count, std::mt19937& random) {
        std::uniform_int_distribution<int> stands(0, 2500);
        for (int i = 0; i < count; ++i) {
            const std::string command = i % 2 == 0 ? "part hide " + everySecondPart(i / 2) : "part show-all";
            parts_.push_back(reaction([&] { client_->send(command); }, false));
            tellEach(i % 2 == 0 ? "part hide ..." : "part show-all", parts_.back());
            std::this_thread::sleep_for(std::chrono::milliseconds(stands(random)));
        }
    }

    // From the end of loading.
    void loads(int count) {
        for (int i = 0; i < count; ++i) {
            ipc::Frame frame;
            client_->readFrame(frame);
            if (client_->request("load scene \"" + wishes_.scene + "\"", 120s).status !=
                ipc::ReplyStatus::Done)
                throw std::runtime_error("the scene is not loaded again");
            const Clock::time_point loaded = Clock::now();
            loads_.push_back(client_->waitForFrame(frame, kLongest)
                                 ? milliseconds(publishedAt(frame) - loaded)
                                 : milliseconds(kLongest));
        }
    }

    void report() const {
        std::printf("%s\n", program_.c_str());
        tell("key to the first changed image", keys_);
        tell("setting to the first changed image", settings_);
        tell("light to the first changed image", lights_);
        tell("parts to the first changed image", parts_);
        tell("end of loading to the first image", loads_);
    }

  private:
    void start() {
        client_.reset();
        server_.reset();
        server_ = std::make_unique<test::RunningProgram>(
            program_,
            std::vector<std::string>{wishes_.scene, "--instance=" + name_, "--resolution=" + wishes_.size,
                                     "--frame-time=33"},
            test::ProgramSettings{.timeoutSeconds = 36000});
        if (!server_->waitForError("ready: ")) throw std::runtime_error(server_->wait().error);
        client_ = std::make_unique<ipc::Client>(name_);
        client_->request("walk", 60s);
        client_->request("wait-idle", 60s);
        light_.clear();
    }

    /// Numbers of every second one of the model's first hundred parts, so that a command holds them.
    std::string everySecondPart(int from) {
        const std::string listed = client_->request("parts", 60s).text;
        const auto lines = 1 + std::count(listed.begin(), listed.end(), '\n');
        std::string numbers;
        for (long i = 1; i <= std::min(lines, 100L); ++i) {
            if ((i + from) % 2 == 0) numbers += (numbers.empty() ? "" : " ") + std::to_string(i);
        }
        return numbers;
    }

    static Clock::time_point publishedAt(const ipc::Frame& frame) {
        return Clock::time_point(std::chrono::nanoseconds(frame.info.nanoseconds));
    }

    // The status follows its frame, a little later where others compute. Two frames never take equally long.
    ipc::Status statusOfNextFrame() {
        const Clock::time_point end = Clock::now() + 20ms;
        ipc::Status now = client_->status();
        while (now.frameSeconds == frameSeconds_ && Clock::now() < end) {
            std::this_thread::sleep_for(200us);
            now = client_->status();
        }
        frameSeconds_ = now.frameSeconds;
        return now;
    }

    static bool sameView(const ipc::Status& a, const ipc::Status& b) {
        return std::equal(std::begin(a.eye), std::end(a.eye), std::begin(b.eye)) &&
               std::equal(std::begin(a.forward), std::end(a.forward), std::begin(b.forward));
    }

    // To the first frame that was begun after the change - and, of a key, shows another view. A frame that
    // was begun before may move, but does not show the change.
    template <typename Change>
    double reaction(const Change& change, bool moves) {
        ipc::Frame frame;
        client_->readFrame(frame);
        const ipc::Status before = client_->status();
        frameSeconds_ = before.frameSeconds;
        const Clock::time_point start = Clock::now();
        change();
        while (Clock::now() - start < kLongest) {
            if (!client_->waitForFrame(frame, 100ms)) continue;
            const ipc::Status now = statusOfNextFrame();
            const auto took = std::chrono::duration<double>(now.frameSeconds);
            const bool later = publishedAt(frame) - took >= start;
            if (later && !(moves && sameView(now, before))) return milliseconds(publishedAt(frame) - start);
        }
        return milliseconds(kLongest);
    }

    void tellEach(const char* what, double time) const {
        if (wishes_.each) std::printf("    %-34s %6.1f ms\n", what, time);
    }

    static void tell(const char* what, const std::vector<double>& times) {
        if (times.empty()) return;
        const auto late =
            std::count_if(times.begin(), times.end(), [](double time) { return time > 2 * kFrameTime; });
        std::printf("  %-38s %4zu times: median %6.1f ms, 90 %% %6.1f, 99 %% %6.1f, most %6.1f; "
                    "later than two frame times: %.1f %%\n",
                    what, times.size(), quantile(times, 0.5), quantile(times, 0.9), quantile(times, 0.99),
                    quantile(times, 1), 100 * static_cast<double>(late) / static_cast<double>(times.size()));
    }

    const Wishes& wishes_;
    std::string program_, name_;
    std::unique_ptr<test::RunningProgram> server_;
    std::unique_ptr<ipc::Client> client_;
    bool forwards_ = true;
    double frameSeconds_ = 0; ///< of the last frame that was looked at
    std::size_t setting_ = 0;
    std::vector<double> keys_, settings_, lights_, parts_, loads_;
    std::string light_; ///< its id
};

void tellLoad() {
    std::array<double, 3> load{};
    if (::getloadavg(load.data(), 3) < 1) return;
    std::printf("load %.1f on %u processors\n", load[0], std::thread::hardware_concurrency());
    std::fflush(stdout);
}

Wishes read(int count, char** words) {
    Wishes wishes;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals);
        const std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
        if (name == "--keys")
            wishes.keys = std::stoi(value);
        else if (name == "--settings")
            wishes.settings = std::stoi(value);
        else if (name == "--lights")
            wishes.lights = std::stoi(value);
        else if (name == "--parts")
            wishes.parts = std::stoi(value);
        else if (name == "--loads")
            wishes.loads = std::stoi(value);
        else if (name == "--seed")
            wishes.seed = static_cast<unsigned>(std::stoi(value));
        else if (name == "--size")
            wishes.size = value;
        else if (name == "--scene")
            wishes.scene = value;
        else if (name == "--each")
            wishes.each = true;
        else if (name == "--turns")
            wishes.turns = value;
        else
            wishes.servers.push_back(word);
    }
    if (wishes.servers.empty()) wishes.servers.emplace_back(RT_PROGRAM_FOLDER "/RTServer");
    return wishes;
}

void measure(const Wishes& wishes) {
    const test::IpcInstance instance;
    std::vector<std::unique_ptr<Measured>> all;
    for (const std::string& program : wishes.servers) {
        const Turn turn(wishes.turns);
        all.push_back(std::make_unique<Measured>(wishes, instance, program, static_cast<int>(all.size())));
    }
    std::mt19937 random(wishes.seed);
    const auto inTurns = [&](int count, const auto& part) {
        for (int left = count; left > 0; left -= kOneTurn) {
            for (const auto& one : all) {
                const Turn turn(wishes.turns);
                part(*one, std::min(left, kOneTurn));
            }
            tellLoad();
        }
    };
    inTurns(wishes.keys, [&](Measured& one, int count) { one.keys(count, random); });
    inTurns(wishes.settings, [&](Measured& one, int count) { one.settings(count, random); });
    inTurns(wishes.lights, [&](Measured& one, int count) { one.lights(count, random); });
    inTurns(wishes.parts, [&](Measured& one, int count) { one.parts(count, random); });
    inTurns(wishes.loads, [&](Measured& one, int count) { one.loads(count); });
    for (const auto& one : all) one->report();
}

} // namespace

int main(int count, char** words) {
    try {
        measure(read(count, words));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_reaction: %s\n", error.what());
        return 1;
    }
}
