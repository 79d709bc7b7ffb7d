/// Text of others in the window: neither markup, nor a mnemonic, nor a change of direction.
#include "gui/window_support.h"

#include "gui/models/plain_text.h"
#include "gui/processes/job_queue.h"
#include "gui/view/plain_widgets.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QTextDocument>

#include <sys/stat.h>

#include <filesystem>

namespace {

namespace plain_text_test {

using namespace test;
using namespace gui;

constexpr qint64 kAtOnce = 2000; ///< milliseconds

TEST(PlainText, IsNeitherMarkupNorMnemonicNorPlaceholder) {
    EXPECT_EQ(plainText(QStringLiteral("a\u202eb\nc\u001b")), QStringLiteral("a\\xe2\\x80\\xaeb\nc\\x1b"));
    EXPECT_EQ(plainTip(QStringLiteral("a & b\nx")), QStringLiteral("a & b\nx"));
    const QString tip = plainTip(QStringLiteral("<h1>x</h1>\n&"));
    EXPECT_EQ(tip, QStringLiteral("<qt>&lt;h1&gt;x&lt;/h1&gt;<br>&amp;</qt>"));
    EXPECT_EQ(plainEntry(QStringLiteral("R&D\t")), QStringLiteral("R&&D\\x09"));
    EXPECT_EQ(plainTitle(QStringLiteral("x[*].scn")), QStringLiteral("x[*][*].scn"));
    // A tip shows the text as it is.
    for (const char* text : {"<b>bold</b>", "&lt;i&gt;", "<img src='/dev/zero'>", "a &amp; b", "1 < 2"}) {
        QTextDocument shown;
        const QString given = plainTip(QString::fromLatin1(text));
        Qt::mightBeRichText(given) ? shown.setHtml(given) : shown.setPlainText(given);
        EXPECT_EQ(shown.toPlainText(), QString::fromLatin1(text));
    }
}

class PlainWindow : public WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        ASSERT_EQ(::mkfifo((folder() / "pipe").c_str(), 0600), 0);
    }
    /// Large text, and a picture that is never read to its end.
    QString markup() const { return QStringLiteral("<h1>x</h1><img src='%1'>").arg(file("pipe")); }
    static bool allPlain(const QWidget& widget) {
        const QList<QLabel*> labels = widget.findChildren<QLabel*>();
        return std::all_of(labels.begin(), labels.end(),
                           [](const QLabel* each) { return each->textFormat() == Qt::PlainText; });
    }
};

TEST_F(PlainWindow, ANameInAForeignSceneIsShownAsItIs) {
    for (const QString& source : {file("pipe"), QStringLiteral("/dev/zero")}) {
        const QString name = QStringLiteral("<h1>x</h1><img src='%1'>*").arg(source);
        writeText(folder() / "foreign.scn", "version = 2\nmodel = \"room.obj\"\n[[material]]\nname = \"" +
                                                name.toStdString() + "\"\nroughness = 0.5\n");
        ASSERT_NO_FATAL_FAILURE(open("foreign.scn"));
        ASSERT_TRUE(comes([&] { return window->notice().text().contains(name); }));
        QElapsedTimer clock;
        clock.start();
        window->notice().grab();
        ASSERT_TRUE(ask(window->session(), command::ping()).done);
        EXPECT_LT(clock.elapsed(), kAtOnce);
        const auto* label = window->notice().findChild<QLabel*>();
        EXPECT_EQ(label->textFormat(), Qt::PlainText);
        EXPECT_TRUE(label->text().contains(name)) << label->text().toStdString();
        window->notice().hide();
        writeText(folder() / "foreign.scn", "");
    }
}

TEST_F(PlainWindow, NoLabelOfItTakesMarkup) {
    window->notice().explain(markup(), {});
    window->view().tell(markup() + QStringLiteral("\u202e"));
    EXPECT_EQ(window->view().told(), markup() + QStringLiteral("\\xe2\\x80\\xae"));
    for (const ActionId id : {ActionId::SettingsPanel, ActionId::LightsPanel, ActionId::ModelPanel,
                              ActionId::BookmarksPanel, ActionId::Jobs, ActionId::StartServer,
                              ActionId::Connect, ActionId::Configure, ActionId::Render, ActionId::BuildTree})
        action(id)->trigger();
    QElapsedTimer clock;
    clock.start();
    window->grab();
    EXPECT_LT(clock.elapsed(), kAtOnce);
    EXPECT_TRUE(allPlain(*window));
}

// Qt asks whether a file may be replaced by a message of its own.
TEST_F(PlainWindow, NorDoMessagesOfQts) {
    QElapsedTimer clock;
    clock.start();
    QMessageBox box(QMessageBox::Warning, QStringLiteral("Save"), markup(), QMessageBox::Ok, &*window);
    box.show();
    box.grab();
    EXPECT_TRUE(allPlain(box));
    QMessageBox* own = plainBox(QMessageBox::Question, QStringLiteral("Replace"), markup(), &*window);
    own->open();
    own->grab();
    EXPECT_EQ(own->text(), markup());
    EXPECT_TRUE(allPlain(*own));
    own->close();
    EXPECT_LT(clock.elapsed(), kAtOnce);
}

TEST_F(PlainWindow, FilesKeepTheirNamesInMenusTitlesAndTips) {
    const std::string name = "R&D [*] <b>x\u202e.obj";
    std::filesystem::copy_file(folder() / "room.obj", folder() / name);
    ASSERT_NO_FATAL_FAILURE(open(name));
    EXPECT_TRUE(window->windowTitle().startsWith(QStringLiteral("R&D [*][*] <b>x\\xe2\\x80\\xae.obj[*] ")))
        << window->windowTitle().toStdString();
    QAction* entry = nullptr;
    for (const QMenu* menu : window->menuBar()->findChildren<QMenu*>()) {
        for (QAction* each : menu->actions())
            if (each->text().startsWith(QStringLiteral("R&&D"))) entry = each;
    }
    ASSERT_NE(entry, nullptr);
    EXPECT_EQ(entry->text(), QStringLiteral("R&&D [*] <b>x\\xe2\\x80\\xae.obj"));
    EXPECT_TRUE(entry->toolTip().startsWith(QStringLiteral("<qt>"))) << entry->toolTip().toStdString();
    EXPECT_TRUE(entry->toolTip().contains(QStringLiteral("&lt;b&gt;x")));
    action(ActionId::Disconnect)->trigger();
    ASSERT_TRUE(comes([&] { return !window->session().live(); }));
    EXPECT_FALSE(window->windowTitle().contains(QChar(0x202e)));
}

} // namespace plain_text_test

} // namespace
