#include "rtcore/platform/temporary_folder.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace {

namespace fs = std::filesystem;

TEST(TemporaryFolder, IsOursAloneAndGoesWithAllThatIsInIt) {
    const test::TemporaryFolder parent;
    fs::path path;
    {
        const rtcore::TemporaryFolder folder(parent.path(), "test-");
        path = folder.path();
        EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_all);
        fs::create_directory(path / "inner");
        std::ofstream(path / "inner" / "file") << "text";
    }
    EXPECT_FALSE(fs::exists(path));
    try {
        const rtcore::TemporaryFolder none(parent.path() / "none", "test-");
        ADD_FAILURE() << "there is no such parent";
    } catch (const rtcore::FileError& error) {
        EXPECT_EQ(std::string(error.what()).find("TMPDIR"), std::string::npos) << "which has no say here";
    }
}

TEST(TemporaryFolder, GoesWithItsKnownFilesAtASignal) {
    const test::TemporaryFolder parent;
    rtcore::TemporaryFolder folder(parent.path(), "test-");
    const fs::path first = folder.file("first"), second = folder.file("second");
    std::ofstream(first) << "text";
    rtcore::removeTemporaryFiles();
    EXPECT_TRUE(fs::is_empty(parent.path()));
}

} // namespace
