// A picture that goes on improving while the view stands: some of its steps, and the last one exactly.
#include "process/bridge/bridge_fixture.h"
#include "process/bridge/png_pixels.h"

#include "ipc/endpoint/client.h"
#include "ipc/layout/frame_info.h"

namespace {

using namespace test;

class Rest : public BridgeTest {};

TEST_F(Rest, ShowsSomeStepsOfAnImprovingPictureAndTheLastExactly) {
    const auto client = join();
    ASSERT_TRUE(client->binary(1));
    server->improve(60);
    int frames = 0;
    for (const auto end = Clock::now() + 3s; Clock::now() < end;) {
        const auto frame = client->next(100ms);
        if (!frame || frame->opcode != 2) continue;
        client->acknowledge(*frame);
        if (headerOf(frame->payload).type == 1) ++frames;
    }
    EXPECT_GE(frames, 2) << "the steps go on being seen";
    EXPECT_LE(frames, 10) << "of about 180";
    server->finish();
    const auto shown = [&] {
        const std::vector<std::uint8_t> still = rgbOf(stillOf(*client));
        return areSame(still, server->pixels());
    };
    bool same = false;
    for (int i = 0; i < 4 && !same; ++i) same = shown();
    EXPECT_TRUE(same) << "the last one, exactly";
}

TEST_F(Rest, ShowsAChangeDuringSuchAPictureAtOnce) {
    const auto client = join();
    server->improve(60);
    for (const auto end = Clock::now() + 2s; Clock::now() < end;)
        if (const auto frame = client->next(100ms); frame && frame->opcode == 2) client->acknowledge(*frame);
    server->move(60); // by now 0.8 s lie between two steps
    int frames = 0;
    while (frames < 30) {
        const auto frame = client->binary(1);
        ASSERT_TRUE(frame) << frames;
        client->acknowledge(*frame);
        ++frames;
    }
}

/// A still that is rendered by paths, shown by the program that renders it.
class RestOfAPreview : public BridgeTest {
    void SetUp() override {
        renderer_ = ChildProcess(std::string(RT_PROGRAM_FOLDER) + "/Renderer",
                                 {"--preview=" + instance.name(), "--linger=60", "--width=160",
                                  "--height=120", "--setting=integrator=path", "--setting=path.samples=64",
                                  RT_SOURCE_FOLDER "/data/tiny/tiny.scn"},
                                 {.outputFile = (instance.folder() / "renderer.log").string()});
        startBridge();
    }
    ChildProcess renderer_;
};

TEST_F(RestOfAPreview, EndsWithThePixelsOfTheLastStep) {
    std::optional<ipc::Client> viewer;
    const auto found = [&] {
        try {
            viewer.emplace(instance.name(), 0ns);
            return true;
        } catch (const ipc::Error&) {
            return false;
        }
    };
    ASSERT_TRUE(eventually(found, 20s));
    const auto client = join();
    ipc::Frame last;
    const auto same = [&] {
        const std::vector<std::uint8_t> still = rgbOf(stillOf(*client));
        viewer->readFrame(last);
        const auto* const bytes = reinterpret_cast<const std::uint8_t*>(last.pixels.data());
        return last.info.tag == ipc::kPreviewDone && areSame(still, {bytes, bytes + last.pixels.size()});
    };
    EXPECT_TRUE(eventually(same, 40s));
}

} // namespace
