/// Who meets RTServer in fault tests. Does its work for ever and reports to a board.
///   server_visitor talker|viewer|shell|junk|nonsense|waiter|spinner <instance> <board> <index>
/// talker: commands with answers, keys, and looks at frames. viewer: frames alone. shell: runs CUI again and
/// again, and kills some. junk: messages that are none, as fast as it can. nonsense: commands that are none.
/// waiter: commands that the server can only answer later; takes no answers. spinner: takes a processor, no
/// more.
#include "process/ipc/board.h"
#include "support/child_process.h"

#include "ipc/channel/message.h"
#include "ipc/endpoint/attachment.h"
#include "ipc/endpoint/client.h"
#include "ipc/endpoint/viewer.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <random>
#include <string>

namespace {

using namespace std::chrono_literals;

struct Visit {
    std::string instance;
    test::Board board;
    int index;
    std::mt19937 random{std::random_device()()};

    test::Counters& counters() { return board[index]; }
    unsigned below(unsigned count) { return static_cast<unsigned>(random() % count); }
    std::string number(double min, double max) {
        return std::to_string(std::uniform_real_distribution<double>(min, max)(random));
    }
    void complain(const std::string& what) {
        counters().wrong++;
        std::fprintf(stderr, "server_visitor %d: %s\n", index, what.c_str());
    }
};

// The scenes of these tests have one colour everywhere; the exposure changes it from frame to frame.
bool whole(const ipc::Frame& frame) {
    const std::size_t pixels = std::size_t{frame.info.width} * frame.info.height;
    return pixels > 0 && frame.pixels.size() == 4 * pixels &&
           std::memcmp(frame.pixels.data(), frame.pixels.data() + 4, 4 * (pixels - 1)) == 0;
}

// True for a new frame.
template <class Endpoint>
bool look(Endpoint& endpoint, ipc::Frame& frame, Visit& visit) {
    if (!endpoint.readFrame(frame)) return false;
    visit.counters().frames++;
    if (!whole(frame)) visit.counters().torn++;
    return true;
}

template <class Endpoint>
void meet(const Endpoint& endpoint, std::uint64_t& epoch, Visit& visit) {
    if (endpoint.epoch() != epoch) visit.counters().epochs++;
    epoch = endpoint.epoch();
}

std::string exposure(Visit& visit) { return "set exposure.value " + visit.number(0.1, 10); }
std::string resolution(Visit& visit) {
    return "resolution " + std::to_string(8 + visit.below(120)) + " " + std::to_string(8 + visit.below(90));
}

void talk(Visit& visit) {
    ipc::Client client(visit.instance);
    ipc::Frame frame;
    std::uint64_t epoch = 0;
    for (unsigned i = 0;; ++i) {
        // No other question has this answer.
        const std::string word = "w" + std::to_string(::getpid()) + "x" + std::to_string(i);
        const bool echo = visit.below(4) == 0;
        const std::string command = echo ? word : visit.below(30) == 0 ? resolution(visit) : exposure(visit);
        const ipc::Reply reply = client.request(command, 1s);
        const bool answered =
            reply.status == ipc::ReplyStatus::Done || reply.status == ipc::ReplyStatus::Failed;
        if (answered) visit.counters().progress++;
        if (answered && echo != (reply.text.find("'" + word + "'") != std::string::npos))
            visit.complain(command + ": " + reply.text);
        const int key = "WASD"[visit.below(4)];
        (i % 2 == 0) ? client.pressKey(key) : client.releaseAllKeys();
        look(client, frame, visit);
        meet(client, epoch, visit);
        ::usleep(visit.below(2000));
    }
}

void view(Visit& visit) {
    ipc::Viewer viewer(visit.instance);
    ipc::Frame frame;
    std::uint64_t epoch = 0;
    while (true) {
        if (look(viewer, frame, visit)) {
            visit.counters().progress++;
        } else {
            ::usleep(200);
        }
        meet(viewer, epoch, visit);
    }
}

struct Line {
    std::vector<std::string> words;
    int exitCode;
};

Line line(Visit& visit) {
    switch (visit.below(5)) {
    case 0:
        return {{"get", "exposure.value"}, 0};
    case 1:
        return {{"status", "--json"}, 0};
    case 2:
        return {{"set", "exposure.value", visit.number(0.1, 10)}, 0};
    case 3:
        return {{"light", "7", "on"}, 2};
    default:
        return {{"ping"}, 0};
    }
}

void useShell(Visit& visit) {
    constexpr int kTryAgain = 75;
    while (true) {
        Line next = line(visit);
        next.words.insert(next.words.begin(), {"--instance=" + visit.instance, "--timeout=2"});
        test::ChildProcess program(RT_PROGRAM_FOLDER "/CUI", next.words, {.outputFile = "/dev/null"});
        if (visit.below(4) == 0) {
            ::usleep(visit.below(12000));
            continue;
        }
        const int status = program.wait(5s);
        if (!WIFEXITED(status) || status == -1) {
            visit.complain("CUI " + next.words[2] + " hangs or crashed: " + std::to_string(status));
        } else if (WEXITSTATUS(status) == next.exitCode) {
            visit.counters().progress++;
        } else if (WEXITSTATUS(status) != kTryAgain) {
            visit.complain("CUI " + next.words[2] + " ends with " + std::to_string(WEXITSTATUS(status)));
        }
    }
}

std::string rubbish(Visit& visit, std::size_t max) {
    std::string text(visit.below(static_cast<unsigned>(max)), ' ');
    for (char& c : text) c = static_cast<char>(1 + visit.below(255));
    return text;
}

// Below the library's own checks: the queue itself is filled.
void sendJunk(Visit& visit) {
    const ipc::Names names(visit.instance);
    std::optional<ipc::Link> link = ipc::Link::open(names, ipc::Access::Write);
    if (!link) return;
    const int slot = ipc::takeSlot(names, *link);
    const ipc::KeyWriter keys;
    std::optional<ipc::Attachment> attachment;
    for (std::uint64_t sequence = 1; link->check() != ipc::LinkState::Gone; ++sequence) {
        if (!attachment || !attachment->accepted()) {
            attachment.reset();
            attachment.emplace(names, *link, slot, keys, 0U);
        }
        std::vector<std::byte> message =
            ipc::encode({sequence, true, rubbish(visit, 100)}, link->epoch() + visit.below(2));
        if (visit.below(2) == 0)
            message[visit.below(static_cast<unsigned>(message.size()))] ^= std::byte{0x40};
        if (visit.below(8) == 0) message.resize(visit.below(static_cast<unsigned>(message.size())) + 1);
        if (visit.below(8) == 0) message.resize(ipc::kMaxMessageBytes, std::byte{7});
        if (attachment->trySend(message) == ipc::QueueResult::Done) visit.counters().progress++;
    }
}

std::string nonsense(Visit& visit) {
    switch (visit.below(6)) {
    case 0:
        return rubbish(visit, ipc::kMaxCommandText);
    case 1:
        return std::string(ipc::kMaxCommandText, 'x');
    case 2:
        return "resolution " + std::to_string(visit.random()) + " " + std::to_string(visit.random());
    case 3:
        return "set " + rubbish(visit, 60) + " 3";
    case 4:
        return "camera set nan inf -1e300 1e39 0 " + rubbish(visit, 10);
    default:
        return "key press " + rubbish(visit, 1000);
    }
}

void sendNonsense(Visit& visit) {
    ipc::Client client(visit.instance);
    ipc::Ticket ticket = 0;
    while (true) {
        if (client.send(nonsense(visit), visit.below(2) == 0 ? &ticket : nullptr) == ipc::SendStatus::Sent)
            visit.counters().progress++;
    }
}

// Without any wish for an answer, so that nothing in the library bounds them.
void sendWhatWaits(Visit& visit) {
    ipc::Client client(visit.instance);
    while (true) {
        const std::string file = "screenshot /no/such/folder/" + std::string(4000, 'a') + ".png";
        for (const std::string& command : {exposure(visit), file, std::string("wait-idle")}) {
            if (client.send(command) == ipc::SendStatus::Sent) visit.counters().progress++;
        }
    }
}

void spin(Visit& visit) {
    while (true) visit.counters().progress++;
}

void visit(const std::string& role, Visit& visit) {
    if (role == "talker") talk(visit);
    if (role == "viewer") view(visit);
    if (role == "shell") useShell(visit);
    if (role == "junk") sendJunk(visit);
    if (role == "nonsense") sendNonsense(visit);
    if (role == "waiter") sendWhatWaits(visit);
    if (role == "spinner") spin(visit);
}

} // namespace

int main(int count, char** words) {
    if (count != 5) {
        std::fprintf(stderr, "usage: server_visitor <role> <instance> <board> <index>\n");
        return 2;
    }
    Visit all{words[2], test::Board(words[3]), std::atoi(words[4])};
    while (true) {
        try {
            visit(words[1], all);
        } catch (const ipc::Error& error) {
            // No server yet is everyday life here.
            if (error.problem == ipc::Problem::NoServer) continue;
            all.complain(error.what());
            return 1;
        }
    }
}
