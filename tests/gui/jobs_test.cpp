/// The queue with the real Renderer and BSPBuilder.
#include "gui/jobs_support.h"

#include "gui/processes/job_process.h"

#include "common/progress/progress_format.h"

#include <QAbstractItemModelTester>
#include <QImage>

#include <algorithm>
#include <csignal>
#include <set>

namespace {

using namespace test;
using namespace gui;

class JobsTest : public WithJobs<GuiTest> {};

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
    queue.add(longRender("a.png"));
    constexpr std::size_t kSeveral = 3;
    ASSERT_TRUE(comes([&] { return std::set(fractions.begin(), fractions.end()).size() >= kSeveral; }));
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_LT(fractions.last(), 1);
    queue.cancel(0);
    ASSERT_TRUE(comes([&] { return !queue.busy(); }));
}

TEST_F(JobsTest, ProgressOfWhatIsDoneIsWhole) {
    JobQueue queue;
    ASSERT_TRUE(becomes(queue, queue.add(shortRender("a.png")), JobState::Done));
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

TEST_F(JobsTest, TheNewestFrameStandsForAll) {
    writeText(folder() / "frame_0001.png", "x");
    EXPECT_EQ(resultFile(file("frame_####.png")), file("frame_0001.png"));
    EXPECT_TRUE(resultFile(file("other_####.png")).isEmpty());
    EXPECT_TRUE(resultFile(file("none.png")).isEmpty());
    // Names that would mean something as a pattern of files, or of text.
    for (const QString& name :
         {QStringLiteral("[a]*?"), QStringLiteral("(a|b)+\\d"), QStringLiteral("#1 %1")}) {
        writeText(folder() / (name + QStringLiteral("_0001.png")).toStdString(), "x");
        EXPECT_EQ(resultFile(file(qUtf8Printable(name + QStringLiteral("_####.png")))),
                  file(qUtf8Printable(name + QStringLiteral("_0001.png"))));
    }
}

} // namespace
