#include "rtcore/neural/net_files.h"

#include "made_net.h"
#include "support/temporary_folder.h"

#include "rtcore/neural/digest.h"
#include "rtcore/platform/error.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using rtcore::findNet;
using rtcore::FoundNet;
using rtcore::kNetFiles;
using rtcore::Net;
using rtcore::netFolders;
using Folders = std::vector<fs::path>;

/// An environment variable of a test; without a value it is not set. As before afterwards.
class Variable {
  public:
    Variable(const char* name, const std::optional<std::string>& value) : name_(name) {
        if (const char* const before = std::getenv(name)) before_ = before;
        set(value);
    }
    ~Variable() { set(before_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    void set(const std::optional<std::string>& value) const {
        value ? ::setenv(name_, value->c_str(), 1) : ::unsetenv(name_);
    }
    const char* name_;
    std::optional<std::string> before_;
};

/// A user without data, and a program in an empty prefix.
class NetSearch : public testing::Test {
  protected:
    test::TemporaryFolder folder_;
    const Variable nets_{"RT_NETS", std::nullopt}, data_{"XDG_DATA_HOME", std::nullopt},
        home_{"HOME", (folder_ / "home").string()};
    const fs::path programs_ = folder_ / "prefix" / "bin";

    static void touch(const fs::path& file) {
        fs::create_directories(file.parent_path());
        std::ofstream(file) << "x";
    }
    FoundNet found(const fs::path& chosen = {}) const {
        return findNet(rtcore::fileOf(Net::Base), chosen, programs_);
    }
};

void write(const fs::path& file, std::span<const std::byte> bytes) {
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// Why a net is refused; "" where it is not.
std::string refusal(const rtcore::NetFile& net, const fs::path& file) {
    try {
        rtcore::readNet(net, file);
    } catch (const rtcore::FileError& error) {
        EXPECT_EQ(error.kind, rtcore::FailureKind::BadData);
        return error.what();
    }
    return "";
}

TEST(NetFiles, AreThoseThatTheScriptBrings) {
    std::ifstream file(RT_SOURCE_FOLDER "/scripts/fetch-nets.sh");
    std::ostringstream script;
    script << file.rdbuf();
    std::set<std::string> names;
    for (std::size_t i = 0; i < kNetFiles.size(); ++i) {
        const rtcore::NetFile& net = kNetFiles[i];
        EXPECT_EQ(static_cast<std::size_t>(net.net), i);
        EXPECT_EQ(&rtcore::fileOf(net.net), &net);
        EXPECT_NE(script.str().find(std::string(net.sha256) + "  " + net.file), std::string::npos)
            << net.file;
        EXPECT_EQ(std::string(net.sha256).size(), 64U);
        names.insert({net.name, net.file});
    }
    EXPECT_EQ(names.size(), 2 * kNetFiles.size());
}

TEST_F(NetSearch, GoesFromTheUserToTheInstallation) {
    const fs::path prefix = folder_ / "prefix" / "share" / "rtsuite" / "nets";
    const fs::path user = folder_ / "home" / ".local" / "share" / "rtsuite" / "nets";
    EXPECT_EQ(netFolders({}, programs_), (Folders{user, prefix}));
    {
        const Variable data("XDG_DATA_HOME", "/data of mine");
        EXPECT_EQ(netFolders({}, programs_), (Folders{"/data of mine/rtsuite/nets", prefix}));
        const Variable nets("RT_NETS", "");
        EXPECT_EQ(netFolders({}, programs_).size(), 2U) << "it is as if it were not set";
        const Variable some("RT_NETS", "some/nets");
        EXPECT_EQ(netFolders({}, programs_), Folders{"some/nets"});
        EXPECT_EQ(netFolders("chosen", programs_), Folders{"chosen"});
    }
    const Variable data("XDG_DATA_HOME", "not/absolute");
    EXPECT_EQ(netFolders({}, programs_), (Folders{user, prefix}));
    const Variable home("HOME", std::nullopt);
    EXPECT_EQ(netFolders({}, programs_), Folders{prefix});
    // The programs of a build.
    touch(folder_ / "prefix" / "CMakeCache.txt");
    EXPECT_EQ(netFolders({}, programs_), (Folders{prefix, folder_ / "nets"}));
}

TEST_F(NetSearch, TakesTheFirstFolderThatHasTheFile) {
    const std::string file = rtcore::fileOf(Net::Base).file;
    const fs::path prefix = folder_ / "prefix" / "share" / "rtsuite" / "nets" / file;
    const fs::path user = folder_ / "home" / ".local" / "share" / "rtsuite" / "nets" / file;
    touch(prefix.parent_path() / rtcore::fileOf(Net::Large).file);
    EXPECT_TRUE(found().file.empty());
    touch(prefix);
    EXPECT_EQ(found().file, prefix);
    EXPECT_TRUE(found().missing.empty());
    touch(user);
    EXPECT_EQ(found().file, user);
    touch(folder_ / "mine" / file);
    EXPECT_EQ(found(folder_ / "mine").file, folder_ / "mine" / file);
    EXPECT_TRUE(found(folder_ / "other").file.empty()) << "one that is chosen counts alone";
    const Variable nets("RT_NETS", (folder_ / "other").string());
    EXPECT_TRUE(found().file.empty());
}

TEST_F(NetSearch, SaysWhatToDo) {
    const std::string prefix = (folder_ / "prefix" / "share" / "rtsuite" / "nets").string();
    const std::string user = (folder_ / "home" / ".local" / "share" / "rtsuite" / "nets").string();
    const std::string begin = "denoise.net: no weights in ", file = " (rt_hdr_calb_cnrm.tza); ";
    EXPECT_EQ(found().missing.english(),
              begin + user + ", " + prefix + file + "scripts/setup.sh --nets brings them");
    EXPECT_EQ(found("/mine").missing.english(),
              begin + "/mine" + file + "scripts/fetch-nets.sh /mine brings them");
    touch(programs_ / "rtsuite-fetch-nets");
    EXPECT_EQ(found().missing.english(),
              begin + user + ", " + prefix + file + "rtsuite-fetch-nets brings them");
    const Variable nets("RT_NETS", "/mine");
    EXPECT_EQ(found().missing.english(), begin + "/mine" + file + "rtsuite-fetch-nets /mine brings them");
}

TEST(Digests, AreThoseOfTheStandard) {
    const auto digest = [](const std::string& text) {
        return rtcore::sha256(std::as_bytes(std::span(text.data(), text.size())));
    };
    if (!digest("")) GTEST_SKIP() << "this build has no OpenSSL";
    EXPECT_EQ(digest(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(digest("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(digest(std::string(1000000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Nets, AreReadWhereTheFileIsTheOneThatIsMeant) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "made.tza";
    std::vector<std::byte> bytes = test::archiveBytes(test::madeNet(9, false, 5), false);
    write(file, bytes);
    const std::optional<std::string> digest = rtcore::sha256(bytes);
    rtcore::NetFile net{Net::Base, "base", "made.tza", bytes.size(), digest ? digest->c_str() : ""};
    if (!digest) {
        EXPECT_NE(refusal(net, file).find("without OpenSSL"), std::string::npos);
        GTEST_SKIP() << "this build has no OpenSSL";
    }
    EXPECT_EQ(rtcore::readNet(net, file)->inputs(), 9);

    // As long, and one bit is another.
    bytes[70] ^= std::byte{1};
    write(file, bytes);
    EXPECT_EQ(refusal(net, file),
              file.string() + ": this is another net: its SHA-256 is " + *rtcore::sha256(bytes) + ", not " +
                  *digest + "; scripts/fetch-nets.sh " + folder.path().string() + " brings the right one");
    bytes.pop_back();
    write(file, bytes);
    EXPECT_EQ(refusal(net, file), file.string() + ": this is another net: " + std::to_string(bytes.size()) +
                                      " bytes, not " + std::to_string(net.bytes) +
                                      "; scripts/fetch-nets.sh " + folder.path().string() +
                                      " brings the right one");
    fs::remove(file);
    EXPECT_THROW(rtcore::readNet(net, file), rtcore::FileError);
}

/// Those that scripts/fetch-nets.sh has brought.
TEST(Nets, OfTheTableAreWhatItSays) {
    if (!rtcore::sha256({})) GTEST_SKIP() << "this build has no OpenSSL";
    for (const rtcore::NetFile& each : kNetFiles) {
        const FoundNet found = findNet(each);
        if (found.file.empty()) GTEST_SKIP() << found.missing.english();
        const std::shared_ptr<const rtcore::UNet> net = rtcore::readNet(each, found.file);
        EXPECT_EQ(net->large(), each.net == Net::Large);
        EXPECT_EQ(net->inputs(), each.net == Net::Colour ? 3 : 9);
        EXPECT_NE(refusal(rtcore::fileOf(each.net == Net::Base ? Net::NoisyAovs : Net::Base), found.file),
                  "");
    }
}

} // namespace
