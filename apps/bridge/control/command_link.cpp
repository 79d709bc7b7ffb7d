#include "bridge/control/command_link.h"

#include "common/cli/command_line.h"
#include "common/commands/command_lines.h"
#include "common/mirror/state_follower.h"
#include "common/process/error_sentence.h"
#include "common/process/seconds_since.h"
#include "common/process/thread_seconds.h"

#include "rtcore/io/text/sentence_json.h"
#include "rtcore/platform/sentence.h"

#include <chrono>
#include <condition_variable>
#include <list>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace bridge {

namespace {

using namespace std::chrono_literals;
using LinkClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kAnswerLook = 1ms, kStatusLook = 100ms, kSearch = 200ms,
                                    kIdleLook = 500ms;
constexpr auto kPatience = 60s;

ipc::Reply unanswered(ipc::ReplyStatus status, const rtcore::Sentence& why) {
    return {.status = status, .text = why.english(), .detail = rtcore::sentenceJson(why)};
}

/// The number at the start of the last line; `otherwise` when there is none.
std::uint32_t lastNumberOf(std::string_view lines, std::uint32_t otherwise) {
    if (lines.ends_with('\n')) lines.remove_suffix(1);
    const std::string_view last = lines.substr(lines.rfind('\n') + 1);
    const auto number = app::parseInteger(last.substr(0, last.find(' ')));
    return number ? static_cast<std::uint32_t>(*number) : otherwise;
}

} // namespace

struct CommandLink::State {
    State(std::string name, app::KeyRestraint held, ServerEvents take)
        : instance(std::move(name)), restraint(held), events(std::move(take)), thread([this] { run(); }) {}
    ~State() {
        {
            const std::lock_guard lock(mutex);
            stopping = true;
        }
        wake.notify_all();
        thread.join();
    }

    struct Request {
        std::string command;
        std::function<void(ipc::Reply)> done;
        ipc::Ticket ticket = 0; ///< 0: not sent yet
        LinkClock::time_point deadline;
    };

    void run();
    void waitForWork();
    bool takeRequests();
    void work();
    void watchOnly();
    void findServer();
    void tellServer(ServerLink now, const rtcore::Sentence& why = {});
    void dropInput();
    void moveKeys();
    void sendTurn();
    void sendRequests();
    void collectAnswers();
    void lookAtStatus();
    void askForState();
    void askForMessages(std::uint32_t count);
    void fail(const rtcore::Sentence& why);
    void ask(std::string command, std::function<void(ipc::Reply)> done);
    // Under the lock.
    void keysChanged() {
        if (!keysSince) keysSince = LinkClock::now();
    }
    void forgetInput() {
        taps.clear();
        right = up = 0;
    }

    const std::string instance;
    const app::KeyRestraint restraint;
    const ServerEvents events;

    mutable std::mutex mutex;
    std::condition_variable wake;
    bool stopping = false, anyone = false, news = true, wantsState = false;
    KeySet keys;
    std::vector<std::uint8_t> taps;
    double right = 0, up = 0;
    std::list<Request> incoming; ///< not seen by the thread yet
    CommandFigures counted;
    std::optional<LinkClock::time_point> keysSince; ///< the oldest change that the server does not know yet

    // Used by the thread alone.
    std::optional<ipc::Client> client;
    std::optional<ipc::Viewer> viewer;
    std::optional<ServerLink> told;
    KeySet pressed;
    std::list<Request> requests; ///< sent, or to be sent
    app::StateFollower follower;
    bool turning = false, messagesUnderWay = false;
    LinkClock::time_point lastStatus;
    std::optional<ipc::Status> status; ///< the last one that was told
    std::uint32_t knownMessages = 0;
    bool knowsMessages = false;
    std::uint64_t epoch = 0;
    std::string lastReport;
    bool tellsAgain = false; ///< also a report that equals the last one

    std::thread thread; // last: it uses all of the above
};

void CommandLink::State::run() {
    for (;;) {
        waitForWork();
        {
            const std::lock_guard lock(mutex);
            if (stopping) break;
            counted.cpuSeconds = app::threadSeconds();
        }
        try {
            takeRequests() ? work() : watchOnly();
        } catch (const ipc::Error& error) {
            client.reset();
            viewer.reset();
            fail(app::sentenceOf(error));
            tellServer(error.problem == ipc::Problem::NoServer ? ServerLink::Gone : ServerLink::Refused,
                       app::sentenceOf(error));
            dropInput();
            std::this_thread::sleep_for(kSearch);
        } catch (const std::exception& error) { // no memory
            client.reset();
            viewer.reset();
            fail(app::sentenceOf(error));
            std::this_thread::sleep_for(kSearch);
        }
    }
    takeRequests();
    fail(rtcore::say("the bridge ends"));
    client.reset();
}

/// Whether anyone is there, as of when the requests were taken: those of a page that comes a moment later
/// must not go the way of the last one's. Without anyone, what was tapped and turned goes, too.
bool CommandLink::State::takeRequests() {
    const std::lock_guard lock(mutex);
    requests.splice(requests.end(), incoming);
    if (!anyone) forgetInput();
    return anyone;
}

void CommandLink::State::waitForWork() {
    const bool answers = turning || !requests.empty();
    std::unique_lock lock(mutex);
    const auto longest = answers  ? LinkClock::duration(kAnswerLook)
                         : anyone ? LinkClock::duration(20ms)
                                  : LinkClock::duration(kIdleLook);
    wake.wait_for(lock, longest, [&] { return stopping || news; });
    news = false;
}

void CommandLink::State::watchOnly() {
    if (client) {
        client.reset();
        pressed.reset();
        lastReport.clear();
    }
    fail(rtcore::say("no page is open any more"));
    if (!viewer) viewer.emplace(instance, 0ns);
    const ipc::LinkState now = viewer->update();
    tellServer(now == ipc::LinkState::Gone   ? ServerLink::Gone
               : now == ipc::LinkState::Busy ? ServerLink::Busy
                                             : ServerLink::There);
}

/// Where there is none, this throws, and the next search is a moment later.
void CommandLink::State::findServer() {
    viewer.reset();
    if (client) return;
    client.emplace(instance, 0ns, static_cast<std::uint32_t>(restraint));
    pressed.reset();
}

/// Taps and turns from the time without a server must not reach the next one.
void CommandLink::State::dropInput() {
    const std::lock_guard lock(mutex);
    forgetInput();
}

void CommandLink::State::tellServer(ServerLink now, const rtcore::Sentence& why) {
    if (told == now) return;
    told = now;
    if (now == ServerLink::Gone || now == ServerLink::Refused) {
        lastReport.clear();
        status.reset();
        follower.forget();
        knowsMessages = false;
    }
    const bool gone = why.empty() && now == ServerLink::Gone;
    events.server(now, gone ? rtcore::say("no server '{0}' runs", instance) : why);
}

void CommandLink::State::work() {
    findServer();
    const ipc::LinkState now = client->update();
    if (client->epoch() != epoch && now != ipc::LinkState::Gone) {
        if (epoch != 0) tellServer(ServerLink::Gone); // the one before, seen to go or not
        epoch = client->epoch();
        const std::lock_guard lock(mutex);
        counted.epoch = epoch;
        wantsState = true;
    }
    tellServer(now == ipc::LinkState::Gone   ? ServerLink::Gone
               : now == ipc::LinkState::Busy ? ServerLink::Busy
                                             : ServerLink::There);
    moveKeys();
    sendTurn();
    lookAtStatus();
    askForState();
    sendRequests();
    collectAnswers();
}

void CommandLink::State::moveKeys() {
    KeySet wanted;
    std::vector<std::uint8_t> tapped;
    std::optional<LinkClock::time_point> since;
    {
        const std::lock_guard lock(mutex);
        wanted = keys;
        tapped.swap(taps);
        since.swap(keysSince);
    }
    for (int key = 0; key < 256; ++key) {
        const auto k = static_cast<std::size_t>(key);
        if (wanted[k] && !pressed[k]) client->pressKey(key);
        if (!wanted[k] && pressed[k]) client->releaseKey(key);
    }
    pressed = wanted;
    for (const std::uint8_t key : tapped) {
        client->pressKey(key);
        if (!pressed[key]) client->releaseKey(key);
    }
    if (!since) return;
    const std::lock_guard lock(mutex);
    counted.keys.add(app::secondsSince(*since));
}

void CommandLink::State::sendTurn() {
    if (turning) return;
    double byRight = 0, byUp = 0;
    {
        const std::lock_guard lock(mutex);
        std::swap(byRight, right);
        std::swap(byUp, up);
    }
    if (byRight == 0 && byUp == 0) return;
    constexpr double kMax = 360;
    turning = true;
    ask(app::command::cameraTurn(std::clamp(byRight, -kMax, kMax), std::clamp(byUp, -kMax, kMax)),
        [this](const ipc::Reply&) { turning = false; });
}

void CommandLink::State::ask(std::string command, std::function<void(ipc::Reply)> done) {
    requests.push_back({std::move(command), std::move(done), 0, LinkClock::now() + kPatience});
}

void CommandLink::State::lookAtStatus() {
    if (LinkClock::now() - lastStatus < kStatusLook) return;
    lastStatus = LinkClock::now();
    if (told == ServerLink::Gone) return;
    const ipc::Status now = client->status();
    follower.revision(now.stateRevision);
    if (knowsMessages && now.messages != knownMessages) askForMessages(now.messages);
    if (!knowsMessages) knownMessages = now.messages;
    knowsMessages = true;
    if (now == status) return;
    status = now;
    events.status(now);
}

void CommandLink::State::askForMessages(std::uint32_t count) {
    if (messagesUnderWay) return;
    messagesUnderWay = true;
    ask(app::command::messages(knownMessages), [this, count](const ipc::Reply& reply) {
        messagesUnderWay = false;
        const bool any = reply.status == ipc::ReplyStatus::Done && !reply.text.empty();
        knownMessages = any ? lastNumberOf(reply.text, count) : count; // more may have come meanwhile
        if (any) events.messages(reply.text, reply.detail);
    });
}

void CommandLink::State::askForState() {
    bool again = false;
    {
        const std::lock_guard lock(mutex);
        again = std::exchange(wantsState, false);
    }
    if (again) follower.want();
    tellsAgain = tellsAgain || again;
    if (told != ServerLink::There || !follower.asks()) return;
    ask(app::command::state(), [this](ipc::Reply reply) {
        if (!follower.answered(reply.status == ipc::ReplyStatus::Done)) return;
        const bool same = reply.text == lastReport;
        if (!std::exchange(tellsAgain, false) && same) return;
        lastReport = reply.text;
        events.state(std::move(reply.text));
    });
    if (!events.bindings) return;
    ask(app::command::bindings(), [this](ipc::Reply reply) {
        if (reply.status == ipc::ReplyStatus::Done) events.bindings(std::move(reply.text));
    });
}

void CommandLink::State::sendRequests() {
    for (Request& each : requests) {
        if (each.ticket != 0) continue;
        const ipc::SendStatus sent = client->send(each.command, &each.ticket);
        if (sent != ipc::SendStatus::Sent) each.ticket = 0;
        if (sent == ipc::SendStatus::NoServer) return fail(rtcore::say("there is no server"));
        if (sent == ipc::SendStatus::Full) return;
    }
}

void CommandLink::State::collectAnswers() {
    for (auto each = requests.begin(); each != requests.end();) {
        ipc::Reply reply =
            unanswered(ipc::ReplyStatus::TimedOut, rtcore::say("the server did not answer in time"));
        if (each->ticket != 0) reply = client->wait(each->ticket, 0ns);
        if (reply.status == ipc::ReplyStatus::TimedOut && LinkClock::now() < each->deadline) {
            ++each;
            continue;
        }
        const auto done = std::move(each->done);
        each = requests.erase(each);
        done(std::move(reply));
    }
}

void CommandLink::State::fail(const rtcore::Sentence& why) {
    std::list<Request> lost;
    lost.swap(requests);
    for (const Request& each : lost) each.done(unanswered(ipc::ReplyStatus::NotSent, why));
}

CommandLink::CommandLink(std::string instance, app::KeyRestraint restraint, ServerEvents events)
    : state_(std::make_unique<State>(std::move(instance), restraint, std::move(events))) {}

CommandLink::~CommandLink() = default;

namespace {

/// Changes something under the lock and wakes the thread.
template <typename Shared, typename Change>
void change(Shared& shared, Change&& apply) {
    {
        const std::lock_guard lock(shared.mutex);
        apply();
        shared.news = true;
    }
    shared.wake.notify_one();
}

} // namespace

void CommandLink::setAnyone(bool anyone) {
    change(*state_, [&] { state_->anyone = anyone; });
}
void CommandLink::setKeys(const KeySet& down) {
    change(*state_, [&] {
        if (state_->keys == down) return;
        state_->keys = down;
        state_->keysChanged();
    });
}
void CommandLink::tap(std::span<const std::uint8_t> keys) {
    change(*state_, [&] {
        state_->taps.insert(state_->taps.end(), keys.begin(), keys.end());
        state_->keysChanged();
    });
}
void CommandLink::turn(double right, double up) {
    change(*state_, [&] {
        state_->right += right;
        state_->up += up;
    });
}
void CommandLink::dropTurn() {
    change(*state_, [&] { state_->right = state_->up = 0; });
}
void CommandLink::request(std::string command, std::function<void(ipc::Reply)> done) {
    change(*state_, [&] {
        state_->incoming.push_back({std::move(command), std::move(done), 0, LinkClock::now() + kPatience});
    });
}
void CommandLink::refresh() {
    change(*state_, [&] { state_->wantsState = true; });
}
CommandFigures CommandLink::figures() const {
    const std::lock_guard lock(state_->mutex);
    return state_->counted;
}

} // namespace bridge
