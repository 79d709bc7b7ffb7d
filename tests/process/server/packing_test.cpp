/// The contents of a pack of somebody else's scene: nothing that was not decoded, nothing from elsewhere
/// unless it was asked for; and the server's other work while it is made.
#include "process/server/live_server.h"

#include "ipc/endpoint/client.h"
#include "rtcore/io/images/image_file.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <thread>

#include <sys/stat.h>

namespace {

using namespace test;
namespace fs = std::filesystem;
using namespace std::chrono_literals;

const std::string kSecret = "-----BEGIN PRIVATE KEY----- what only its owner may read\n";

/// A triangle with its buffer inside, and an image.
std::string gltfWith(const std::string& image) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
"textures":[{"source":0}],"images":[{"uri":")" +
           image + R"("}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
"min":[0,0,0],"max":[1,1,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,
"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
}

std::string triangle(const std::string& head) {
    return head + "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl wall\nf 1/1 2/2 3/3\n";
}

std::string unused(const std::string& texture) {
    return "version = 2\nmodel = 'room.obj'\n[[material]]\nname = 'no such'\ndiffuseTexture = '" + texture +
           "'\n";
}

/// Fixture: a folder `home` with things of the user's, and a folder `got` for what came from elsewhere.
class Packing : public LiveServer {
  protected:
    void SetUp() override {
        LiveServer::SetUp();
        for (const char* name : {"home", "got", "got/maps"}) fs::create_directory(folder() / name);
        writeText(folder() / "home/secret.key", kSecret);
        rtcore::writeImage(folder() / "home/photo.png", rtcore::LdrImage(4, 4, {200, 60, 40, 255}));
        rtcore::writeHdrImage(folder() / "home/photo.hdr", rtcore::HdrImage(8, 4, {0.3F, 0.5F, 0.9F}));
        rtcore::writeImage(folder() / "got/tile.png", rtcore::LdrImage(4, 4, {40, 60, 200, 255}));
        write("room.mtl", "newmtl wall\nKd 0.8 0.8 0.8\nmap_Kd tile.png\n");
        write("room.obj", triangle("mtllib room.mtl\n"));
        write("room.scn", "version = 2\nmodel = 'room.obj'\n");
    }
    void TearDown() override { ::unsetenv("RT_IMPORTER"); }
    void write(const std::string& name, const std::string& text) const {
        writeText(folder() / "got" / name, text);
    }
    void startWith(const std::string& scene) { start({}, "got/" + scene); }

    /// Nothing but what is in `home` holds the secret.
    void expectNoSecret() const {
        const std::string home = (folder() / "home/").string();
        for (const auto& entry : fs::recursive_directory_iterator(folder().path())) {
            if (!entry.is_regular_file() || entry.is_symlink() || entry.path().string().starts_with(home))
                continue;
            EXPECT_EQ(readBytes(entry.path()).find("PRIVATE KEY"), std::string::npos) << entry.path();
        }
    }
    std::string packedNames(const std::string& pack) const {
        Names names;
        for (const auto& entry : fs::recursive_directory_iterator(folder() / pack))
            if (entry.is_regular_file()) names.push_back(entry.path().lexically_relative(folder() / pack));
        std::sort(names.begin(), names.end());
        std::string text;
        for (const std::string& name : names) text += name + ' ';
        return text;
    }

    /// From now on imports wait until let go.
    void holdImports() const {
        writeText(folder() / "importer", "#!/bin/sh\nwhile [ -e '" + hold().string() +
                                             "' ]; do sleep 0.02; done\nexec '" +
                                             programPath("rtimport").string() + "' \"$@\"\n");
        fs::permissions(folder() / "importer", fs::perms::owner_all);
        ::setenv("RT_IMPORTER", (folder() / "importer").c_str(), 1);
    }
    fs::path hold() const { return folder() / "hold"; }
    /// A server whose next import waits, and a CUI that packs by it.
    void startPack(std::optional<RunningProgram>& packer) {
        holdImports();
        startWith("room.scn");
        writeText(hold(), "");
        packer.emplace(programPath("CUI"), Names{"--instance=" + instance.name(), "pack", "packed"},
                       ProgramSettings{.folder = folder().path()});
        ASSERT_TRUE(comes([&] { return ask({"pack", "progress"}).starts_with("on "); }));
    }
    static bool comes(const std::function<bool()>& what) {
        for (int i = 0; i < 200; ++i) {
            if (what()) return true;
            std::this_thread::sleep_for(50ms);
        }
        return false;
    }
    void expectNothingPacked() const {
        EXPECT_FALSE(fs::exists(folder() / "packed"));
        for (const std::string& name : filesIn(folder().path()))
            EXPECT_EQ(name.find(".rtsuite-pack"), std::string::npos) << name;
    }
};

struct Attack {
    const char* name;
    const char* scene; ///< the file that is opened
    std::function<void(const fs::path& got)> prepare;
    std::string named = "/home/secret.key'"; ///< in the refusal
};

class PackingOf : public Packing, public testing::WithParamInterface<Attack> {};

TEST_P(PackingOf, WhatLiesElsewhereIsRefusedByNameAndNeverPacked) {
    GetParam().prepare(folder() / "got");
    startWith(GetParam().scene);
    refused({"pack", "packed"}, 65, GetParam().named);
    expectNothingPacked();
    // No image and no part of the model: asking for it does not help.
    (void)cui({"pack", "packed", "outside"});
    expectNoSecret();
}

INSTANTIATE_TEST_SUITE_P(
    Each, PackingOf,
    testing::Values(
        Attack{"AbsoluteName", "a.scn",
               [](const fs::path& got) {
                   writeText(got / "a.scn", unused((got.parent_path() / "home/secret.key").string()));
               }},
        Attack{"NameUpwards", "a.scn",
               [](const fs::path& got) { writeText(got / "a.scn", unused("../home/secret.key")); }},
        Attack{"Link", "a.scn",
               [](const fs::path& got) {
                   writeText(got / "a.scn", unused("wall.png"));
                   fs::create_symlink("../home/secret.key", got / "wall.png");
               }},
        Attack{"LinkOfAFolder", "a.scn",
               [](const fs::path& got) {
                   writeText(got / "a.scn", unused("photos/secret.key"));
                   fs::create_directory_symlink("../home", got / "photos");
               }},
        Attack{"UpwardsBehindALink", "a.scn",
               [](const fs::path& got) { // as text it is ./secret.key
                   fs::create_directory(got.parent_path() / "home/below");
                   writeText(got / "a.scn", unused("photos/../secret.key"));
                   fs::create_directory_symlink("../home/below", got / "photos");
                   writeText(got / "secret.key", "a decoy");
               }},
        Attack{"MaterialLibrarysMap", "room.scn",
               [](const fs::path& got) {
                   writeText(got / "room.mtl", "newmtl wall\nmap_Kd ../home/secret.key\n");
               }},
        Attack{"ImageOfGltf", "a.gltf",
               [](const fs::path& got) { writeText(got / "a.gltf", gltfWith("../home/secret.key")); }},
        Attack{"PercentCodes", "a.gltf",
               [](const fs::path& got) { writeText(got / "a.gltf", gltfWith("%2e%2e/home/secret%2Ekey")); }},
        Attack{"PhotoOfTheUsers", "a.scn",
               [](const fs::path& got) { writeText(got / "a.scn", unused("../home/photo.png")); },
               "/home/photo.png'"},
        Attack{"Environment", "a.scn",
               [](const fs::path& got) {
                   writeText(got / "a.scn", "version = 2\nmodel = 'room.obj'\n[[environment]]\n"
                                            "equirectangular = '../home/photo.hdr'\n");
               },
               "/home/photo.hdr'"},
        Attack{"Settings", "a.scn",
               [](const fs::path& got) {
                   writeText(got.parent_path() / "home/my.set", "version = 1\n[live]\nmaxDepth = 3\n");
                   writeText(got / "a.scn", "version = 2\nmodel = 'room.obj'\nsettings = '../home/my.set'\n");
               },
               "/home/my.set'"},
        Attack{"Camera", "a.scn",
               [](const fs::path& got) {
                   writeCamera(got.parent_path() / "home/my.cam", 0);
                   writeText(got / "a.scn",
                             "version = 2\nmodel = 'room.obj'\n[camera]\nfile = '../home/my.cam'\n");
               },
               "/home/my.cam'"},
        Attack{"Model", "a.scn",
               [](const fs::path& got) {
                   writeRoom(got.parent_path() / "home/mine.obj");
                   writeText(got / "a.scn", "version = 2\nmodel = '../home/mine.obj'\n");
               },
               "/home/mine.obj'"}),
    [](const auto& attack) { return attack.param.name; });

TEST_F(Packing, MaterialLibrariesElsewhereAreNeitherReadNorPacked) {
    write("room.obj", triangle("mtllib ../home/secret.key\nmtllib room.mtl\n"));
    startWith("room.scn");
    ASSERT_EQ(cui({"pack", "packed"}).exitCode, 0);
    EXPECT_EQ(packedNames("packed"), "model/room.mtl model/room.obj model/tile.png room.scn ");
    (void)cui({"pack", "again", "outside"});
    expectNoSecret();
}

TEST_F(Packing, TakesFilesWhoseNamesHoldLineEnds) {
    fs::copy_file(folder() / "got/tile.png", folder() / "got/ti\nle.png");
    write("a\nb.gltf", gltfWith("ti\\nle.png"));
    write("a.scn", "version = 2\nmodel = \"a\\nb.gltf\"\n");
    startWith("a.scn");
    ASSERT_EQ(cui({"pack", "packed"}).exitCode, 0);
    EXPECT_EQ(packedNames("packed"), "a.scn model/a\nb.gltf model/ti\nle.png ");
}

TEST_F(Packing, WhatIsNoImageAndNoPartOfTheModelIsLeftOutAndNamed) {
    write("notes.txt", kSecret);
    write("letter.txt", kSecret);
    write("room.mtl", "newmtl wall\nmap_Kd tile.png\nnewmtl other\nmap_Kd letter.txt\n");
    write("room.obj", triangle("mtllib notes.txt\nmtllib room.mtl\n") + "usemtl other\nf 3/3 2/2 1/1\n");
    write("room.scn", unused("notes.txt"));
    startWith("room.scn");
    const std::string answer = ask({"pack", "packed"});
    EXPECT_EQ(answer.rfind("4 files\n", 0), 0U) << answer;
    for (const char* name : {"got/notes.txt", "got/letter.txt"})
        EXPECT_NE(answer.find(name), std::string::npos) << answer;
    EXPECT_EQ(packedNames("packed"), "model/room.mtl model/room.obj model/tile.png room.scn ");
}

TEST_F(Packing, WhatLiesElsewhereComesAlongWhenItIsAskedFor) {
    fs::create_symlink("../home/photo.png", folder() / "got/wall.png");
    write("room.scn",
          "version = 2\nmodel = 'room.obj'\n[[material]]\nname = 'wall'\n"
          "diffuseTexture = 'wall.png'\n[[environment]]\nequirectangular = '../home/photo.hdr'\n");
    startWith("room.scn");
    refused({"pack", "packed"}, 65, "wall.png', a link to '");
    EXPECT_EQ(ask({"pack", "packed", "outside"}), "6 files\n");
    EXPECT_EQ(packedNames("packed"),
              "environments/photo.hdr model/room.mtl model/room.obj model/tile.png room.scn "
              "textures/wall.png ");
    EXPECT_FALSE(fs::is_symlink(folder() / "packed/textures/wall.png"));
}

TEST_F(Packing, PrivateFilesStayPrivateAndLinksWithinTheFolderAreFine) {
    fs::rename(folder() / "got/tile.png", folder() / "got/maps/tile.png");
    fs::create_symlink("maps/tile.png", folder() / "got/tile.png");
    for (const char* name : {"got/room.scn", "got/maps/tile.png", "got/room.obj"})
        fs::permissions(folder() / name, fs::perms::owner_read | fs::perms::owner_write);
    startWith("room.scn");
    EXPECT_EQ(ask({"pack", "packed"}), "4 files\n");
    for (const char* name : {"packed/room.scn", "packed/model/tile.png", "packed/model/room.obj"}) {
        struct stat facts {};
        ASSERT_EQ(::stat((folder() / name).c_str(), &facts), 0);
        EXPECT_EQ(facts.st_mode & 0777U, 0600U) << name;
    }
}

// --- While it is made ---

TEST_F(Packing, OthersAreAnsweredAndEditsAreNotInIt) {
    std::optional<RunningProgram> packer;
    ASSERT_NO_FATAL_FAILURE(startPack(packer));
    refused({"pack", "other"}, 75, "being made already");
    ask({"set", "maxDepth", "3"});
    ipc::Client client(instance.name(), 2s);
    ipc::Ticket second = 0, third = 0;
    client.send("pack " + (folder() / "other").string(), &second);
    client.send("ping", &third);
    EXPECT_EQ(client.wait(third, 5s).status, ipc::ReplyStatus::Done);
    fs::remove(hold());
    const ProgramResult result = packer->wait();
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(result.output, "4 files\n");
    EXPECT_EQ(readBytes(folder() / "packed/room.scn").find("maxDepth = 3"), std::string::npos);
    EXPECT_EQ(ask({"pack", "progress"}), "off\n");
    ask({"pack", "other"});
    EXPECT_NE(readBytes(folder() / "other/room.scn").find("maxDepth = 3"), std::string::npos);
}

TEST_F(Packing, GoesOnWhileAnotherSceneIsShown) {
    std::optional<RunningProgram> packer;
    ASSERT_NO_FATAL_FAILURE(startPack(packer));
    ASSERT_EQ(bspBuilder({"room.obj", "other.bsp"},
                         {.folder = folder().path(), .environment = {{"RT_IMPORTER", ""}}})
                  .exitCode,
              0);
    ask({"load", "scene", "other.bsp"});
    fs::remove(hold());
    EXPECT_EQ(packer->wait().output, "4 files\n");
    EXPECT_EQ(packedNames("packed"), "model/room.mtl model/room.obj model/tile.png room.scn ");
}

TEST_F(Packing, IsGivenUpByACommand) {
    std::optional<RunningProgram> packer;
    ASSERT_NO_FATAL_FAILURE(startPack(packer));
    ask({"pack", "stop"});
    const ProgramResult result = packer->wait();
    EXPECT_EQ(result.exitCode, 130) << result.error;
    EXPECT_NE(result.error.find("stopped"), std::string::npos) << result.error;
    expectNothingPacked();
    fs::remove(hold());
    EXPECT_EQ(ask({"pack", "packed"}), "4 files\n");
}

TEST_F(Packing, IsGivenUpWhenItsClientLeavesOrTheServerEnds) {
    for (const int signal : {SIGINT, SIGKILL}) {
        std::optional<RunningProgram> packer;
        ASSERT_NO_FATAL_FAILURE(startPack(packer));
        packer->send(signal);
        EXPECT_EQ(packer->wait().exitCode, signal == SIGINT ? 130 : -1);
        EXPECT_TRUE(comes([&] { return ask({"pack", "progress"}) == "off\n"; }));
        expectNothingPacked();
        fs::remove(hold());
        ask({"exit"});
    }
    std::optional<RunningProgram> packer;
    ASSERT_NO_FATAL_FAILURE(startPack(packer));
    EXPECT_EQ(end(SIGTERM).exitCode, 143);
    EXPECT_EQ(packer->wait().exitCode, 75);
    expectNothingPacked();
}

} // namespace
