// The answer to `plan outline`, written and read.
#include "common/commands/outline_text.h"

#include "rtcore/platform/error.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using app::ToldOutline;

ToldOutline outline() {
    return {.storey = 2,
            .floors = {0.1, 2.8},
            .top = 6.5,
            .eyeHeight = 1.6,
            .corner = {4'500'000.25, -3, 12.5},
            .right = {1, 0, 0},
            .ahead = {0, 1, 0},
            .up = {0, 0, 1},
            .step = 0.0052,
            .size = {2000, 1433},
            .solids = {{{0, 0}, {2000, 0}, {2000, 1433}, {0, 0}}, {{1, 1}, {2, 2}, {3, 1}, {1, 1}}},
            .lines = {{{5, 6}, {7, 8}}},
            .light = {{{0, 9}, {9, 9}}}};
}

TEST(OutlineText, IsReadAsItWasWritten) {
    EXPECT_EQ(app::parseOutline(app::formatOutline(outline())), outline());
    EXPECT_EQ(app::parseOutline(app::formatOutline({})), ToldOutline());
    EXPECT_EQ(app::parseOutline(app::formatOutline(outline()) + "\nnews of later 1 2"), outline());
}

TEST(OutlineText, ThatIsNoneIsRefused) {
    const std::string good = app::formatOutline(outline());
    for (const char* bad : {"", "storeys", "storey 3\nfloors 0 1", "storey -1", "storey x",
                            "storey 0\nstep 0", "storey 0\nstep nan", "storey 0\nsolid 1 2 3",
                            "storey 0\nsolid 1 2", "storey 0\nline 1 -2 3 4", "storey 0\nlight 1 2 3 4x",
                            "storey 0\nsize 1", "storey 0\ncorner 1 2", "storey 0\nsize 1 99999999999"})
        EXPECT_THROW(app::parseOutline(bad), rtcore::FileError) << bad;
    // Nor does what is cut off or turned over lead astray.
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::string other = good.substr(0, i);
        try {
            app::parseOutline(other);
            other = good;
            other[i] = static_cast<char>(other[i] ^ 0x15);
            app::parseOutline(other);
        } catch (const rtcore::FileError&) {
        }
    }
}

TEST(StoreyAt, IsTheHighestBelowTheEye) {
    const std::vector<double> floors{-2.5, 0, 3};
    EXPECT_EQ(app::storeyAt(floors, 7, 1.6), 2);
    EXPECT_EQ(app::storeyAt(floors, 7, 4), 3);
    EXPECT_EQ(app::storeyAt(floors, 7, -9), 1) << "below all of them";
    EXPECT_EQ(app::storeyAt(floors, 7, 20), 1) << "above the model";
    EXPECT_EQ(app::storeyAt({}, 7, 1), 0);
}

} // namespace
