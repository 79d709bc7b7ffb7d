/// A server, client or viewer for fault tests. It does its work for ever and reports to a board.
///   ipc_participant server|client|flood|viewer <instance> <board> <index> [name=value...]
/// Options of a server: pause=<us> between frames, side=<pixels>, resize=<frames>, patience=<ms>, idle=1 (no
/// frames). The environment variable RT_DIE_AT=<stage>:<n> has it killed the n-th time that it passes the
/// stage, or stopped with :stop behind it.
#include "board.h"

#include "ipc/endpoint/client.h"
#include "ipc/endpoint/server.h"

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <map>
#include <string>
#include <thread>

#include <csignal>
#include <unistd.h>

namespace {

volatile std::sig_atomic_t stopped = 0;

struct Arguments {
    std::string instance;
    test::Board board;
    int index;
    std::map<std::string, int> options;
    int option(const std::string& name, int otherwise) const {
        const auto found = options.find(name);
        return found == options.end() ? otherwise : found->second;
    }
    test::Counters& counters() { return board[index]; }
};

std::uint32_t pixel(std::uint64_t tag, std::size_t i) {
    return static_cast<std::uint32_t>(tag * 2654435761u + i);
}

void draw(std::span<std::byte> pixels, std::uint64_t tag) {
    for (std::size_t i = 0; i < pixels.size() / 4; ++i) {
        const std::uint32_t value = pixel(tag, i);
        std::memcpy(pixels.data() + 4 * i, &value, 4);
    }
}

bool whole(const ipc::Frame& frame) {
    if (frame.pixels.size() != std::size_t{4} * frame.info.width * frame.info.height) return false;
    for (std::size_t i = 0; i < frame.pixels.size() / 4; ++i) {
        std::uint32_t value = 0;
        std::memcpy(&value, frame.pixels.data() + 4 * i, 4);
        if (value != pixel(frame.info.tag, i)) return false;
    }
    return true;
}

ipc::Status statusOf(std::uint64_t number) {
    const auto value = static_cast<double>(number);
    return {.frameSeconds = value, .framesPerSecond = value, .raysPerSecond = value, .polygons = number};
}
bool whole(const ipc::Status& status) { return status == statusOf(status.polygons); }

// False: exit.
bool obey(ipc::Server& server, const ipc::Command& command) {
    const std::string& text = command.text;
    if (text.starts_with("stall "))
        std::this_thread::sleep_for(std::chrono::milliseconds(std::atoi(text.c_str() + 6)));
    server.answer(command, text);
    return text != "exit";
}

int serve(Arguments& arguments) {
    const int side = arguments.option("side", 64), pause = arguments.option("pause", 200);
    const int resize = arguments.option("resize", 0);
    ipc::Server server({.instance = arguments.instance,
                        .width = static_cast<std::uint32_t>(side),
                        .height = static_cast<std::uint32_t>(side),
                        .patience = std::chrono::milliseconds(arguments.option("patience", 2000))});
    std::uint64_t number = 0;
    while (stopped == 0) {
        for (const ipc::Command& command : server.takeCommands()) {
            if (!obey(server, command)) return 0;
        }
        server.keys();
        ++number;
        if (arguments.option("idle", 0) == 0) {
            const auto grown =
                resize == 0 ? 0u : static_cast<std::uint32_t>(number / static_cast<unsigned>(resize));
            const std::uint32_t extra = resize == 0 ? 0 : grown * 37 % 301;
            const auto width = static_cast<std::uint32_t>(side) + extra;
            draw(server.beginFrame(width, width / 2 + 1), number);
            server.publishFrame({.tag = number});
        }
        server.setStatus(statusOf(number));
        arguments.counters().progress++;
        if (pause > 0) server.wait(std::chrono::microseconds(pause));
    }
    return 0;
}

template <class Endpoint>
void look(Endpoint& endpoint, ipc::Frame& frame, Arguments& arguments) {
    if (!whole(endpoint.status())) arguments.counters().torn++;
    if (!endpoint.readFrame(frame)) return;
    arguments.counters().frames++;
    if (!whole(frame)) arguments.counters().torn++;
}

template <class Endpoint>
void meet(const Endpoint& endpoint, std::uint64_t& epoch, Arguments& arguments) {
    if (endpoint.epoch() != epoch) arguments.counters().epochs++;
    epoch = endpoint.epoch();
}

void command(Arguments& arguments) {
    ipc::Client client(arguments.instance);
    ipc::Frame frame;
    std::uint64_t epoch = 0;
    for (unsigned i = 0; stopped == 0; ++i) {
        const std::string question = "echo " + std::to_string(::getpid()) + " " + std::to_string(i);
        const ipc::Reply reply = client.request(question, std::chrono::seconds(1));
        if (reply.status == ipc::ReplyStatus::Done) {
            if (reply.text != question) arguments.counters().wrong++;
            arguments.counters().progress++;
        } else if (reply.status == ipc::ReplyStatus::TimedOut) {
            arguments.counters().timeouts++;
        }
        (i % 2 == 0) ? client.pressKey(static_cast<int>(i % 256))
                     : client.releaseKey(static_cast<int>((i - 1) % 256));
        look(client, frame, arguments);
        meet(client, epoch, arguments);
        if (arguments.option("pause", 100) > 0)
            ::usleep(static_cast<unsigned>(arguments.option("pause", 100)));
    }
}

// Sends as fast as it can; a full queue must be told at once.
void flood(Arguments& arguments) {
    ipc::Client client(arguments.instance);
    while (stopped == 0) {
        if (client.send("flood") == ipc::SendStatus::Sent) arguments.counters().progress++;
    }
}

void watch(Arguments& arguments) {
    ipc::Viewer viewer(arguments.instance);
    ipc::Frame frame;
    std::uint64_t epoch = 0;
    while (stopped == 0) {
        const std::uint64_t before = arguments.counters().frames;
        look(viewer, frame, arguments);
        meet(viewer, epoch, arguments);
        if (arguments.counters().frames != before) {
            arguments.counters().progress++;
        } else {
            ::usleep(100);
        }
    }
}

int run(const std::string& role, Arguments& arguments) {
    if (role == "server") return serve(arguments);
    while (stopped == 0) {
        try {
            if (role == "client") command(arguments);
            if (role == "flood") flood(arguments);
            if (role == "viewer") watch(arguments);
        } catch (const ipc::Error& error) {
            // No server yet is everyday life here.
            if (error.problem != ipc::Problem::NoServer || arguments.option("once", 0) == 1) throw;
        }
    }
    return 0;
}

// NAME=VALUE arguments after the four fixed ones.
std::map<std::string, int> options(int count, char** words) {
    std::map<std::string, int> all;
    for (int i = 0; i < count; ++i) {
        const std::string word = words[i];
        const std::size_t equals = word.find('=');
        if (equals != std::string::npos) all[word.substr(0, equals)] = std::atoi(word.c_str() + equals + 1);
    }
    return all;
}

} // namespace

namespace ipc {

void faultPoint(const char* name) {
    static const std::string wish = std::getenv("RT_DIE_AT") == nullptr ? "" : std::getenv("RT_DIE_AT");
    static const std::size_t colon = wish.find(':');
    static int left = colon == std::string::npos ? 0 : std::atoi(wish.c_str() + colon + 1);
    if (left > 0 && wish.compare(0, colon, name) == 0 && --left == 0) {
        ::raise(wish.ends_with(":stop") ? SIGSTOP : SIGKILL);
    }
}

} // namespace ipc

int main(int count, char** words) {
    if (count < 5) {
        std::fprintf(stderr,
                     "usage: ipc_participant server|client|flood|viewer <instance> <board> <index> [...]\n");
        return 2;
    }
    std::signal(SIGTERM, [](int) { stopped = 1; });
    try {
        Arguments arguments{words[2], test::Board(words[3]), std::atoi(words[4]),
                            options(count - 5, words + 5)};
        return run(words[1], arguments);
    } catch (const ipc::Error& error) {
        std::fprintf(stderr, "ipc_participant: %s\n", error.what());
        const bool again = error.problem == ipc::Problem::AlreadyRunning ||
                           error.problem == ipc::Problem::NoSpace ||
                           error.problem == ipc::Problem::NoServer || error.problem == ipc::Problem::NoSlot;
        return again ? 75 : error.problem == ipc::Problem::NotYours ? 77 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "ipc_participant: %s\n", error.what());
        return 1;
    }
}
