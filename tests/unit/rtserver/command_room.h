/// Fixture: commands of clients, run on a state by a host that only notes what it is asked for.
#pragma once

#include "shown_room.h"

#include "rtserver/failure.h"

#include "rtcore/io/images/image_file.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace test {

/// In command lines DIR is a folder with a.cam (from aside, light 1 off), a.set, a.lst (a.cam alone) and
/// bad.cam; a.pfm is an environment, wide.pfm none.
class CommandRoom : public ShownRoom {
  protected:
    CommandRoom() {
        rtcore::CameraFile aside = cameraFileOf(makeRoom().camera);
        aside.camera.eye.x = 1;
        aside.lights = {false, true};
        rtcore::writeCameraFile(folder / "a.cam", aside);
        std::ofstream(folder / "a.set") << "version = 1\n[live]\nantialiasing = 3\n";
        std::ofstream(folder / "a.lst") << "a.cam\n";
        std::ofstream(folder / "bad.cam") << "nonsense";
        rtcore::writeHdrImage(folder / "a.pfm", rtcore::HdrImage(4, 2, {2, 2, 2}));
        rtcore::writeHdrImage(folder / "wide.pfm", rtcore::HdrImage(5, 2, {2, 2, 2}));
    }
    std::string inFolder(std::string line) const {
        for (std::size_t at = line.find("DIR"); at != std::string::npos; at = line.find("DIR"))
            line.replace(at, 3, folder.path().string());
        return line;
    }
    rtserver::Result run(const std::string& line) {
        return rtserver::runCommand(inFolder(line), state, host);
    }
    /// Its answer, once its work beside the server is done, too.
    std::string answer(const std::string& line) {
        const rtserver::Result result = run(line);
        return result.work ? result.work()().text : result.answer;
    }
    /// The exit code and the text by which it is refused; 0 when it is not.
    rtserver::Failure refusal(const std::string& line) {
        try {
            answer(line);
        } catch (const std::exception& error) {
            return rtserver::failureOf(error);
        }
        return {0, ""};
    }
    void drawFrame() { draw(host.maker, state); }
    bool exists(const std::string& file) const { return std::filesystem::exists(folder / file); }

    TemporaryFolder folder;
    FakeHost host;
};

} // namespace test
