#include "bridge/stream/frame_source.h"

#include "bridge/clock.h"
#include "bridge/stream/motion_encoder.h"
#include "bridge/stream/rest.h"
#include "bridge/stream/still_encoder.h"

#include "common/process/background.h"
#include "common/process/seconds_since.h"
#include "common/process/thread_seconds.h"

#include "ipc/endpoint/client.h"
#include "ipc/layout/limits.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <random>
#include <thread>
#include <utility>
#include <vector>

namespace bridge {

namespace {

using namespace std::chrono_literals;
using FrameClock = std::chrono::steady_clock;

/// A frame that other threads may read, too.
struct HeldFrame {
    std::shared_ptr<const ipc::Frame> frame;
    bool isPreview = false; ///< of a Renderer; else it is the server's

    explicit operator bool() const { return frame != nullptr; }
    const ipc::Frame* operator->() const { return frame.get(); }
    const ipc::Frame& operator*() const { return *frame; }
};

constexpr auto kBetweenFrames = 1000000us / 60;
constexpr auto kSlice = 10ms;     ///< longest wait for a frame: demands change meanwhile
constexpr auto kRestSlice = 25ms; ///< between looks at a picture that rests and improves
constexpr auto kRetry = 200ms;    ///< to find a server

Pixels pixelsOf(const ipc::Frame& frame) {
    return {frame.pixels, static_cast<int>(frame.info.width), static_cast<int>(frame.info.height)};
}

FrameStep stepOf(const ipc::Frame& frame, const ipc::Status& status) {
    FrameStep step{.epoch = frame.epoch,
                   .run = frame.info.run,
                   .width = frame.info.width,
                   .height = frame.info.height,
                   .samples = frame.info.samples,
                   .tag = frame.info.tag};
    std::copy_n(status.eye, 3, step.view.begin());
    std::copy_n(status.forward, 3, step.view.begin() + 3);
    return step;
}

bool isUsable(const ipc::Frame& frame) {
    const ipc::FrameInfo& info = frame.info;
    return info.width > 0 && info.height > 0 && info.width <= ipc::kMaxFrameSide &&
           info.height <= ipc::kMaxFrameSide &&
           frame.pixels.size() >= std::size_t(4) * info.width * info.height;
}

} // namespace

struct FrameSource::State {
    State(std::string name, const RungTable& table, FrameEvents take)
        : instance(std::move(name)), rungs(table), events(std::move(take)), streams(std::random_device{}()),
          frames([this] { runFrames(); }), stills([this] { runStills(); }) {}
    ~State() {
        {
            const std::lock_guard lock(mutex);
            stopping = true;
        }
        wake.notify_all();
        wakeStills.notify_all();
        frames.join();
        stills.join();
    }

    void runFrames();
    void lookAtServer();
    bool findServer();
    std::shared_ptr<ipc::Frame> freeMemory();
    void lookForFrame(const std::optional<PreviewRun>& preview);
    void lookAtServersFrame(const std::optional<PreviewRun>& preview);
    void lookAtPreview(const PreviewRun& run);
    void showWaiting();
    void take(HeldFrame frame, const FrameStep& step);
    bool isFinal(const HeldFrame& frame);
    void tellProgress(const ipc::FrameInfo& newest);
    void showFrame(HeldFrame frame);
    FrameFacts factsOf(const HeldFrame& held, const ipc::Status& status);
    void encodeWanted(const FrameDemand& wanted);
    void considerRest(const FrameDemand& wanted);
    void runStills();
    void publish();
    /// Once, until `told` is reset.
    void tellFailure(bool& told, const std::exception& error);

    const std::string instance;
    const RungTable rungs;
    const FrameEvents events;

    mutable std::mutex mutex;
    std::condition_variable wake, wakeStills;
    bool stopping = false;
    FrameDemand demand;
    std::optional<PreviewRun> wantedPreview;
    FrameFigures counted;
    FrameSet set; ///< of the newest frame
    struct StillTask {
        HeldFrame frame;
        FrameFacts facts;
        bool fine = false;
    };
    std::optional<StillTask> still;

    // Used by the frames' thread alone.
    std::optional<ipc::Client> client;
    FrameClock::time_point lastSearch, lastEncoded;
    std::vector<std::shared_ptr<ipc::Frame>> memory; ///< used again once no other thread holds it
    std::shared_ptr<const ipc::Frame> live;          ///< the newest of the server
    HeldFrame current, waiting; ///< the one that is shown; a newer one that only improves it
    PreviewFrames previews;
    std::uint64_t endedRun = 0; ///< of a preview that is out of date
    bool previewFails = false;  ///< it was told
    FrameFacts facts;
    std::uint64_t epoch = 0;
    std::uint32_t streams;
    RestWatch rest;
    MotionEncoder encoder;
    bool framesFail = false; ///< it was told

    bool stillsFail = false; ///< it was told; used by the stills' thread alone

    std::thread frames, stills; // last: they use all of the above
};

void FrameSource::State::runFrames() {
    for (;;) {
        {
            std::unique_lock lock(mutex);
            counted.framesCpu = app::threadSeconds();
            if (!stopping && !demand.anyone && client) {
                lock.unlock();
                client.reset(); // leaves its slot to others
                lock.lock();
            }
            wake.wait(lock, [&] { return stopping || demand.anyone; });
            if (stopping) break;
        }
        try {
            lookAtServer();
        } catch (const std::exception& error) {
            tellFailure(framesFail, error);
            client.reset();
            std::unique_lock lock(mutex);
            wake.wait_for(lock, kRetry, [&] { return stopping; });
        }
    }
    client.reset();
}

bool FrameSource::State::findServer() {
    if (client) return true;
    const auto now = FrameClock::now();
    if (now - lastSearch >= kRetry) {
        lastSearch = now;
        try {
            client.emplace(instance, 0ns);
            return true;
        } catch (const ipc::Error& error) { // none yet, or one that does not let it in
            if (error.problem != ipc::Problem::NoServer) tellFailure(framesFail, error);
        }
    }
    std::unique_lock lock(mutex);
    wake.wait_for(lock, 50ms, [&] { return stopping; });
    return false;
}

void FrameSource::State::lookAtServer() {
    if (!findServer()) return;
    FrameDemand wanted;
    std::optional<PreviewRun> preview;
    {
        const std::lock_guard lock(mutex);
        wanted = demand;
        preview = wantedPreview;
    }
    if (preview && preview->run == endedRun) preview.reset();
    if (!preview) previews.leave();
    if (!preview && waiting.isPreview) waiting = {};
    const auto waits = FrameClock::now() - lastEncoded;
    const bool pending = wanted.above != FrameDemand().above;
    if (pending && waits < kBetweenFrames) std::this_thread::sleep_for(kBetweenFrames - waits);
    if (!pending) { // every window is full: leave frames alone until an acknowledgement
        std::unique_lock lock(mutex);
        wake.wait_for(lock, kSlice, [&] { return stopping || demand != wanted; });
        client->update();
        return;
    }
    lookForFrame(preview);
    if (!current) return;
    encodeWanted(wanted);
    considerRest(wanted);
}

std::shared_ptr<ipc::Frame> FrameSource::State::freeMemory() {
    std::shared_ptr<ipc::Frame> spare;
    std::erase_if(memory, [&](std::shared_ptr<ipc::Frame>& each) { // one is enough
        const bool isFree = each.use_count() == 1;
        std::atomic_thread_fence(std::memory_order_acquire); // behind what the other thread read of it
        if (isFree && !spare) {
            spare = each;
            return false;
        }
        return isFree;
    });
    return spare ? spare : memory.emplace_back(std::make_shared<ipc::Frame>());
}

void FrameSource::State::lookForFrame(const std::optional<PreviewRun>& preview) {
    lookAtServersFrame(preview);
    if (preview && preview->run != endedRun && live) lookAtPreview(*preview);
    showWaiting();
}

void FrameSource::State::lookAtServersFrame(const std::optional<PreviewRun>& preview) {
    const std::shared_ptr<ipc::Frame> next = freeMemory();
    if (live) {
        next->info = live->info;
        next->epoch = live->epoch;
    }
    // Steps of a resting picture are not waited for: none of them is urgent.
    if (!client->waitForFrame(*next, waiting ? 0ns : kSlice) || !isUsable(*next)) return;
    live = next;
    if (preview && next->info.nanoseconds > preview->since)
        endedRun = preview->run;
    else if (preview && current.isPreview)
        return; // which is better than what the server had before it
    take({next, false}, stepOf(*next, client->status()));
}

void FrameSource::State::lookAtPreview(const PreviewRun& run) {
    const std::shared_ptr<ipc::Frame> next = freeMemory();
    try {
        if (!previews.read(run, *live, *next) || !isUsable(*next)) return;
    } catch (const ipc::Error& error) {
        return tellFailure(previewFails, error);
    }
    previewFails = false;
    take({next, true}, stepOf(*next, {}));
    tellProgress(next->info);
}

void FrameSource::State::take(HeldFrame frame, const FrameStep& step) {
    waiting = std::move(frame);
    if (rest.comes(nowSeconds(), step)) showFrame(std::exchange(waiting, {}));
}

/// What only improves the image that is shown comes when it is due.
void FrameSource::State::showWaiting() {
    if (!waiting) return;
    if (rest.due(nowSeconds(), isFinal(waiting))) {
        showFrame(std::exchange(waiting, {}));
        if (current.isPreview) tellProgress(current->info);
        return;
    }
    std::unique_lock lock(mutex);
    wake.wait_for(lock, kRestSlice, [&] { return stopping; });
}

/// Whether nothing better follows.
bool FrameSource::State::isFinal(const HeldFrame& frame) {
    return frame.isPreview ? frame->info.tag == ipc::kPreviewDone : client->status().idle != 0;
}

void FrameSource::State::showFrame(HeldFrame frame) {
    facts = factsOf(frame, client->status());
    current = std::move(frame);
    rest.shown(nowSeconds());
    const std::lock_guard lock(mutex);
    ++counted.published;
    set = FrameSet{facts.stream, facts.number, {}, nullptr, nullptr};
    still.reset();
}

/// What is shown, and how far the newest image is, which may have to wait.
void FrameSource::State::tellProgress(const ipc::FrameInfo& newest) {
    PreviewProgress progress = progressOf(current.isPreview ? current->info : newest);
    progress.part = progressOf(newest).part;
    progress.done = progressOf(newest).done;
    events.preview(progress);
}

/// A coarse frame is shown as large as whole ones.
FrameFacts FrameSource::State::factsOf(const HeldFrame& held, const ipc::Status& status) {
    const ipc::Frame& frame = *held;
    FrameFacts next = facts;
    next.publishedNs = frame.info.nanoseconds;
    next.width = static_cast<std::uint16_t>(frame.info.width);
    next.height = static_cast<std::uint16_t>(frame.info.height);
    const bool coarse = frame.info.samples == 0 && status.width >= frame.info.width &&
                        status.height >= frame.info.height && status.width <= ipc::kMaxFrameSide &&
                        status.height <= ipc::kMaxFrameSide;
    next.shownWidth = coarse ? static_cast<std::uint16_t>(status.width) : next.width;
    next.shownHeight = coarse ? static_cast<std::uint16_t>(status.height) : next.height;
    const bool another = !held.isPreview && frame.epoch != epoch;
    if (another || next.shownWidth != facts.shownWidth || next.shownHeight != facts.shownHeight)
        next.stream = ++streams;
    const std::uint64_t above = next.stream == facts.stream ? facts.number + 1 : 1;
    next.number = held.isPreview ? above : std::max(above, frame.info.number); // a preview counts its own
    if (!held.isPreview) epoch = frame.epoch;
    return next;
}

void FrameSource::State::encodeWanted(const FrameDemand& wanted) {
    RungMask mask = 0;
    bool anyAsked = false;
    {
        const std::lock_guard lock(mutex);
        const bool sameStream = wanted.stream == facts.stream;
        for (std::size_t rung = 0; rung < kRungs.size(); ++rung) {
            const bool asked = wanted.above[rung] != FrameDemand::kNothing &&
                               (!sameStream || facts.number > wanted.above[rung]);
            if (asked) mask |= RungMask(1) << rung;
        }
        mask = mergedRungs(mask);
        anyAsked = mask != 0;
        for (std::size_t rung = 0; rung < kRungs.size(); ++rung)
            if (set.byRung[rung]) mask &= ~(RungMask(1) << rung);
    }
    if (mask == 0) {
        // A page that comes after all others have left asks for a frame that is encoded already.
        if (anyAsked) publish();
        return;
    }
    lastEncoded = FrameClock::now();
    for (std::size_t rung = 0; rung < kRungs.size(); ++rung) {
        if ((mask >> rung & 1) == 0) continue;
        const auto start = FrameClock::now();
        SharedFrame frame = encoder.encode(pixelsOf(*current), rungs[rung], facts);
        const std::lock_guard lock(mutex);
        counted.encode[rung].add(app::secondsSince(start));
        set.byRung[rung] = std::move(frame);
    }
    framesFail = false;
    publish();
}

void FrameSource::State::considerRest(const FrameDemand& wanted) {
    if (!wanted.still || facts.shownWidth != facts.width || facts.shownHeight != facts.height) return;
    if (!rest.takeStill(nowSeconds(), isFinal(current))) return;
    const std::lock_guard lock(mutex);
    still = StillTask{current, facts, wanted.fine};
    wakeStills.notify_one();
}

void FrameSource::State::publish() {
    FrameSet copy;
    {
        const std::lock_guard lock(mutex);
        copy = set;
    }
    events.deliver(std::move(copy));
}

void FrameSource::State::tellFailure(bool& told, const std::exception& error) {
    if (!std::exchange(told, true)) events.failed(error.what());
}

void FrameSource::State::runStills() {
    app::lowerPriority(); // of this thread alone
    StillEncoder exact;
    MotionEncoder jpeg;
    for (;;) {
        StillTask task;
        {
            std::unique_lock lock(mutex);
            counted.stillsCpu = app::threadSeconds();
            wakeStills.wait(lock, [&] { return stopping || still; });
            if (stopping) return;
            task = std::move(*still);
            still.reset();
        }
        for (const bool fine : {true, false}) {
            if (fine && !task.fine) continue;
            SharedFrame frame;
            const auto start = FrameClock::now();
            try {
                frame = fine ? jpeg.encodeFine(pixelsOf(*task.frame), task.facts)
                             : exact.encode(pixelsOf(*task.frame), task.facts);
            } catch (const std::exception& error) { // the moving frame stays
                tellFailure(stillsFail, error);
                break;
            }
            {
                const std::lock_guard lock(mutex);
                if (set.stream != task.facts.stream || set.number != task.facts.number) break;
                counted.still.add(app::secondsSince(start));
                (fine ? set.fine : set.still) = std::move(frame);
            }
            stillsFail = false;
            publish();
        }
    }
}

FrameSource::FrameSource(std::string instance, const RungTable& rungs, FrameEvents events)
    : state_(std::make_unique<State>(std::move(instance), rungs, std::move(events))) {}

FrameSource::~FrameSource() = default;

void FrameSource::setDemand(const FrameDemand& demand) {
    {
        const std::lock_guard lock(state_->mutex);
        if (state_->demand == demand) return;
        state_->demand = demand;
    }
    state_->wake.notify_all();
}

void FrameSource::setPreview(const std::optional<PreviewRun>& run) {
    const std::lock_guard lock(state_->mutex);
    state_->wantedPreview = run;
}

FrameFigures FrameSource::figures() const {
    const std::lock_guard lock(state_->mutex);
    return state_->counted;
}

} // namespace bridge
