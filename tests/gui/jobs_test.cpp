/// The queue with the real Renderer and BSPBuilder, and the dialogs that feed it.
#include "gui/gui_support.h"

#include "gui/dialogs/build_dialog.h"
#include "gui/dialogs/jobs_panel.h"
#include "gui/dialogs/option_fields.h"
#include "gui/dialogs/recording_dialog.h"
#include "gui/dialogs/render_dialog.h"
#include "gui/main_window.h"
#include "gui/operations/actions.h"
#include "gui/operations/job_operations.h"
#include "gui/processes/job_process.h"
#include "gui/processes/job_queue.h"

#include "bspbuilder/builder_spec.h"
#include "common/progress_format.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>

#include <csignal>

namespace {

using namespace test;
using namespace gui;

class JobsTest : public GuiTest {
  protected:
    JobRequest render(const std::string& output, QStringList options = {}) const {
        QStringList words{file("room.obj"), QStringLiteral("--output=") + file(output),
                          QStringLiteral("--threads=1")};
        return {QString::fromStdString(output), QStringLiteral("Renderer"), words + options, file(output),
                nullptr};
    }
    // Takes minutes, if it is left alone.
    JobRequest longRender(const std::string& output) const {
        return render(output, {QStringLiteral("--width=2000"), QStringLiteral("--height=2000"),
                               QStringLiteral("--antialiasing=16")});
    }
    JobRequest shortRender(const std::string& output) const {
        return render(output, {QStringLiteral("--width=32"), QStringLiteral("--height=24")});
    }
    JobState state(const JobQueue& queue, quint64 id) const { return queue.job(queue.rowOf(id)).state; }
    bool becomes(const JobQueue& queue, quint64 id, JobState wanted) const {
        return comes([&] { return state(queue, id) == wanted; });
    }
    static std::string text(const QString& text) { return text.toStdString(); }
    static void accept(QDialog& dialog) {
        auto* buttons = dialog.findChild<QDialogButtonBox*>();
        for (QAbstractButton* button : buttons->buttons()) {
            if (buttons->buttonRole(button) == QDialogButtonBox::AcceptRole) button->click();
        }
    }
    template <typename Field>
    static Field* field(const QWidget& dialog, const char* accessibleName) {
        for (Field* each : dialog.findChildren<Field*>()) {
            if (each->accessibleName() == QLatin1String(accessibleName)) return each;
        }
        ADD_FAILURE() << "no field " << accessibleName;
        return nullptr;
    }
};

TEST_F(JobsTest, ARenderEqualsTheRenderersOwn) {
    JobQueue queue;
    const QAbstractItemModelTester tester(&queue);
    const quint64 id = queue.add(shortRender("a.png"));
    EXPECT_TRUE(queue.busy());
    ASSERT_TRUE(becomes(queue, id, JobState::Done)) << text(queue.job(0).message);
    EXPECT_FALSE(queue.busy());
    ASSERT_EQ(test::renderer({"room.obj", "-o", "b.png", "-w", "32", "-h", "24"}, {.folder = folder().path()})
                  .exitCode,
              0);
    EXPECT_EQ(QImage(file("a.png")).size(), QSize(32, 24));
    EXPECT_EQ(QImage(file("a.png")), QImage(file("b.png")));
    EXPECT_EQ(resultFile(queue.job(0).request.result), file("a.png"));
}

TEST_F(JobsTest, ProgressRises) {
    JobQueue queue;
    QList<double> fractions;
    QObject::connect(&queue, &JobQueue::changed, &queue, [&] {
        const Job& job = queue.job(0);
        if (job.phase == QStringLiteral("rendering") && job.fraction) fractions.append(*job.fraction);
    });
    const quint64 id =
        queue.add(render("a.png", {QStringLiteral("--width=400"), QStringLiteral("--height=300"),
                                   QStringLiteral("--antialiasing=8")}));
    ASSERT_TRUE(becomes(queue, id, JobState::Done));
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    const auto between = std::count_if(fractions.begin(), fractions.end(),
                                       [](double value) { return value > 0 && value < 1; });
    EXPECT_GT(between, 0);
    EXPECT_EQ(queue.index(0, JobQueue::Progress).data(JobQueue::FractionRole).toDouble(), 1);
}

TEST_F(JobsTest, CancelLeavesNothing) {
    JobQueue queue;
    const quint64 id = queue.add(longRender("a.png"));
    ASSERT_TRUE(comes([&] {
        return queue.job(0).fraction.value_or(0) > 0 && queue.job(0).phase == QStringLiteral("rendering");
    }));
    queue.cancel(0);
    EXPECT_EQ(state(queue, id), JobState::Stopping);
    ASSERT_TRUE(becomes(queue, id, JobState::Cancelled));
    EXPECT_EQ(filesIn(folder().path()), std::vector<std::string>{"room.obj"});
    EXPECT_EQ(text(queue.index(0, JobQueue::State).data().toString()), "cancelled");
}

TEST_F(JobsTest, AFailureSaysWhyAndTheNextOneGoesOn) {
    JobQueue queue;
    JobRequest bad = shortRender("a.png");
    bad.arguments[0] = file("nothing.obj");
    const quint64 first = queue.add(bad);
    const quint64 second = queue.add(shortRender("b.png"));
    ASSERT_TRUE(becomes(queue, second, JobState::Done));
    EXPECT_EQ(state(queue, first), JobState::Failed);
    EXPECT_NE(text(queue.job(0).message).find("nothing.obj"), std::string::npos);
    EXPECT_EQ(text(queue.job(0).message).find("Renderer:"), std::string::npos);
    EXPECT_FALSE(QFile::exists(file("a.png")));
}

TEST_F(JobsTest, AUsageErrorIsToldWithoutTheHint) {
    JobQueue queue;
    const quint64 id = queue.add(render("a.png", {QStringLiteral("--width=-5")}));
    ASSERT_TRUE(becomes(queue, id, JobState::Failed));
    EXPECT_NE(text(queue.job(0).message).find("width"), std::string::npos);
    EXPECT_EQ(text(queue.job(0).message).find("--help"), std::string::npos);
}

TEST_F(JobsTest, AKilledProgramIsAFailure) {
    JobQueue queue;
    const quint64 id = queue.add(longRender("a.png"));
    JobRequest missing = shortRender("b.png");
    missing.program = QStringLiteral("NoSuchProgram");
    const quint64 next = queue.add(missing);
    ASSERT_TRUE(comes([&] { return !queue.job(0).phase.isEmpty(); }));
    auto* process = queue.findChild<JobProcess*>();
    ASSERT_NE(process, nullptr);
    ::kill(static_cast<pid_t>(process->process()), SIGKILL);
    ASSERT_TRUE(becomes(queue, id, JobState::Failed));
    EXPECT_NE(text(queue.job(0).message).find("signal 9"), std::string::npos);
    ASSERT_TRUE(becomes(queue, next, JobState::Failed));
    EXPECT_NE(text(queue.job(1).message).find("NoSuchProgram"), std::string::npos);
}

TEST_F(JobsTest, JobsRunOneAtATimeInTheOrderOfTheRows) {
    JobQueue queue;
    const QAbstractItemModelTester tester(&queue);
    QList<quint64> order;
    QObject::connect(&queue, &JobQueue::finished, &queue, [&](quint64 id) { order.append(id); });
    const quint64 a = queue.add(longRender("a.png"));
    const quint64 b = queue.add(shortRender("b.png"));
    const quint64 c = queue.add(shortRender("c.png"));
    const quint64 d = queue.add(shortRender("d.png"));
    EXPECT_EQ(state(queue, a), JobState::Running);
    EXPECT_EQ(state(queue, b), JobState::Waiting);
    EXPECT_FALSE(queue.canMove(0, 1)) << "it runs";
    EXPECT_FALSE(queue.canMove(1, -1)) << "past the one that runs";
    EXPECT_FALSE(queue.canMove(3, 1)) << "past the end";
    queue.move(3, -1);
    queue.move(2, -1); // a d b c
    queue.cancel(queue.rowOf(c));
    queue.cancel(queue.rowOf(a));
    ASSERT_TRUE(comes([&] { return !queue.busy(); }));
    EXPECT_EQ(order, (QList<quint64>{c, a, d, b}));
    EXPECT_FALSE(QFile::exists(file("c.png")));
}

TEST_F(JobsTest, FinishedJobsRunAgainOrGo) {
    JobQueue queue;
    const QAbstractItemModelTester tester(&queue);
    const quint64 a = queue.add(shortRender("a.png"));
    const quint64 b = queue.add(shortRender("b.png"));
    ASSERT_TRUE(becomes(queue, b, JobState::Done));
    ASSERT_TRUE(QFile::remove(file("a.png")));
    queue.runAgain(queue.rowOf(a));
    EXPECT_EQ(queue.rowOf(a), 1);
    ASSERT_TRUE(becomes(queue, a, JobState::Done));
    EXPECT_TRUE(QFile::exists(file("a.png")));
    queue.removeFinished();
    EXPECT_EQ(queue.rowCount(), 0);
    EXPECT_EQ(queue.rowOf(a), -1);
}

TEST_F(JobsTest, TheEndOfTheQueueIsTheEndOfItsProgram) {
    qint64 process = 0;
    {
        JobQueue queue;
        queue.add(longRender("a.png"));
        ASSERT_TRUE(comes([&] { return !queue.job(0).phase.isEmpty(); }));
        process = queue.findChild<JobProcess*>()->process();
        ASSERT_GT(process, 0);
    }
    EXPECT_NE(::kill(static_cast<pid_t>(process), 0), 0);
    EXPECT_EQ(filesIn(folder().path()), std::vector<std::string>{"room.obj"});
}

TEST_F(JobsTest, ABuildMakesAValidTree) {
    BuildDialog dialog(file("room.obj"));
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    JobRequest wanted;
    QObject::connect(&dialog, &BuildDialog::wanted, &dialog, [&](const JobRequest& job) { wanted = job; });
    dialog.findChild<QCheckBox*>()->setChecked(true);
    field<QSpinBox>(dialog, "Histogram")->setValue(8);
    accept(dialog);
    EXPECT_EQ(wanted.result, file("room.bsp"));
    EXPECT_TRUE(wanted.arguments.contains(QStringLiteral("--fast")));
    EXPECT_TRUE(wanted.arguments.contains(QStringLiteral("--histogram=8")));
    JobQueue queue;
    const quint64 id = queue.add(wanted);
    ASSERT_TRUE(becomes(queue, id, JobState::Done)) << text(queue.job(0).message);
    EXPECT_FALSE(queue.job(0).log.isEmpty());
    EXPECT_EQ(test::renderer({"room.bsp", "-o", "b.png", "-w", "8", "-h", "8"}, {.folder = folder().path()})
                  .exitCode,
              0);
}

TEST_F(JobsTest, ProgressLinesAreReadAndOthersAreNot) {
    const app::ProgressState state{
        .phase = "rendering", .fraction = 0.25, .frame = 2, .frames = 9, .secondsLeft = 7.5};
    const auto report = readProgress(QByteArray::fromStdString(app::jsonText(state)));
    ASSERT_TRUE(report.has_value());
    EXPECT_EQ(report->phase, QStringLiteral("rendering"));
    EXPECT_EQ(report->fraction, 0.25);
    EXPECT_EQ(report->frame, 2);
    EXPECT_EQ(report->frames, 9);
    EXPECT_EQ(report->secondsLeft, 7.5);
    EXPECT_FALSE(readProgress("{\"phase\":\"importing\",\"fraction\":null}")->fraction.has_value());
    for (const char* other : {"", "Renderer: {", "{", "{\"fraction\":1}", "{\"phase\":3}", "[]"})
        EXPECT_FALSE(readProgress(other).has_value()) << other;
}

TEST_F(JobsTest, CommandsAreWrittenForAShell) {
    EXPECT_EQ(text(commandText(QStringLiteral("Renderer"),
                               {QStringLiteral("/a b/it's.obj"), QStringLiteral("--output=/x.png")})),
              "Renderer '/a b/it'\\''s.obj' --output=/x.png");
}

TEST_F(JobsTest, TheNewestFrameStandsForAll) {
    writeText(folder() / "frame_0001.png", "x");
    EXPECT_EQ(resultFile(file("frame_####.png")), file("frame_0001.png"));
    EXPECT_TRUE(resultFile(file("other_####.png")).isEmpty());
    EXPECT_TRUE(resultFile(file("none.png")).isEmpty());
}

TEST_F(JobsTest, TheTableOfOptionsMakesTheFields) {
    app::ProgramSpec spec = bspbuilder::builderSpec();
    spec.groups.push_back({"New",
                           {{.name = "brand-new",
                             .value = app::ValueKind::Choice,
                             .help = "something that came later [one]",
                             .choices = {"one", "two"}},
                            {.name = "answer", .help = "answers", .answers = true},
                            {.name = "pair", .value = app::ValueKind::Text, .argument = "NAME=VALUE"}}});
    const OptionFields fields(spec, {QStringLiteral("fast")});
    EXPECT_TRUE(fields.arguments().isEmpty());
    auto* box = field<QComboBox>(fields, "Brand new");
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->toolTip().contains(QStringLiteral("came later")));
    EXPECT_TRUE(box->itemText(0).contains(QStringLiteral("one")));
    box->setCurrentIndex(2);
    field<QLineEdit>(fields, "Crease angle")->setText(QStringLiteral("25.5"));
    field<QLineEdit>(fields, "Pair")->setText(QStringLiteral("a=1 b=\"2 3\""));
    for (QCheckBox* check : fields.findChildren<QCheckBox*>()) {
        EXPECT_FALSE(check->text().contains(QStringLiteral("Fast")));
        if (check->text() == QStringLiteral("Flip textures")) check->setChecked(true);
        EXPECT_NE(check->text(), QStringLiteral("Answer"));
    }
    const QStringList words = fields.arguments();
    EXPECT_EQ(words.size(), 5);
    for (const char* word : {"--crease-angle=25.5", "--flip-textures", "--brand-new=two", "--pair=a=1"})
        EXPECT_TRUE(words.contains(QLatin1String(word))) << word;
}

TEST_F(JobsTest, RenderDialogShowsTheCommandAndWhatIsWrong) {
    RenderContext context;
    context.scene = file("room.obj");
    context.output = file("out.png");
    RenderDialog dialog(context);
    auto* command = field<QLineEdit>(dialog, "Command");
    auto* buttons = dialog.findChild<QDialogButtonBox*>();
    const auto acceptable = [&] {
        for (QAbstractButton* button : buttons->buttons()) {
            if (buttons->buttonRole(button) == QDialogButtonBox::AcceptRole) return button->isEnabled();
        }
        return false;
    };
    EXPECT_TRUE(acceptable());
    EXPECT_TRUE(command->text().startsWith(QStringLiteral("Renderer /")));
    EXPECT_TRUE(command->text().contains(QStringLiteral("--antialiasing=3")));
    field<QLineEdit>(dialog, "FPS")->setText(QStringLiteral("many"));
    EXPECT_FALSE(acceptable()) << "the table says: a number";
    field<QLineEdit>(dialog, "FPS")->setText(QString());
    EXPECT_TRUE(acceptable());
    QSignalSpy wanted(&dialog, &RenderDialog::wanted);
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    dialog.show();
    QTest::keyClick(field<QLineEdit>(dialog, "Output file"), Qt::Key_Return);
    EXPECT_EQ(wanted.count(), 1) << "Return renders";
    dialog.setSource(RenderDialog::Source::List);
    EXPECT_FALSE(acceptable()) << "no list";
    dialog.setSource(RenderDialog::Source::View);
    EXPECT_EQ(dialog.source(), RenderDialog::Source::List) << "there is no server";
    for (const char* unfit : {"Preview", "Parent", "Progress", "Format"}) {
        for (const QLineEdit* line : dialog.findChildren<QLineEdit*>())
            EXPECT_NE(line->accessibleName(), QLatin1String(unfit));
    }
}

TEST_F(JobsTest, EveryFieldHasANameAndEveryMnemonicIsUsedOnce) {
    RenderContext context;
    context.live = true;
    RenderDialog render(context);
    BuildDialog build(file("room.obj"));
    for (QDialog* dialog : std::initializer_list<QDialog*>{&render, &build}) {
        QStringList texts;
        for (const QLabel* label : dialog->findChildren<QLabel*>()) {
            if (label->buddy() == nullptr) continue;
            texts.append(label->text());
            EXPECT_NE(label->buddy()->focusPolicy(), Qt::NoFocus) << text(label->text());
        }
        for (const QAbstractButton* button : dialog->findChildren<QAbstractButton*>())
            texts.append(button->text());
        QStringList mnemonics;
        for (const QString& each : texts) {
            const qsizetype at = each.indexOf(QLatin1Char('&'));
            if (at < 0) continue;
            EXPECT_FALSE(mnemonics.contains(each.mid(at + 1, 1).toLower())) << text(each);
            mnemonics.append(each.mid(at + 1, 1).toLower());
        }
        for (const QWidget* widget : dialog->findChildren<QWidget*>()) {
            const auto* edit = qobject_cast<const QLineEdit*>(widget);
            const bool input =
                (edit != nullptr && qobject_cast<QAbstractSpinBox*>(edit->parentWidget()) == nullptr) ||
                qobject_cast<const QComboBox*>(widget) != nullptr ||
                qobject_cast<const QSpinBox*>(widget) != nullptr;
            if (!input) continue;
            const QList<QLabel*> labels = dialog->findChildren<QLabel*>();
            const bool labelled = std::any_of(labels.begin(), labels.end(),
                                              [&](const QLabel* label) { return label->buddy() == widget; });
            EXPECT_TRUE(labelled || !widget->accessibleName().isEmpty()) << widget->metaObject()->className();
        }
    }
}

// The window with a server.
class JobsWindowTest : public JobsTest {
  protected:
    void SetUp() override {
        GuiTest::SetUp();
        window.emplace(name());
        window->preferences().set(pref::pictureFolder, QString::fromStdString(folder().path().string()));
        window->preferences().set(pref::pictureScale, 25);
        window->resize(400, 320);
        window->show();
    }
    void TearDown() override {
        window->jobs().queue().cancelAll();
        window->close();
        window.reset();
    }
    void open() {
        window->open(file("room.obj"));
        ASSERT_TRUE(shows(window->session()));
        ASSERT_TRUE(comes([&] { return window->session().status().idle; }));
    }
    JobQueue& queue() { return window->jobs().queue(); }
    std::optional<MainWindow> window;
};

TEST_F(JobsWindowTest, ThePresentViewIsRendered) {
    open();
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
    open();
    window->actions()[ActionId::Recording]->trigger();
    auto* recording = window->findChild<RecordingDialog*>();
    ASSERT_NE(recording, nullptr);
    const auto press = [&](const char* word) {
        for (QPushButton* button : recording->findChildren<QPushButton*>()) {
            if (button->text().remove(QLatin1Char('&')).contains(QLatin1String(word)) && button->isEnabled())
                return button->click(), true;
        }
        return false;
    };
    EXPECT_FALSE(press("film")) << "nothing is recorded";
    ASSERT_TRUE(press("Start"));
    ASSERT_TRUE(comes([&] { return window->session().status().recording; }));
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 1 2 5 0 0 -1 50")).done);
    ASSERT_TRUE(comes([&] { return press("Stop"); }));
    ASSERT_TRUE(comes([&] { return press("film"); }));
    auto* dialog = window->findChild<RenderDialog*>();
    ASSERT_NE(dialog, nullptr);
    EXPECT_EQ(dialog->source(), RenderDialog::Source::List);
    EXPECT_TRUE(dialog->arguments().contains(QStringLiteral("--list=") + file("walk-0001.lst")));
    EXPECT_TRUE(dialog->arguments().contains(QStringLiteral("--video=") + file("walk-0001.mp4")));
    // Pictures, since a machine for tests may be without ffmpeg.
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
    EXPECT_EQ(question->defaultButton()->text(), QStringLiteral("&Go on"));
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

} // namespace
