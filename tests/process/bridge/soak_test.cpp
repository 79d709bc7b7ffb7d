// The bridge in use for RT_BRIDGE_SOAK seconds: what it holds of the system does not grow.
#include "process/bridge/bridge_fixture.h"
#include "support/holdings.h"

#include <fmt/core.h>

#include <random>

namespace {

using namespace test;

class BridgeSoak : public BridgeTest {
  protected:
    /// Takes what came, for so long; now and then it does something.
    void visit(WebClient& driver, WebClient& viewer, std::chrono::milliseconds time) {
        for (const auto end = Clock::now() + time; Clock::now() < end;) {
            for (WebClient* const each : {&driver, &viewer}) {
                const auto frame = each->next(5ms);
                if (!frame || frame->opcode != 2) continue;
                each->acknowledge(*frame);
                frames_ += headerOf(frame->payload).type == 1 ? 1U : 0U;
            }
            act(driver);
        }
    }
    /// After others left, with one page and a server at rest.
    Holdings rest() {
        server->move(0);
        server->show(320, 200);
        std::this_thread::sleep_for(300ms);
        return holdingsOf(bridge.process());
    }
    std::size_t frames() const { return frames_; }

  private:
    void act(WebClient& driver) {
        switch (random_() % 40) {
        case 0:
            server->show(320 + static_cast<int>(random_() % 2) * 320, 200);
            break;
        case 1:
            driver.input({static_cast<std::uint8_t>("WASD"[random_() % 4])}, 100, 10);
            break;
        case 2:
            driver.sendText(R"({"id":1,"do":"parts"})");
            break;
        case 3: // one that comes and goes
            join(kViewer)->sendText(R"({"id":1,"do":"state"})");
            break;
        case 4:
            server->move(random_() % 8 == 0 ? 0 : 30);
            break;
        default:
            break;
        }
    }

    std::mt19937 random_{17};
    std::size_t frames_ = 0;
};

TEST_F(BridgeSoak, LeavesTheBridgeAsItWas) {
    const std::chrono::seconds time(asked("RT_BRIDGE_SOAK", 4));
    std::vector<Holdings> samples;
    const auto begin = Clock::now();
    while (samples.size() < 6 || Clock::now() < begin + time) {
        {
            server->move(30);
            const auto driver = join(), viewer = join(kViewer);
            visit(*driver, *viewer, std::chrono::milliseconds(time) / 12);
        }
        samples.push_back(rest());
    }
    const Holdings &warm = samples[samples.size() / 3], &last = samples.back();
    fmt::print("{} s, {} frames: {:.1f} MB at a third, {:.1f} MB at the end, {} descriptors, {} threads\n",
               std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - begin).count(), frames(),
               static_cast<double>(warm.privateBytes) / 1e6, static_cast<double>(last.privateBytes) / 1e6,
               last.descriptors, last.threads);
    EXPECT_GT(frames(), 0U);
    EXPECT_LE(last.descriptors, warm.descriptors);
    EXPECT_LE(last.threads, warm.threads);
    if (kSanitized) return; // they keep what was freed
    EXPECT_LT(last.privateBytes, warm.privateBytes + 6'000'000);
}

} // namespace
