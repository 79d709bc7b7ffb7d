// The command line of RTBridge.
#include "process/bridge/tls_tunnel.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

#include <sys/stat.h>

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
                                                      {"--tls-own", "--listen=unix"},
                                                      {"--tls-own", "--tls-cert=x.pem", "--tls-key=x.pem"},
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

// Neither a start that waits for what never comes, nor one that asks where nobody answers.
TEST(BridgeOptions, CertificatesAreRegularFilesAndKeysNotEncrypted) {
    test::TemporaryFolder folder;
    const test::TlsPair pair = test::makeCertificate(folder.path());
    if (pair.key.empty()) GTEST_SKIP() << "there is no openssl";
    if (test::runProgram(kBridge, {"--version"}).output.find("OpenSSL: yes") == std::string::npos)
        GTEST_SKIP() << "built without OpenSSL";
    const std::string pipe = (folder / "pipe").string(), locked = (folder / "locked.pem").string(),
                      old = (folder / "old.pem").string();
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const std::vector<std::string> writing{"-in", pair.key, "-passout", "pass:secret", "-aes128", "-out"};
    for (const auto& [command, file] : {std::pair("pkey", locked), std::pair("rsa", old)}) {
        std::vector<std::string> words{command};
        words.insert(words.end(), writing.begin(), writing.end());
        words.push_back(file);
        if (command == std::string("rsa")) words.emplace_back("-traditional");
        ASSERT_EQ(test::runProgram(test::kOpenssl, words).exitCode, 0) << command;
    }
    const struct {
        std::string certificate, key, named, why;
        int code;
    } rows[] = {{pipe, pair.key, pipe, "no regular file", 66},
                {pair.certificate, pipe, pipe, "no regular file", 66},
                {"/dev/zero", pair.key, "/dev/zero", "no regular file", 66},
                {pair.certificate, folder.path().string(), folder.path().string(), "no regular file", 66},
                {pair.key, pair.key, pair.key, "no certificate", 65},
                {pair.certificate, pair.certificate, pair.certificate, "no key", 65},
                {pair.certificate, locked, locked, "encrypted", 65},
                {pair.certificate, old, old, "encrypted", 65}};
    for (const auto& row : rows) {
        const auto start = test::Clock::now();
        const test::ProgramResult result = test::runProgram(
            kBridge, {"--listen=127.0.0.1:0", "--tls-cert=" + row.certificate, "--tls-key=" + row.key},
            {.timeoutSeconds = 20});
        EXPECT_EQ(result.exitCode, row.code) << row.certificate << " " << row.key << ": " << result.error;
        for (const std::string& words : {row.named, row.why})
            EXPECT_NE(result.error.find(words), std::string::npos) << result.error;
        EXPECT_EQ(result.error.find("pass phrase"), std::string::npos) << result.error;
        EXPECT_LT(test::Clock::now() - start, std::chrono::seconds(10));
    }
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
