/// The queue in the whole window.
#include "gui/dialog_support.h"
#include "gui/jobs_support.h"
#include "gui/window_support.h"

#include "gui/dialogs/jobs_panel.h"
#include "gui/dialogs/recording_dialog.h"
#include "gui/dialogs/render_dialog.h"
#include "gui/operations/job_operations.h"

#include <QDockWidget>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>

namespace {

using namespace test;
using namespace gui;

class JobsWindowTest : public WithJobs<WindowFixture> {
  protected:
    void TearDown() override {
        queue().cancelAll();
        WindowFixture::TearDown();
    }
    JobQueue& queue() { return window->jobs().queue(); }
};

TEST_F(JobsWindowTest, ThePresentViewIsRendered) {
    openAndRest();
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 1 2 5 0 0 -1 50")).done);
    window->actions()[ActionId::Render]->trigger();
    auto* dialog = window->findChild<RenderDialog*>();
    ASSERT_NE(dialog, nullptr);
    EXPECT_EQ(dialog->source(), RenderDialog::Source::View);
    const QStringList words = dialog->arguments();
    const QSize size = window->session().status().resolution;
    accept(*dialog);
    ASSERT_TRUE(comes([&] { return queue().rowCount() == 1 && !queue().busy(); }));
    EXPECT_EQ(queue().job(0).state, JobState::Done) << text(queue().job(0).log);
    const QString made = file("render-0001.png");
    EXPECT_EQ(QImage(made).size(), size);
    // The same files by hand: they live as long as the job.
    std::vector<std::string> again;
    for (const QString& word : words) again.push_back(text(word));
    again.push_back("--output=again.png");
    for (std::string& word : again) {
        if (word == "--output=" + text(made)) word = "--verbose";
    }
    ASSERT_EQ(test::renderer(again, {.folder = folder().path()}).exitCode, 0);
    EXPECT_EQ(QImage(made), QImage(file("again.png")));
    const std::string camera = text(words.filter(QStringLiteral("--camera=")).first().mid(9));
    EXPECT_NE(readBytes(camera).find("50"), std::string::npos);
    queue().add(longRender("render-0002.png"));
    window->actions()[ActionId::Render]->trigger();
    EXPECT_TRUE(window->findChildren<RenderDialog*>().last()->arguments().contains(
        QStringLiteral("--output=") + file("render-0003.png")))
        << "one is there, one is being made";
    queue().removeFinished();
    EXPECT_FALSE(std::filesystem::exists(camera)) << "no longer than the job";
}

TEST_F(JobsWindowTest, ARecordingBecomesFrames) {
    openAndRest();
    window->actions()[ActionId::Recording]->trigger();
    auto* recording = window->findChild<RecordingDialog*>();
    ASSERT_NE(recording, nullptr);
    EXPECT_FALSE(press(*recording, "film")) << "nothing is recorded";
    ASSERT_TRUE(press(*recording, "Start"));
    ASSERT_TRUE(comes([&] { return window->session().status().recording; }));
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 1 2 5 0 0 -1 50")).done);
    ASSERT_TRUE(comes([&] { return press(*recording, "Stop"); }));
    ASSERT_TRUE(comes([&] { return press(*recording, "film"); }));
    auto* dialog = window->findChild<RenderDialog*>();
    ASSERT_NE(dialog, nullptr);
    EXPECT_EQ(dialog->source(), RenderDialog::Source::List);
    EXPECT_TRUE(dialog->arguments().contains(QStringLiteral("--list=") + file("walk-0001.lst")));
    EXPECT_TRUE(dialog->arguments().contains(QStringLiteral("--video=") + file("walk-0001.mp4")));
    // Images, since a machine for tests may be without ffmpeg.
    field<QLineEdit>(*dialog, "Film")->clear();
    field<QLineEdit>(*dialog, "Output file")->setText(file("frame_####.png"));
    field<QLineEdit>(*dialog, "Frames")->setText(QStringLiteral("1"));
    accept(*dialog);
    ASSERT_TRUE(comes([&] { return queue().rowCount() == 1 && !queue().busy(); }));
    EXPECT_EQ(queue().job(0).state, JobState::Done) << text(queue().job(0).log);
    EXPECT_TRUE(QFile::exists(file("frame_0001.png")));
}

TEST_F(JobsWindowTest, ClosingAsksWhileJobsRun) {
    queue().add(longRender("a.png"));
    queue().add(shortRender("b.png"));
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(window->isVisible());
    auto* question = window->findChild<QMessageBox*>();
    ASSERT_NE(question, nullptr);
    EXPECT_EQ(question->defaultButton()->text(), QStringLiteral("&Keep running"));
    question->defaultButton()->click();
    EXPECT_TRUE(window->isVisible());
    ASSERT_TRUE(comes([&] { return window->findChild<QMessageBox*>() == nullptr; }));
    EXPECT_FALSE(window->close());
    question = window->findChild<QMessageBox*>();
    for (QAbstractButton* button : question->buttons()) {
        if (question->buttonRole(button) == QMessageBox::AcceptRole) button->click();
    }
    EXPECT_FALSE(window->isVisible());
    ASSERT_TRUE(comes([&] { return !queue().busy(); }));
    EXPECT_FALSE(QFile::exists(file("a.png")) || QFile::exists(file("b.png")));
}

TEST_F(JobsWindowTest, ThePanelDoesWhatItsButtonsSay) {
    auto* panel = window->findChild<JobsPanel*>();
    ASSERT_NE(panel, nullptr);
    const auto press = [&](const char* word) {
        for (QAbstractButton* button : panel->findChildren<QAbstractButton*>()) {
            if (button->text() == QLatin1String(word) && button->isEnabled()) return button->click(), true;
        }
        return false;
    };
    EXPECT_FALSE(press("Cancel"));
    const quint64 a = queue().add(longRender("a.png"));
    const quint64 b = queue().add(shortRender("b.png"));
    const quint64 c = queue().add(shortRender("c.png"));
    panel->choose(c);
    EXPECT_TRUE(press("Up"));
    EXPECT_EQ(queue().rowOf(c), 1);
    EXPECT_FALSE(press("Up"));
    EXPECT_TRUE(press("Cancel"));
    EXPECT_EQ(state(queue(), c), JobState::Cancelled);
    EXPECT_TRUE(press("Remove"));
    EXPECT_EQ(queue().rowOf(c), -1);
    panel->choose(a);
    EXPECT_FALSE(press("Remove")) << "it runs";
    EXPECT_TRUE(press("Cancel"));
    ASSERT_TRUE(becomes(queue(), b, JobState::Done));
    panel->choose(b);
    QSignalSpy wanted(panel, &JobsPanel::showWanted);
    EXPECT_TRUE(press("Show"));
    EXPECT_EQ(wanted.count(), 1);
    EXPECT_EQ(wanted.first().first().toString(), file("b.png"));
}

TEST_F(JobsWindowTest, ThePanelIsThereWithTheFirstJobAndSmallBefore) {
    window->resize(700, 480);
    auto* dock = window->findChild<QDockWidget*>(QStringLiteral("jobs"));
    ASSERT_NE(dock, nullptr);
    EXPECT_FALSE(dock->isVisible());
    QAction* action = window->actions()[ActionId::Jobs];
    action->trigger();
    ASSERT_TRUE(dock->isVisible());
    EXPECT_TRUE(comes([&] { return dock->height() < window->height() / 5; })) << dock->height();
    action->trigger();
    ASSERT_FALSE(dock->isVisible());
    const quint64 job = queue().add(shortRender("a.png"));
    EXPECT_TRUE(dock->isVisible());
    EXPECT_TRUE(comes([&] { return dock->height() > window->height() / 5; })) << dock->height();
    ASSERT_TRUE(becomes(queue(), job, JobState::Done));
    window->close(); // with the panel shown
    MainWindow next(name());
    next.show();
    dock = next.findChild<QDockWidget*>(QStringLiteral("jobs"));
    EXPECT_TRUE(comes([&] { return dock->height() < next.height() / 5; })) << "it has no jobs";
    next.close();
}

} // namespace
