#include "rtcore/io/import/exchange_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using rtcore::ExchangeFolder;

/// The number of a process that has ended.
pid_t deadProcess() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return child;
}

TEST(ExchangeFolder, ExistsForThisUserAloneWhileItLives) {
    fs::path path;
    {
        const ExchangeFolder folder(1);
        path = folder.path();
        EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_all);
        std::ofstream(path / "model.bsp") << "something";
    }
    EXPECT_FALSE(fs::exists(path));
}

TEST(ExchangeFolder, RemovesWhatAKilledProgramLeft) {
    const ExchangeFolder mine(1);
    const fs::path left = mine.path().parent_path() / ("rtimport-" + std::to_string(deadProcess()) + "-7");
    const fs::path foreign = mine.path().parent_path() / ("rtimport-notes-" + std::to_string(::getpid()));
    fs::create_directory(left);
    fs::create_directory(foreign);
    std::ofstream(left / "model.bsp") << "half";
    const ExchangeFolder other(1);
    EXPECT_FALSE(fs::exists(left));
    EXPECT_TRUE(fs::exists(mine.path()));
    EXPECT_TRUE(fs::exists(foreign));
    fs::remove(foreign);
}

} // namespace
