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
}

TEST(TemporaryFolder, TmpdirIsAdvisedOnlyWhereItCounts) {
    const test::TemporaryFolder parent;
    try {
        rtcore::TemporaryFolder(parent.path() / "none", "test-");
        ADD_FAILURE();
    } catch (const rtcore::FileError& error) {
        EXPECT_EQ(std::string(error.what()), (parent.path() / "none").string() +
                                                 ": no folder can be made here: No such file or directory; "
                                                 "check its permissions, or name another place");
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
