#include "rtserver/frames/kept_light.h"

#include "shown_room.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace rtserver {
namespace {

/// Visits of one room, each by a server of its own.
class KeptLights : public test::ShownRoom {
  protected:
    KeptLights() { options.lightCache = folder / "light"; }

    struct Visit {
        Visit(const Options& options, Workspace& state, SceneUpkeep& upkeep, Messages& messages)
            : drawing(state, upkeep,
                      {.poll = [] { return Arrivals{}; },
                       .publish = [](const ipc::FrameInfo&, const rtcore::LdrImage&) {}},
                      1, 0),
              kept(options, state.document, drawing, messages) {
            kept.sceneShown();
            // One that comes late is taken, too.
            for (int i = 0; i < 200 && drawing.walkLight() == nullptr && messages.count() == 0; ++i) {
                kept.advance(false);
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
        }
        std::uint32_t steps() const { return drawing.walkLight() ? drawing.walkLight()->steps() : 0; }

        FrameDrawing drawing;
        KeptLight kept;
    };
    std::unique_ptr<Visit> visit() { return std::make_unique<Visit>(options, state, upkeep, messages); }

    /// So many frames of a camera that moves.
    void walkAbout(Visit& visit, int frames = 20) {
        state.frameSeconds = 1e-9; // none of them is a whole one
        for (int i = 0; i < frames; ++i) {
            walk.turn(1, 0);
            visit.drawing.draw(false);
        }
    }
    std::filesystem::path file() const { return lightFileOf(*options.lightCache, "/rooms/room.scn"); }
    void SetUp() override {
        ShownRoom::SetUp();
        document.assign({{"indirect.mode", "live"}});
    }

    test::TemporaryFolder folder;
    SceneUpkeep upkeep{options, state.document, messages};
};

TEST_F(KeptLights, TheNextVisitBeginsWithThatOfTheLast) {
    const auto first = visit();
    EXPECT_EQ(first->steps(), 0U) << "there is none yet";
    walkAbout(*first);
    first->kept.leave(true);
    const auto second = visit();
    EXPECT_EQ(second->steps(), first->steps());
    EXPECT_GT(second->steps(), 10U);
    EXPECT_EQ(second->drawing.walkLight()->state(), first->drawing.walkLight()->state());
    EXPECT_EQ(messages.count(), 0U);
}

TEST_F(KeptLights, ItIsWrittenAtRest) {
    const auto first = visit();
    walkAbout(*first);
    first->kept.advance(false);
    EXPECT_FALSE(std::filesystem::exists(file())) << "something moves";
    for (int i = 0; i < 2000 && !std::filesystem::exists(file()); ++i) {
        first->kept.advance(true);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(std::filesystem::exists(file()));
    EXPECT_EQ(visit()->steps(), first->steps());
}

TEST_F(KeptLights, LittleIsNotWorthAFile) {
    const auto first = visit();
    walkAbout(*first, 2);
    first->kept.leave(true);
    EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(KeptLights, ThatOfEditsIsNotKept) {
    const auto first = visit();
    const Snapshot before = document.snapshot();
    switchLight(document, 1, false);
    document.keepStep("light", before);
    walkAbout(*first);
    first->kept.leave(true);
    EXPECT_FALSE(std::filesystem::exists(file()));
    document.undo();
    walkAbout(*first);
    first->kept.leave(true);
    EXPECT_TRUE(std::filesystem::exists(file()));
}

TEST_F(KeptLights, ThatOfAnotherLightIsNotTaken) {
    const auto first = visit();
    walkAbout(*first);
    first->kept.leave(true);
    switchLight(document, 1, false);
    EXPECT_EQ(visit()->steps(), 0U);
    EXPECT_EQ(messages.count(), 0U) << "a cache may be old";
    options.light = file();
    EXPECT_EQ(visit()->steps(), 0U);
    ASSERT_EQ(messages.count(), 1U);
    EXPECT_NE(messages.since(0).find("is the light of another scene"), std::string::npos);
}

TEST_F(KeptLights, OneThatWasMadeIsTakenAndStays) {
    const auto first = visit();
    walkAbout(*first);
    first->kept.leave(true);
    const std::filesystem::path made = folder / "made.light";
    std::filesystem::rename(file(), made);
    const auto size = std::filesystem::file_size(made);
    options.light = made;
    const auto second = visit();
    EXPECT_EQ(second->steps(), first->steps());
    walkAbout(*second);
    second->kept.leave(true);
    EXPECT_EQ(std::filesystem::file_size(made), size);
    EXPECT_TRUE(std::filesystem::exists(file())) << "what was learned goes into the folder";
}

TEST_F(KeptLights, ADamagedFileIsToldOfAndReplaced) {
    const auto first = visit();
    walkAbout(*first);
    first->kept.leave(true);
    std::filesystem::resize_file(file(), std::filesystem::file_size(file()) - 1);
    const auto second = visit();
    EXPECT_EQ(second->steps(), 0U);
    ASSERT_EQ(messages.count(), 1U);
    EXPECT_NE(messages.since(0).find("the file is cut off"), std::string::npos);
    walkAbout(*second);
    second->kept.leave(true);
    EXPECT_EQ(visit()->steps(), second->steps());
}

TEST_F(KeptLights, WithoutAFolderNothingIsWritten) {
    options.lightCache.reset();
    const auto first = visit();
    walkAbout(*first);
    first->kept.leave(true);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(KeptLights, AFolderThatCannotBeWrittenIsToldOfOnce) {
    std::ofstream(folder / "light") << "no folder";
    const auto first = visit();
    walkAbout(*first);
    for (int i = 0; i < 2000 && messages.count() == 0; ++i) {
        first->kept.advance(true);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_EQ(messages.count(), 1U);
    EXPECT_NE(messages.since(0).find("indirect light is not kept: "), std::string::npos);
    walkAbout(*first);
    first->kept.leave(true);
    EXPECT_EQ(messages.count(), 1U);
}

TEST_F(KeptLights, TheOldestFilesMakeRoom) {
    std::filesystem::create_directory(*options.lightCache);
    std::vector<std::filesystem::path> old;
    for (const char* const name : {"older.light", "old.light", "other.txt"}) {
        old.push_back(*options.lightCache / name);
        std::ofstream(old.back()) << "x";
        std::filesystem::resize_file(old.back(), 300U << 20); // a hole
        std::filesystem::last_write_time(old.back(), std::filesystem::file_time_type::clock::now() -
                                                         std::chrono::hours(24 * (5 - old.size())));
    }
    const auto first = visit();
    walkAbout(*first);
    first->kept.leave(true);
    EXPECT_FALSE(std::filesystem::exists(old[0]));
    EXPECT_TRUE(std::filesystem::exists(old[1]));
    EXPECT_TRUE(std::filesystem::exists(old[2])) << "it is no light";
    EXPECT_TRUE(std::filesystem::exists(file()));
}

TEST(LightFileOf, HasTheNameOfTheScene) {
    const std::filesystem::path folder = "/cache";
    const std::string name = lightFileOf(folder, "/a/house.obj").string();
    EXPECT_TRUE(name.starts_with("/cache/house-")) << name;
    EXPECT_TRUE(name.ends_with(".light")) << name;
    EXPECT_NE(lightFileOf(folder, "/b/house.obj").string(), name);
    EXPECT_LT(lightFileOf("", "/a/" + std::string(250, 'x')).string().size(), 100U);
}

} // namespace
} // namespace rtserver
