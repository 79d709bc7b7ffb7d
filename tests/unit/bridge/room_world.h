/// A room's world in the hands of a test: a clock that it turns, servers that it plays, pages that keep what
/// they were sent.
#pragma once

#include "bridge/net/outlet.h"
#include "bridge/room/services.h"

#include "common/commands/state_report.h"
#include "ipc/endpoint/client.h"
#include "rtcore/platform/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace test {

class HandClock : public bridge::Clock {
  public:
    std::int64_t nanoseconds() const override { return now_; }
    void pass(double seconds) { now_ += static_cast<std::int64_t>(1e9 * seconds); }

  private:
    std::int64_t now_ = 1'000'000'000'000;
};

/// The socket of a page.
class PageOutlet : public bridge::Outlet {
  public:
    struct Binary {
        bridge::Header header;
        std::optional<bridge::Shipment> shipment;
        std::uint64_t number() const { return shipment ? shipment->frame->facts.number : 0; }
        /// Little-endian, of the header.
        std::uint32_t field(std::size_t at) const {
            std::uint32_t value = 0;
            for (std::size_t i = 4; i-- > 0;) value = value << 8 | header[at + i];
            return value;
        }
    };

    void sendText(std::string text) override { events.push_back(nlohmann::json::parse(text)); }
    void sendBinary(const bridge::Header& header, const bridge::Shipment* shipment) override {
        binaries.push_back({header, shipment != nullptr ? std::optional(*shipment) : std::nullopt});
        isBusy = staysBusy;
    }
    bool busy() const override { return isBusy; }
    void ping() override { ++pings; }
    void close(bridge::CloseCode code, const std::string& reason) override {
        if (!closeCode) closeCode = code;
        closeReason = reason;
    }
    void drop() override { dropped = true; }
    const std::string& address() const override { return from; }

    /// The names of all events so far, notices by their codes.
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& event : events) {
            const std::string name = event["event"];
            all.push_back(name == "notice" ? event["code"].get<std::string>() : name);
        }
        return all;
    }
    std::size_t count(const std::string& name) const {
        const std::vector<std::string> all = names();
        return static_cast<std::size_t>(std::ranges::count(all, name));
    }
    /// The last one of that name or code; null: none came.
    nlohmann::json last(const std::string& name) const {
        const std::vector<std::string> all = names();
        for (std::size_t i = all.size(); i-- > 0;)
            if (all[i] == name) return events[i];
        return nullptr;
    }

    std::vector<nlohmann::json> events;
    std::vector<Binary> binaries;
    bool isBusy = false;
    bool staysBusy = false; ///< after a binary message, until the test says otherwise
    int pings = 0;
    std::optional<bridge::CloseCode> closeCode;
    std::string closeReason, from = "127.0.0.1";
    bool dropped = false;
};

/// A server that records a room's requests, and answers when it is told to.
struct PlayedServer {
    struct Request {
        std::string line;
        std::function<void(ipc::Reply)> done;
    };
    std::vector<std::string> lines() const {
        std::vector<std::string> all;
        for (const Request& each : requests) all.push_back(each.line);
        return all;
    }
    /// Answers the request of that index.
    void answer(std::size_t index, const std::string& text = "",
                ipc::ReplyStatus status = ipc::ReplyStatus::Done) {
        requests.at(index).done({status, text});
    }

    bool anyone = false;
    bridge::KeySet keys;
    std::vector<std::uint8_t> taps;
    double right = 0, up = 0;
    int turnsDropped = 0, refreshes = 0;
    std::vector<Request> requests;
    app::KeyRestraint restraint{};
    bridge::ServerEvents events;
    bridge::FrameEvents frames;
    bridge::FrameDemand demand;
    std::optional<bridge::PreviewRun> preview;
};

class PlayedCommands : public bridge::ServerCommands {
  public:
    explicit PlayedCommands(PlayedServer& server) : server_(server) {}
    void setAnyone(bool anyone) override { server_.anyone = anyone; }
    void setKeys(const bridge::KeySet& down) override { server_.keys = down; }
    void tap(std::span<const std::uint8_t> keys) override {
        server_.taps.insert(server_.taps.end(), keys.begin(), keys.end());
    }
    void turn(double right, double up) override {
        server_.right += right;
        server_.up += up;
    }
    void dropTurn() override { ++server_.turnsDropped; }
    void request(std::string command, std::function<void(ipc::Reply)> done) override {
        server_.requests.push_back({std::move(command), std::move(done)});
    }
    void refresh() override { ++server_.refreshes; }
    bridge::CommandFigures figures() const override { return {}; }

  private:
    PlayedServer& server_;
};

class PlayedFrames : public bridge::ServerFrames {
  public:
    explicit PlayedFrames(PlayedServer& server) : server_(server) {}
    void setDemand(const bridge::FrameDemand& demand) override { server_.demand = demand; }
    void setPreview(const std::optional<bridge::PreviewRun>& run) override { server_.preview = run; }
    bridge::FrameFigures figures() const override { return {}; }

  private:
    PlayedServer& server_;
};

/// A Renderer that only notes what it is asked for.
struct PlayedRenderer {
    std::vector<std::string> requests; ///< "run scene camera", or "give up"
    int code = 0;                      ///< of its end, told once
    std::string trouble;               ///< with the next request
    bool wanted = false;               ///< at the last tick
};

class PlayedPaths : public bridge::PathRenderer {
  public:
    explicit PlayedPaths(PlayedRenderer& renderer) : renderer_(renderer) {}
    const std::string& instance() const override { return instance_; }
    std::string file(const std::string& name) override { return "/files/" + name; }
    void render(std::uint64_t run, const std::string& scene, const std::string& camera) override {
        if (!renderer_.trouble.empty())
            throw rtcore::FileError(rtcore::FailureKind::NoInput, "Renderer", renderer_.trouble);
        renderer_.requests.push_back(std::to_string(run) + " " + scene + " " + camera);
    }
    void giveUp() override { renderer_.requests.emplace_back("give up"); }
    int tick(bool wanted) override {
        renderer_.wanted = wanted;
        return std::exchange(renderer_.code, 0);
    }

  private:
    PlayedRenderer& renderer_;
    const std::string instance_ = "preview-of-a-test";
};

struct RoomWorld {
    bridge::RoomServices services() {
        return {
            .commands =
                [this](const std::string& instance, app::KeyRestraint restraint,
                       bridge::ServerEvents events) {
                    servers[instance].restraint = restraint;
                    servers[instance].events = std::move(events);
                    return std::make_unique<PlayedCommands>(servers[instance]);
                },
            .frames =
                [this](const std::string& instance, const bridge::RungTable&, bridge::FrameEvents events) {
                    servers[instance].frames = std::move(events);
                    return std::make_unique<PlayedFrames>(servers[instance]);
                },
            .renderer = [this]() -> std::unique_ptr<bridge::PathRenderer> {
                if (!byPaths) return nullptr;
                return std::make_unique<PlayedPaths>(renderer);
            },
            .post =
                [this](std::function<void()> work) {
                    if (!keepsPosted) return work();
                    posted.push_back(std::move(work));
                },
            .note = [this](const std::string& line) { notes.push_back(line); },
            .clock = clock};
    }

    HandClock clock;
    std::map<std::string, PlayedServer> servers; ///< by instance
    bool byPaths = false;                        ///< images at rest
    PlayedRenderer renderer;
    bool keepsPosted = false; ///< else what is posted is done at once
    std::vector<std::function<void()>> posted;
    std::vector<std::string> notes;
};

/// A moving frame of this size in bytes, encoded for one rung.
inline bridge::SharedFrame encodedFrame(std::uint64_t number, std::size_t bytes, std::int64_t publishedNs = 0,
                                        std::uint32_t stream = 1) {
    auto frame = std::make_shared<bridge::EncodedFrame>();
    frame->facts = {stream, number, 640, 480, 640, 480, publishedNs};
    frame->bytes.resize(bytes);
    return frame;
}
inline bridge::FrameSet frameSet(std::uint64_t number, std::size_t bytes = 1000, std::int64_t publishedNs = 0,
                                 std::uint32_t stream = 1) {
    bridge::FrameSet set{stream, number, {}, nullptr, nullptr};
    set.byRung[bridge::kFirstRung] = encodedFrame(number, bytes, publishedNs, stream);
    return set;
}

/// The answer to `state` of a server with one light and the default settings. `undo`: the edit that it takes
/// back.
inline std::string stateReport(app::ReportedEdit undo = {}, app::ReportedEdit redo = {}) {
    app::StateReport state;
    state.scene = "/secret/folder/hall.scn";
    state.settings = rtcore::settingAssignments({}, true);
    state.lights = {{3, true, "pendant"}};
    state.bookmarks = {"altar"};
    state.undoEdit = undo;
    state.redoEdit = redo;
    if (undo.number != 0) state.undo = "set maxDepth";
    if (redo.number != 0) state.redo = "set maxDepth";
    return app::formatStateReport(state, 65520);
}

} // namespace test
