/// The window in Czech: complete, and as good to use by keyboard as in English.
#include "gui/dialogs/configure_dialog.h"
#include "gui/dialogs/connect_dialog.h"
#include "gui/dialogs/export_camera_dialog.h"
#include "gui/dialogs/log_dialog.h"
#include "gui/dialogs/plan_dialog.h"
#include "gui/dialogs/recording_dialog.h"
#include "gui/dialogs/share_dialog.h"
#include "gui/dialogs/start_server_dialog.h"
#include "gui/main_window.h"
#include "gui/models/action_table.h"
#include "gui/models/bookmark_store.h"
#include "gui/operations/actions.h"
#include "gui/processes/server_keeper.h"
#include "gui/session/session.h"
#include "gui/view/notice_bar.h"
#include "gui/view/start_page.h"

#include "gui/gui_support.h"
#include "gui/translation_file.h"

#include <QAbstractButton>
#include <QAction>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QLabel>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTabBar>
#include <QTabWidget>
#include <QTranslator>

#include <memory>

namespace {

using namespace gui;
using test::GuiTest;

QStringList placeholders(const QString& text) {
    static const QRegularExpression number(QStringLiteral("%[0-9]"));
    QStringList found;
    for (auto each = number.globalMatch(text); each.hasNext();) found.append(each.next().captured());
    found.sort();
    return found;
}

QChar mnemonic(const QString& text) {
    const qsizetype mark = text.indexOf(QLatin1Char('&'));
    return mark < 0 || mark + 1 >= text.size() ? QChar() : text[mark + 1].toLower();
}

void checkMessages(const QList<test::Message>& all) {
    for (const test::Message& each : all) {
        const std::string where = each.source.toStdString();
        EXPECT_TRUE(each.finished) << where;
        EXPECT_FALSE(each.translation.isEmpty()) << where;
        EXPECT_EQ(placeholders(each.source), placeholders(each.translation)) << where;
        EXPECT_EQ(mnemonic(each.source).isNull(), mnemonic(each.translation).isNull()) << where;
        for (const QChar end : {QChar(u':'), QChar(u'…'), QChar(u'.'), QChar(u']')})
            EXPECT_EQ(each.source.endsWith(end), each.translation.endsWith(end)) << where;
    }
}

TEST(Translation, IsFinishedAndKeepsWhatIsFilledIn) {
    const QList<test::Message> window = test::messages(QStringLiteral(RT_TRANSLATIONS "/gui_cs.ts"));
    EXPECT_GT(window.size(), 200);
    checkMessages(window);
    checkMessages(test::messages(QStringLiteral(RT_TRANSLATIONS "/tables_cs.ts")));
}

/// Parameter: the language.
class LanguageTest : public GuiTest, public testing::WithParamInterface<const char*> {
  protected:
    void SetUp() override {
        GuiTest::SetUp();
        if (std::string(GetParam()) == "en") return;
        translator_ = std::make_unique<QTranslator>();
        ASSERT_TRUE(translator_->load(QStringLiteral(":/translations/gui_cs.qm")));
        QCoreApplication::installTranslator(translator_.get());
    }
    // The destructor of a QTranslator takes it out.

    static void once(QSet<QChar>& seen, const QString& text, const char* where) {
        const QChar key = mnemonic(text);
        if (key.isNull()) return;
        EXPECT_FALSE(seen.contains(key)) << where << ": " << text.toStdString();
        seen.insert(key);
    }
    // No mnemonic occurs twice among texts seen at the same time; pages of tabs are checked one by one.
    static void checkPage(const QWidget& page, QSet<QChar> seen) {
        const char* where = page.metaObject()->className();
        for (const QWidget* each : page.findChildren<QWidget*>()) {
            if (const auto* button = qobject_cast<const QAbstractButton*>(each)) {
                once(seen, button->text(), where);
            } else if (const auto* label = qobject_cast<const QLabel*>(each)) {
                if (label->buddy() != nullptr) once(seen, label->text(), where);
            }
        }
    }

  private:
    std::unique_ptr<QTranslator> translator_;
};

TEST_P(LanguageTest, EachMenuHasEachMnemonicOnce) {
    QHash<MenuId, QSet<QChar>> seen;
    QSet<QChar> menus;
    for (const ActionRow& row : actionTable()) {
        if (!seen.contains(row.menu)) once(menus, menuText(row.menu), "menu bar");
        EXPECT_FALSE(mnemonic(actionText(row)).isNull()) << row.text;
        once(seen[row.menu], actionText(row), row.text);
    }
}

TEST_P(LanguageTest, WhyAServerEndedIsSaidInIt) {
    QTranslator sentences;
    if (std::string(GetParam()) != "en") {
        ASSERT_TRUE(sentences.load(QStringLiteral(":/translations/sentences_cs.qm")));
        QCoreApplication::installTranslator(&sentences);
    }
    test::writeText(folder() / "page.obj", "<html>no model at all</html>");
    Session session;
    ServerKeeper keeper(session);
    QSignalSpy deaths(&keeper, &ServerKeeper::died);
    ServerRequest request = this->request();
    request.scene = file("page.obj");
    keeper.start(request);
    ASSERT_TRUE(test::comes([&] { return deaths.count() == 1; }));
    const QString text = deaths[0][0].toString();
    EXPECT_TRUE(text.contains(QStringLiteral("page.obj"))) << text.toStdString();
    const QString page = QCoreApplication::translate("Server", "a web page, not a model");
    EXPECT_TRUE(text.contains(page)) << text.toStdString();
    EXPECT_EQ(page == QStringLiteral("a web page, not a model"), std::string(GetParam()) == "en");
    EXPECT_TRUE(keeper.server().log().contains(text)) << keeper.server().log().toStdString();
    EXPECT_FALSE(keeper.server().log().contains(QChar(0x1E)));
}

// All that Alt and a letter may mean at one time: menus, the start page, panels, the notice.
TEST_P(LanguageTest, TheWindowHasEachMnemonicOnce) {
    MainWindow window(name());
    window.resize(900, 640);
    window.show();
    for (const ActionId id : {ActionId::SettingsPanel, ActionId::LightsPanel, ActionId::ModelPanel,
                              ActionId::BookmarksPanel, ActionId::Jobs})
        window.actions()[id]->trigger();
    window.notice().explain(QStringLiteral("why"),
                            {window.actions()[ActionId::RestartServer], window.actions()[ActionId::ServerLog],
                             window.actions()[ActionId::Open]});
    QSet<QChar> seen;
    for (const QAction* menu : window.menuBar()->actions()) once(seen, menu->text(), "menu bar");
    EXPECT_GT(seen.size(), 6);
    checkPage(window, seen);
    ASSERT_NE(window.findChild<StartPage*>(), nullptr);
    EXPECT_TRUE(window.findChild<StartPage*>()->isVisible());
}

TEST_P(LanguageTest, EachDialogHasEachMnemonicOnce) {
    Preferences preferences;
    Session session;
    StartServerDialog start(preferences, name(), QSize(640, 480));
    ExportCameraDialog exporting(file("a.cam"), QSize(640, 480), preferences);
    RecordingDialog recording(session, QStringLiteral("/tmp"));
    ConnectDialog connecting(name());
    LogDialog log([] { return QString(); });
    PlanDialog plan(file("plan.pdf"), preferences);
    for (QDialog* dialog :
         std::initializer_list<QDialog*>{&start, &exporting, &recording, &connecting, &log, &plan}) {
        dialog->setAttribute(Qt::WA_DeleteOnClose, false);
        checkPage(*dialog, {});
    }
    ShareDialog share(preferences, {});
    share.setAttribute(Qt::WA_DeleteOnClose, false);
    QSet<QChar> buttons;
    for (const QAbstractButton* each : share.findChild<QDialogButtonBox*>()->buttons())
        once(buttons, each->text(), "sharing");
    checkPage(*share.findChild<SharePlanPage*>(), buttons);
    checkPage(share.links(), buttons);
    ConfigureDialog configure(preferences, session);
    configure.setAttribute(Qt::WA_DeleteOnClose, false);
    const auto* tabs = configure.findChild<QTabWidget*>();
    QSet<QChar> names;
    for (int i = 0; i < tabs->count(); ++i) once(names, tabs->tabText(i), "tabs");
    for (int i = 0; i < tabs->count(); ++i) checkPage(*tabs->widget(i), names);
}

// A text that is looked for under another name than the one it is filed under stays English.
TEST_P(LanguageTest, TextsAreFound) {
    const bool czech = std::string(GetParam()) == "cs";
    EXPECT_EQ(menuText(MenuId::File), czech ? QStringLiteral("&Soubor") : QStringLiteral("&File"));
    EXPECT_EQ(actionText(actionRow(ActionId::Exit)),
              czech ? QStringLiteral("&Konec") : QStringLiteral("E&xit"));
    EXPECT_EQ(actionTitle(QStringLiteral("jump")), czech ? QStringLiteral("Skok") : QStringLiteral("Jump"));
    EXPECT_EQ(BookmarkStore().freeName(), czech ? QStringLiteral("Místo 1") : QStringLiteral("Place 1"));
    ConnectDialog dialog(name());
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    EXPECT_EQ(dialog.windowTitle(), czech ? QStringLiteral("Připojit") : QStringLiteral("Connect"));
}

std::vector<const char*> languages() {
#ifdef RT_TRANSLATED
    return {"en", "cs"};
#else
    return {"en"};
#endif
}

INSTANTIATE_TEST_SUITE_P(Languages, LanguageTest, testing::ValuesIn(languages()),
                         [](const auto& each) { return std::string(each.param); });

} // namespace
