// The command line of RTBridge.
#include "support/run_program.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace {

const std::string kBridge = std::string(RT_PROGRAM_FOLDER) + "/RTBridge";

TEST(BridgeOptions, WrongOnesEndWithTwo) {
    const std::vector<std::vector<std::string>> wrong{{"--listen=8931"},
                                                      {"--listen="},
                                                      {"--listen=[]:80"},
                                                      {"--listen=127.0.0.1:x"},
                                                      {"--listen=127.0.0.1:70000"},
                                                      {"--lock=nothing"},
                                                      {"--instance=a/b"},
                                                      {"--origin=viz.example"},
                                                      {"--tls-cert=x.pem"},
                                                      {"--clients=0"},
                                                      {"--max-mbit=-1"},
                                                      {"--ping=16"},
                                                      {"extra"}};
    for (const auto& words : wrong) {
        const test::ProgramResult result = test::runProgram(kBridge, words);
        EXPECT_EQ(result.exitCode, 2) << words.front() << result.error;
        EXPECT_FALSE(result.error.empty());
    }
}

TEST(BridgeOptions, OtherMachinesNeedTls) {
    const test::ProgramResult result = test::runProgram(kBridge, {"--listen=0.0.0.0:0"});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.error.find("ssh -L"), std::string::npos) << result.error;
    EXPECT_NE(result.error.find("--tls-cert"), std::string::npos);
}

// One that is not the process that started it has ended already.
TEST(BridgeOptions, EndsWithItsParentAndHasPortsOfItsOwn) {
    for (const std::string host : {"127.0.0.1", "localhost"}) {
        const test::ProgramResult result =
            test::runProgram(kBridge, {"--instance=nobody", "--listen=" + host, "--parent=1"});
        EXPECT_EQ(result.exitCode, 143) << result.error;
        const std::string before = "Viewer: http://127.0.0.1:";
        const std::size_t link = result.output.find(before);
        ASSERT_NE(link, std::string::npos) << result.output << result.error;
        const int port = std::stoi(result.output.substr(link + before.size()));
        EXPECT_GE(port, 8931);
        EXPECT_LT(port, 8951);
    }
}

TEST(BridgeOptions, TokensThatOthersMayReadAreRefused) {
    test::TemporaryFolder folder;
    const std::string file = (folder / "tokens").string();
    std::ofstream(file) << "abcdefghijklmnopqrstuvwxyz\nzyxwvutsrqponmlkjihgfedcba\n";
    std::filesystem::permissions(file, std::filesystem::perms(0644));
    EXPECT_EQ(test::runProgram(kBridge, {"--token-file=" + file}).exitCode, 65);
    std::filesystem::permissions(file, std::filesystem::perms(0600));
    std::ofstream(file) << "short\n";
    EXPECT_EQ(test::runProgram(kBridge, {"--token-file=" + file}).exitCode, 65);
}

TEST(BridgeOptions, MissingScenesAndCertificatesAreTold) {
    EXPECT_EQ(test::runProgram(kBridge, {"--start=/nowhere/nave.scn"}).exitCode, 66);
    const test::ProgramResult tls = test::runProgram(
        kBridge, {"--listen=127.0.0.1:0", "--tls-cert=/nowhere/a.pem", "--tls-key=/nowhere/b.pem"});
    EXPECT_EQ(tls.exitCode, 66) << tls.error;
}

TEST(BridgeOptions, HelpAndManPageComeFromTheTable) {
    const test::ProgramResult help = test::runProgram(kBridge, {"--help"});
    EXPECT_EQ(help.exitCode, 0);
    for (const char* option :
         {"--listen", "--origin", "--view-only", "--lock", "--token-file", "--start", "--max-pixels"})
        EXPECT_NE(help.output.find(option), std::string::npos) << option;
    EXPECT_NE(test::runProgram(kBridge, {"--man-page"}).output.find(".TH"), std::string::npos);
}

} // namespace
