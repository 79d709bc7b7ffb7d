#include "rtserver/commands/command_service.h"

#include "common/commands/command_lookup.h"

#include "rtcore/platform/sentence.h"
#include "rtcore/settings/plain_text.h"

#include <chrono>
#include <cstddef>
#include <exception>
#include <utility>

namespace rtserver {

namespace {

constexpr auto kPatience = std::chrono::seconds(1); ///< for files that are being written when the server ends
const rtcore::Sentence kPaused = rtcore::say("the server was paused");
constexpr std::size_t kMaxPending = 64; ///< of a client; then its further commands stay in its queue

bool isEnd(const ipc::Command& command) { return command.text == "quit" || command.text == "exit"; }

} // namespace

CommandService::CommandService(Workspace& state, Messages& messages, Services services)
    : state_(state), messages_(messages), services_(std::move(services)), requests_(services_.replies) {}

CommandService::~CommandService() {
    for (SideWork* const work : {&longWork_, &tellingWork_})
        work->stopWhere([](const ipc::Command&) { return true; });
    for (SideWork* const work : {&sideWork_, &longWork_, &tellingWork_}) work->waitFor(kPatience);
}

// --- Running ---

ipc::ClientSet CommandService::full() const {
    ipc::ClientSet full;
    for (const ipc::Command* command : commands_.ofClientsWith(kMaxPending)) {
        if (services_.replies.isConnected(*command)) full.set(static_cast<std::size_t>(command->slot));
    }
    return full;
}

void CommandService::add(std::vector<ipc::Command> commands) {
    for (ipc::Command& command : commands) commands_.add(std::move(command));
}

void CommandService::serve(std::vector<ipc::Command> commands) {
    for (const ipc::Command& command : commands) {
        // Not to be held up by a file that does not answer.
        if (isEnd(command) && commands_.isBeside(command.client)) services_.host.quit();
    }
    add(std::move(commands));
    commands_.forgetWaiting([this](const ipc::Command& command) {
        return command.wantsAnswer && !services_.replies.isConnected(command);
    });
    commands_.serve([this](const ipc::Command& command) {
        return services_.host.quits() ? Served::Again : serveOne(command);
    });
}

Served CommandService::serveOne(const ipc::Command& command) {
    Served served = Served::Done;
    answerBy(command, [&] {
        return begin(command, runCommand(command.text, state_, services_.host, command.client), served);
    });
    return served;
}

// The answer, if it is there. `served` stays Done where it comes later without the command.
std::optional<Answer> CommandService::begin(const ipc::Command& command, Result result, Served& served) {
    switch (result.when) {
    case ReplyWhen::Done:
        return Answer{std::move(result.answer), std::move(result.detail)};
    case ReplyWhen::Again:
        served = Served::Again;
        break;
    case ReplyWhen::Beside:
        sideWork_.start(command, std::move(result.work));
        served = Served::Beside;
        break;
    case ReplyWhen::Apart:
        startApart(command, std::move(result));
        break;
    case ReplyWhen::WhenIdle:
        requests_.addForIdle(command);
        break;
    case ReplyWhen::WhenLoaded:
        requests_.addForLoad(command);
        break;
    case ReplyWhen::WhenReleased:
        requests_.addForKey(command, result.press);
        break;
    }
    return std::nullopt;
}

void CommandService::finishSideWork() {
    for (const SideWork::Done& done : sideWork_.takeDone()) {
        answerBy(done.command, [&] { return std::optional(done.finish()); });
        commands_.resume(done.command.client);
    }
    // A client that has left, by Ctrl-C for example, takes no answer any more.
    const auto left = [this](const ipc::Command& command) {
        return command.wantsAnswer && !services_.replies.isConnected(command);
    };
    longWork_.stopWhere(left);
    tellingWork_.stopWhere(left);
    answerTelling();
    for (const SideWork::Done& done : longWork_.takeDone())
        answerBy(done.command, [&] { return std::optional(done.finish()); });
}

// --- Answering ---

// Nothing: the answer comes later.
void CommandService::answerBy(const ipc::Command& command, const Act& act) {
    try {
        const std::optional<Answer> answer = act();
        if (!answer) return;
        services_.publishStatus();
        services_.replies.answer(command, answer->text, answer->detail);
    } catch (const std::exception& error) {
        refuseFor(command, error);
    }
}

void CommandService::loaded(const std::optional<Failure>& failure) {
    if (failure) return requests_.loadFailed(failure->code, failure->why);
    if (requests_.waitsForLoad()) services_.publishStatus();
    requests_.loaded();
}

void CommandService::answerRequests(bool idle) {
    const auto release = [this](std::uint64_t press) { state_.walk.keyboard().endPress(press); };
    if (requests_.waitForKeys()) {
        services_.publishStatus();
        requests_.answerReleased([this](std::uint64_t press) { return state_.walk.keyboard().isDown(press); },
                                 release);
    }
    if (state_.paused) requests_.refuseKeys(app::ExitCode::Failed, kPaused, release);
    if (state_.paused || !state_.idles)
        requests_.refuseIdle(app::ExitCode::Failed,
                             state_.paused ? kPaused : rtcore::say("idling was turned off"));
    if (!idle || !requests_.waitForIdle()) return;
    services_.publishStatus();
    requests_.idle();
}

void CommandService::refuseWaiting(const rtcore::Sentence& why) {
    requests_.refuseIdle(app::ExitCode::TryAgain, why);
    refuseAll(commands_.takeWaiting(), why);
}

void CommandService::refuseObstructing(const rtcore::Sentence& why) {
    refuseAll(commands_.takeObstructing(), why);
}

void CommandService::refuseFor(const ipc::Command& command, const std::exception& error) {
    const Failure failure = failureOf(error);
    services_.replies.refuse(command, failure.code, failure.why);
    if (!command.wantsAnswer)
        messages_.complain(
            rtcore::say("{0}: {1}", rtcore::inQuotes(command.text), rtcore::sentenceOf(error)));
}

void CommandService::refuseAll(const std::vector<ipc::Command>& commands, const rtcore::Sentence& why) {
    for (const ipc::Command& command : commands)
        services_.replies.refuse(command, static_cast<int>(app::ExitCode::TryAgain), why);
}

// --- While a frame is drawn ---

Arrivals CommandService::addDuringFrame(std::vector<ipc::Command> commands) {
    Arrivals arrivals;
    answerTelling();
    for (ipc::Command& command : commands) {
        const app::CommandEffect effect = app::effectOf(command.text);
        // What an image shows, the thread that traces it reads: these change nothing of that.
        const bool aside = effect == app::CommandEffect::Tells || effect == app::CommandEffect::Keeps;
        const bool waits = effect == app::CommandEffect::Waits, first = !commands_.hasMore(command.client);
        if (aside && first) {
            tell(command);
            continue;
        }
        arrivals.end = arrivals.end || isEnd(command);
        arrivals.change = arrivals.change || (!aside && !waits && first);
        commands_.add(std::move(command));
    }
    arrivals.change = arrivals.change || sideWork_.anyDone() || longWork_.anyDone();
    arrivals.obstructed = commands_.obstructs();
    return arrivals;
}

// The status stays as it is: it tells of the frame that is drawn, too.
void CommandService::tell(const ipc::Command& command) {
    try {
        Result result = runCommand(command.text, state_, services_.host, command.client);
        if (result.when == ReplyWhen::Apart) return startApart(command, std::move(result));
        services_.replies.answer(command, result.answer, result.detail);
    } catch (const std::exception& error) {
        refuseFor(command, error);
    }
}

void CommandService::startApart(const ipc::Command& command, Result result) {
    const bool tells = app::effectOf(command.text) == app::CommandEffect::Tells;
    (tells ? tellingWork_ : longWork_)
        .start(command, std::move(result.work), std::move(result.stop), result.shared);
}

// What is told needs no state any more.
void CommandService::answerTelling() {
    for (const SideWork::Done& done : tellingWork_.takeDone()) {
        try {
            const Answer answer = done.finish();
            services_.replies.answer(done.command, answer.text, answer.detail);
        } catch (const std::exception& error) {
            refuseFor(done.command, error);
        }
    }
}

} // namespace rtserver
