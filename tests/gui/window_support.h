/// The whole window, and a model in it by a server of its own.
#pragma once

#include "gui/gui_support.h"

#include "gui/main_window.h"
#include "gui/operations/actions.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"
#include "gui/view/notice_bar.h"

#include <QAction>
#include <QImage>

#include <filesystem>

namespace test {

/// A program that is optional at build.
inline bool hasBridge() { return std::filesystem::exists(programPath("RTBridge")); }

/// Fixture: a small window, seen and active, whose images go to the folder.
class WindowFixture : public GuiTest {
  protected:
    void SetUp() override {
        GuiTest::SetUp();
        window.emplace(name());
        window->preferences().set(gui::pref::pictureFolder, QString::fromStdString(folder().path().string()));
        window->preferences().set(gui::pref::pictureScale, 25);
        // By paths only where a test is about them.
        window->preferences().set(gui::pref::globalIllumination, false);
        window->resize(400, 320);
        window->show();
        window->activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&*window));
    }
    void TearDown() override {
        if (window) window->close();
        window.reset();
    }
    /// Until the first image is there.
    void open(const std::string& scene = "room.obj") {
        window->open(file(scene));
        ASSERT_TRUE(shows(window->session())) << window->notice().text().toStdString();
    }
    void openAndRest(const std::string& scene = "room.obj") {
        ASSERT_NO_FATAL_FAILURE(open(scene));
        ASSERT_TRUE(comes([&] { return status().idle; }));
    }
    const gui::ServerStatus& status() { return window->session().status(); }
    QAction* action(gui::ActionId id) { return window->actions()[id]; }
    QImage grabbed() { return window->view().grab().toImage(); }

    std::optional<gui::MainWindow> window;
};

} // namespace test
