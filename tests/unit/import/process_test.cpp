#include "import_support.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/processes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

#include <sys/stat.h>

namespace {

using namespace rtcore;
using test::TemporaryFolder;

/// A program that stands for the importer.
class FakeImporter : public testing::Test {
  protected:
    FakeImporter() { test::writeText(model_, test::kCubeObj); }

    FileError failure(const std::string& script, const ImportOptions& options = {}) {
        const std::filesystem::path program = folder_ / "importer.sh";
        test::writeText(program, "#!/bin/sh\n" + script + "\n");
        std::filesystem::permissions(program, std::filesystem::perms::owner_all);
        const test::ChosenImporter chosen(program);
        try {
            importModel(model_, options);
        } catch (const FileError& error) {
            EXPECT_NE(std::string(error.what()).find(model_.string()), std::string::npos) << error.what();
            return error;
        }
        return {FailureKind::TryAgain, "", "no error"};
    }
    static bool says(const FileError& error, const std::string& part) {
        return std::string(error.what()).find(part) != std::string::npos;
    }

    TemporaryFolder folder_;
    std::filesystem::path model_ = folder_ / "cube.obj";
};

TEST_F(FakeImporter, Crash) {
    const FileError error = failure("kill -SEGV $$");
    EXPECT_EQ(error.kind, FailureKind::BadData);
    EXPECT_TRUE(says(error, "crashed (signal 11, Segmentation fault)")) << error.what();
    EXPECT_TRUE(says(error, "export it again")) << error.what();
}

TEST_F(FakeImporter, Hang) {
    ImportOptions options;
    options.timeLimit = 0.3;
    const auto start = std::chrono::steady_clock::now();
    const FileError error = failure("sleep 100", options);
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 5);
    EXPECT_EQ(error.kind, FailureKind::BadData);
    EXPECT_TRUE(says(error, "got no further")) << error.what();
}

TEST_F(FakeImporter, Hunger) {
    ImportOptions options;
    options.memoryLimit = 100'000'000;
    const FileError error = failure("x=aaaaaaaaaaaaaaaa; while :; do x=$x$x; done", options);
    EXPECT_EQ(error.kind, FailureKind::BadData);
    EXPECT_TRUE(says(error, "100 MB of memory")) << error.what();
}

TEST_F(FakeImporter, ExitCodesAndReasons) {
    FileError error = failure("echo noise >&2; echo 'the reason; the remedy' >&2; exit 65");
    EXPECT_EQ(error.kind, FailureKind::BadData);
    EXPECT_TRUE(says(error, "cube.obj: the reason; the remedy")) << error.what();
    error = failure("exit 71");
    EXPECT_EQ(error.kind, FailureKind::BadData);
    EXPECT_TRUE(says(error, "of memory")) << error.what();
    error = failure("echo 'disk full' >&2; exit 73");
    EXPECT_EQ(error.kind, FailureKind::CannotWrite);
    error = failure("exit 9");
    EXPECT_EQ(error.kind, FailureKind::BadData);
    EXPECT_TRUE(says(error, "exit code 9")) << error.what();
}

TEST_F(FakeImporter, AReasonInAFormIsTakenBeforeOneInEnglish) {
    const std::string english = "echo 'in English' >&2; exit 65";
    const FileError error = failure(R"(echo alive; echo 'refusal ["said of {0}","it"]'; )" + english);
    EXPECT_TRUE(says(error, "cube.obj: said of it")) << error.what();
    ASSERT_EQ(error.sentence().arguments().size(), 2U);
    EXPECT_TRUE(error.sentence().arguments()[1].isForm());
    EXPECT_TRUE(says(failure("echo 'refusal [7'; " + english), "cube.obj: in English"));
}

TEST_F(FakeImporter, NothingOrNonsenseHandedOver) {
    EXPECT_EQ(failure("exit 0").kind, FailureKind::BadData);
    EXPECT_EQ(failure("for last; do :; done; echo nonsense > \"$last\"").kind, FailureKind::BadData);
}

TEST_F(FakeImporter, Stop) {
    const std::atomic<bool> stop = true;
    ImportOptions options;
    options.stop = &stop;
    EXPECT_EQ(failure("sleep 100", options).kind, FailureKind::Stopped);
}

TEST_F(FakeImporter, LeavesNoFolderBehind) {
    const FileError error = failure("for last; do :; done; touch \"$last\"; echo \"$last\" >&2; exit 65");
    const std::string text = error.what();
    const std::filesystem::path exchanged = text.substr(text.find(": ") + 2);
    EXPECT_TRUE(exchanged.is_absolute()) << exchanged;
    EXPECT_FALSE(std::filesystem::exists(exchanged.parent_path()));
}

FileError refusal(const std::filesystem::path& path) {
    try {
        test::importFile(path);
    } catch (const FileError& error) {
        return error;
    }
    return {FailureKind::TryAgain, "", "no error"};
}

TEST(Importer, MissingFilesAndFoldersAreNoInput) {
    const TemporaryFolder folder;
    EXPECT_EQ(refusal(folder / "none.obj").kind, FailureKind::NoInput);
    EXPECT_EQ(refusal(folder.path()).kind, FailureKind::NoInput);
}

TEST(Importer, AMissingImporterIsNamed) {
    const TemporaryFolder folder;
    test::writeText(folder / "cube.obj", test::kCubeObj);
    const test::ChosenImporter chosen(folder / "no-importer");
    try {
        importModel(folder / "cube.obj");
        FAIL() << "no error";
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("no-importer"), std::string::npos);
    }
}

TEST(Importer, WhatIsNoModelIsRefusedWithAReason) {
    const TemporaryFolder folder;
    test::writeText(folder / "empty.obj", "");
    test::writeText(folder / "text.txt", "hello\n");
    test::writeText(folder / "lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
    test::writeText(folder / "broken.gltf", "{\"asset\":");
    for (const char* name : {"empty.obj", "text.txt", "lines.obj", "broken.gltf"}) {
        const FileError error = refusal(folder / name);
        EXPECT_EQ(error.kind, FailureKind::BadData) << name;
        EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find(';'), std::string::npos) << "no remedy: " << error.what();
    }
    EXPECT_NE(std::string(refusal(folder / "lines.obj").what()).find("1 points and lines"),
              std::string::npos);
}

TEST(Importer, SaysWhyInAFormWhateverAFileHolds) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder / "house.ifc";
    const std::string form = "it is a building in {0}, which is not read; export it as IFC2x3 or as glTF";
    for (const std::string& schema : {std::string("IFC4"), std::string("IFC4\nrefusal [\"x\"]")}) {
        test::writeText(path, "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('" + schema + "'));\n");
        const Sentence whole = refusal(path).sentence();
        EXPECT_EQ(whole.text(), "{0}: {1}");
        ASSERT_EQ(whole.arguments().size(), 2U);
        EXPECT_EQ(whole.arguments()[0].text(), path.string());
        const Sentence& why = whole.arguments()[1];
        EXPECT_TRUE(why.isForm());
        EXPECT_EQ(why.text(), form);
        ASSERT_EQ(why.arguments().size(), 1U);
        EXPECT_FALSE(why.arguments()[0].isForm());
        EXPECT_EQ(why.arguments()[0].text().substr(0, 4), "IFC4");
        EXPECT_EQ(why.english().find('\n'), std::string::npos);
    }
}

TEST(Importer, MemoryIsLimited) {
    // A grid of a million triangles does not go into 30 MB.
    std::string text;
    for (int y = 0; y < 500; ++y) {
        for (int x = 0; x < 500; ++x) text += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
    }
    for (int i = 1; i < 500 * 499; ++i) {
        text += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 500) + "\n";
    }
    const TemporaryFolder folder;
    test::writeText(folder / "grid.obj", text);
    ImportOptions options;
    options.memoryLimit = 30'000'000;
    try {
        test::importFile(folder / "grid.obj", options);
        FAIL() << "no error";
    } catch (const FileError& error) {
        EXPECT_EQ(error.kind, FailureKind::BadData);
        EXPECT_NE(std::string(error.what()).find("memory"), std::string::npos) << error.what();
    }
    EXPECT_GT(test::importFile(folder / "grid.obj").model.mesh.triangles.size(), 200000U);
}

bool runs(const std::string& pid) {
    std::ifstream file("/proc/" + pid + "/status");
    const std::string status((std::istreambuf_iterator<char>(file)), {});
    return !status.empty() && status.find("Z (zombie)") == std::string::npos;
}

TEST(Importer, DiesWithItsParent) {
    const TemporaryFolder folder;
    // An input that never comes: Assimp waits in open().
    ASSERT_EQ(::mkfifo((folder / "pipe.obj").c_str(), 0600), 0);
    const std::string command = "sh -c '" RT_TEST_IMPORTER " --parent $$ " + (folder / "pipe.obj").string() +
                                " " + (folder / "out.bsp").string() + " & echo $! > " +
                                (folder / "pid").string() + "; sleep 0.3; kill -9 $$'";
    EXPECT_NE(std::system(command.c_str()), 0);
    std::string pid;
    std::ifstream(folder / "pid") >> pid;
    ASSERT_FALSE(pid.empty());
    for (int i = 0; i < 200 && runs(pid); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_FALSE(runs(pid));
    // And at once when the parent was gone before it started.
    const ProcessResult late = runProcess(RT_TEST_IMPORTER, {"--parent", "1", "--", "a", "b"});
    EXPECT_EQ(late.code, 1);
}

TEST(ImportLimits, FollowTheFileWithoutItsHolesAndTheMachine) {
    const test::TemporaryFolder folder;
    const auto file = [&](const std::string& name, std::size_t bytes) {
        std::ofstream(folder / name, std::ios::binary) << std::string(bytes, 'x');
        return folder / name;
    };
    const ImportLimits tiny = importLimits(file("tiny.ply", 20));
    EXPECT_EQ(tiny.memory, machineMemory() / 2) << "its images may be large";
    EXPECT_EQ(tiny.seconds, 5);
    EXPECT_NEAR(importLimits(file("tiny.gltf", 20)).seconds, 15, 0.01) << "its buffers may be large";
    EXPECT_NEAR(importLimits(file("a.ply", 1'000'000)).seconds, 17, 0.01);
    std::filesystem::resize_file(folder / "a.ply", 5'000'000'000);
    const ImportLimits sparse = importLimits(folder / "a.ply");
    EXPECT_NEAR(sparse.seconds, 17, 0.2);
    EXPECT_EQ(sparse.memory, tiny.memory);
    ImportOptions asked;
    asked.memoryLimit = 123;
    asked.timeLimit = 4;
    EXPECT_EQ(importLimits(folder / "a.ply", asked).memory, 123U);
    EXPECT_EQ(importLimits(folder / "a.ply", asked).seconds, 4);
}

} // namespace
