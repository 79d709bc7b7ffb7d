/// Sharing in a browser: a real RTBridge beside a real server, from the action to the page.
#include "gui/dialog_support.h"
#include "gui/processes_of.h"
#include "gui/window_support.h"

#include "gui/dialogs/qr_dialog.h"
#include "gui/dialogs/share_dialog.h"
#include "gui/models/own_addresses.h"
#include "gui/processes/bridge_watch.h"
#include "gui/session/server_list.h"
#include "gui/view/qr_code.h"
#include "process/bridge/tls_tunnel.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDesktopServices>
#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHostAddress>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSslCertificate>
#include <QSslConfiguration>
#include <QSslSocket>
#include <QTcpSocket>
#include <QTextBrowser>
#include <QUrl>

#include <csignal>
#include <unistd.h>

namespace {

using namespace test;
using namespace gui;

/// The answer that a browser would get.
QByteArray fetched(const QUrl& url) {
    QTcpSocket socket;
    socket.connectToHost(QHostAddress(url.host()), static_cast<quint16>(url.port()));
    if (!socket.waitForConnected(kPatience)) return {};
    socket.write("GET / HTTP/1.1\r\nHost: " + url.authority().toUtf8() + "\r\nConnection: close\r\n\r\n");
    QByteArray answer;
    while (socket.waitForReadyRead(kPatience)) answer += socket.readAll();
    return answer + socket.readAll();
}

/// A page that is open, named Anna, until it is destroyed.
class PageVisitor {
  public:
    explicit PageVisitor(const QUrl& link) {
        socket_.connectToHost(QHostAddress(link.host()), static_cast<quint16>(link.port()));
        EXPECT_TRUE(socket_.waitForConnected(kPatience));
        const QByteArray host = link.authority().toUtf8();
        socket_.write("GET /ws HTTP/1.1\r\nHost: " + host + "\r\nOrigin: http://" + host +
                      "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
                      "Sec-WebSocket-Protocol: rtbridge.1\r\n\r\n");
        EXPECT_TRUE(socket_.waitForReadyRead(kPatience));
        EXPECT_TRUE(socket_.readAll().startsWith("HTTP/1.1 101"));
        const QByteArray hello = R"({"do":"hello","v":2,"name":"Anna","view":{"w":64,"h":48},"token":")" +
                                 link.fragment().section(QLatin1String("t="), 1).toUtf8() + "\"}";
        EXPECT_LT(hello.size(), 126); // else its length takes more bytes
        socket_.write("\x81" + QByteArray(1, static_cast<char>(0x80 | hello.size())) + QByteArray(4, '\0') +
                      hello);
        socket_.flush();
    }
    ~PageVisitor() { socket_.abort(); }
    PageVisitor(const PageVisitor&) = delete;
    PageVisitor& operator=(const PageVisitor&) = delete;

  private:
    QTcpSocket socket_;
};

/// A dialog that offers another network: an address that is this machine's alone.
struct OtherNetwork {
    explicit OtherNetwork(Preferences& preferences)
        : dialog(preferences, {{QStringLiteral("127.0.0.2"), QStringLiteral("test0")}}) {
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        QObject::connect(&dialog, &ShareDialog::startWanted, &dialog,
                         [this](const BridgeRequest& request) { wanted = request; });
    }
    ShareDialog dialog;
    std::optional<BridgeRequest> wanted;
};

/// The desktop's browser, for files.
struct Browser {
    Browser() { QDesktopServices::setUrlHandler(QStringLiteral("file"), &page, "setSource"); }
    ~Browser() { QDesktopServices::unsetUrlHandler(QStringLiteral("file")); }
    Browser(const Browser&) = delete;
    Browser& operator=(const Browser&) = delete;
    QString file() const { return page.source().toLocalFile(); }
    QTextBrowser page;
};

TEST(BridgeWordsTest, AllowNotesOfVisitorsWhereThatIsChosen) {
    BridgeRequest request;
    EXPECT_FALSE(bridgeWords(request).contains(QStringLiteral("--visitor-notes")));
    request.mayNote = true;
    EXPECT_TRUE(bridgeWords(request).contains(QStringLiteral("--visitor-notes")));
}

class ShareTest : public WindowFixture {
  protected:
    void SetUp() override {
        if (!hasBridge()) GTEST_SKIP() << "skipped: there is no RTBridge";
        WindowFixture::SetUp();
        window->preferences().set(pref::progressiveRendering, false);
        ASSERT_NO_FATAL_FAILURE(open());
    }
    ShareDialog* dialog() {
        action(ActionId::ShareInBrowser)->trigger();
        auto* shown = window->findChild<ShareDialog*>();
        EXPECT_TRUE(shown != nullptr && shown->isVisible());
        return shown;
    }
    bool isShared() { return action(ActionId::ShareInBrowser)->isChecked(); }
    /// By the button; the links are there.
    void share(ShareDialog& by) {
        ASSERT_TRUE(press(by, "Share"));
        ASSERT_TRUE(comes([&] { return isShared(); })) << allTexts(by);
    }
    static std::string allTexts(const ShareDialog& dialog) {
        QString text;
        for (const QLabel* label : dialog.findChildren<QLabel*>())
            if (label->isVisibleTo(&dialog)) text += label->text() + QLatin1Char('\n');
        return text.toStdString();
    }
    static bool says(const ShareDialog& dialog, const char* words) {
        return allTexts(dialog).find(words) != std::string::npos;
    }
    static QUrl link(const ShareDialog& dialog, const char* whose) {
        return QUrl(field<QLineEdit>(dialog, whose)->text());
    }
    static QList<Child> bridges() { return childrenOf(::getpid(), QStringLiteral("RTBridge")); }
    bool ends() {
        return comes([&] { return bridges().isEmpty() && !isShared(); });
    }
};

TEST_F(ShareTest, TwoLinksLeadToThePageUntilItIsStopped) {
    ShareDialog* const by = dialog();
    EXPECT_FALSE(isShared()) << "the click alone shares nothing";
    EXPECT_TRUE(bridges().isEmpty());
    ASSERT_NO_FATAL_FAILURE(share(*by));
    const QUrl driver = link(*by, "Driver's link"), viewer = link(*by, "Viewer's link");
    EXPECT_TRUE(field<QLineEdit>(*by, "Driver's link")->isVisible());
    EXPECT_NE(driver, viewer);
    EXPECT_EQ(driver.host(), QStringLiteral("127.0.0.1")) << "nobody else unless it is chosen";
    EXPECT_TRUE(driver.fragment().startsWith(QLatin1String("t="))) << driver.toString().toStdString();
    EXPECT_TRUE(fetched(viewer).startsWith("HTTP/1.1 200"));
    EXPECT_TRUE(window->view().sharing().contains(QStringLiteral("shared")));
    EXPECT_TRUE(says(*by, "No visitors"));

    ASSERT_TRUE(press(*by, "Stop sharing"));
    ASSERT_TRUE(ends());
    EXPECT_TRUE(window->view().sharing().isEmpty());
    EXPECT_FALSE(window->notice().isVisible()) << "it was asked for";
    EXPECT_TRUE(window->session().live()) << "the server goes on";
    ASSERT_NO_FATAL_FAILURE(share(*by));
    EXPECT_NE(link(*by, "Driver's link").fragment(), driver.fragment()) << "old links lead nowhere";
}

TEST_F(ShareTest, ADriversLinkThatWasUsedGivesWayToTheNext) {
    ShareDialog* const by = dialog();
    ASSERT_NO_FATAL_FAILURE(share(*by));
    EXPECT_TRUE(says(*by, "good once"));
    const QUrl driver = link(*by, "Driver's link"), viewer = link(*by, "Viewer's link");
    const PageVisitor first(driver);
    EXPECT_TRUE(comes([&] { return link(*by, "Driver's link") != driver; }));
    const PageVisitor second(link(*by, "Driver's link"));
    EXPECT_TRUE(comes([&] { return says(*by, "Visitors at the moment: 2"); })) << allTexts(*by);
    EXPECT_EQ(link(*by, "Viewer's link"), viewer);
}

TEST_F(ShareTest, LinksAreCopiedAndOpenedWithoutBeingSeenByOthers) {
    const Browser browser;
    ShareDialog* const by = dialog();
    ASSERT_NO_FATAL_FAILURE(share(*by));
    ASSERT_TRUE(press(*by, "Copy"));
    EXPECT_EQ(QGuiApplication::clipboard()->text(), link(*by, "Driver's link").toString());
    EXPECT_TRUE(says(*by, "was copied"));
    ASSERT_TRUE(press(*by, "Open here"));
    ASSERT_FALSE(browser.file().isEmpty());
    QFile page(browser.file());
    ASSERT_TRUE(page.open(QIODevice::ReadOnly));
    EXPECT_TRUE(page.readAll().contains(link(*by, "Driver's link").toString().toUtf8()));
    const auto others = QFileDevice::ReadGroup | QFileDevice::ReadOther;
    EXPECT_FALSE(page.permissions() & others);
    ASSERT_TRUE(press(*by, "Stop sharing"));
    ASSERT_TRUE(ends());
    EXPECT_FALSE(QFileInfo::exists(browser.file()));
}

TEST_F(ShareTest, WithoutDrivingThereIsOneLinkAndTheChoiceStays) {
    for (const bool first : {true, false}) {
        ShareDialog* const by = dialog();
        auto* drive = by->findChild<QCheckBox*>();
        EXPECT_EQ(drive->isChecked(), first);
        drive->setChecked(false);
        ASSERT_NO_FATAL_FAILURE(share(*by));
        EXPECT_FALSE(field<QLineEdit>(*by, "Driver's link")->isVisible());
        EXPECT_TRUE(fetched(link(*by, "Viewer's link")).startsWith("HTTP/1.1 200"));
        ASSERT_TRUE(press(*by, "Stop sharing"));
        ASSERT_TRUE(ends());
        by->close();
        ASSERT_TRUE(comes([&] { return window->findChild<ShareDialog*>() == nullptr; }));
    }
}

TEST_F(ShareTest, TheDialogMayBeClosedAndComesBackWithTheLinks) {
    ShareDialog* by = dialog();
    ASSERT_NO_FATAL_FAILURE(share(*by));
    const QUrl viewer = link(*by, "Viewer's link");
    by->close();
    ASSERT_TRUE(comes([&] { return window->findChild<ShareDialog*>() == nullptr; }));
    EXPECT_TRUE(isShared());
    by = dialog();
    EXPECT_TRUE(isShared()) << "the click changes nothing";
    EXPECT_EQ(link(*by, "Viewer's link"), viewer);
}

TEST_F(ShareTest, ABridgeThatDiesIsExplained) {
    ShareDialog* by = dialog();
    ASSERT_NO_FATAL_FAILURE(share(*by));
    ::kill(bridges().first().process, SIGKILL);
    ASSERT_TRUE(ends());
    EXPECT_TRUE(says(*by, "signal 9")) << allTexts(*by);
    ASSERT_NO_FATAL_FAILURE(share(*by)) << "and can be shared again";
    by->close();
    ASSERT_TRUE(comes([&] { return window->findChild<ShareDialog*>() == nullptr; }));
    ::kill(bridges().first().process, SIGKILL);
    ASSERT_TRUE(comes([&] { return window->notice().isVisible(); }));
    EXPECT_TRUE(window->notice().text().contains(QStringLiteral("signal 9")));
    ASSERT_TRUE(press(window->notice(), "Share in a browser"));
    EXPECT_NE(window->findChild<ShareDialog*>(), nullptr);
}

TEST_F(ShareTest, ItOutlivesADeadServerThatIsRestarted) {
    ShareDialog* const by = dialog();
    ASSERT_NO_FATAL_FAILURE(share(*by));
    const QUrl viewer = link(*by, "Viewer's link");
    const pid_t bridge = bridges().first().process;
    ::kill(static_cast<pid_t>(window->session().serverProcess()), SIGKILL);
    ASSERT_TRUE(comes([&] { return window->session().state() == SessionState::Lost; }));
    for (const char* when : {"after a death", "of a server that lives"}) {
        ASSERT_TRUE(comes([&] { return action(ActionId::RestartServer)->isEnabled(); }));
        const qint64 before = window->session().serverProcess();
        action(ActionId::RestartServer)->trigger();
        ASSERT_TRUE(comes([&] {
            return window->session().live() && window->session().serverProcess() != before;
        })) << when;
        ASSERT_TRUE(shows(window->session()));
        EXPECT_EQ(window->session().instance(), name()) << when;
        ASSERT_TRUE(runs(bridge)) << when;
        EXPECT_EQ(link(*by, "Viewer's link"), viewer);
    }
    const PageVisitor visitor(viewer);
    EXPECT_TRUE(comes([&] { return clientsOf(name()) > 1; })) << "the bridge finds the new server";
}

TEST_F(ShareTest, ItEndsWithTheServerAndWhenTheWindowLeavesIt) {
    for (const bool stopped : {true, false}) {
        ShareDialog* const by = dialog();
        ASSERT_NO_FATAL_FAILURE(share(*by));
        stopped ? window->keeper().stop() : window->session().leave();
        ASSERT_TRUE(ends());
        by->close();
        ASSERT_TRUE(comes([&] { return window->findChild<ShareDialog*>() == nullptr; }));
        EXPECT_FALSE(action(ActionId::ShareInBrowser)->isEnabled());
        if (!stopped) continue;
        ASSERT_TRUE(comes([&] { return !window->keeper().server().running(); }));
        ASSERT_NO_FATAL_FAILURE(open());
    }
}

TEST_F(ShareTest, ClosingTheWindowEndsBridgeAndServer) {
    ShareDialog* const by = dialog();
    ASSERT_NO_FATAL_FAILURE(share(*by));
    const PageVisitor visitor(link(*by, "Viewer's link"));
    ASSERT_TRUE(comes([&] { return clientsOf(name()) > 1; }));
    EXPECT_FALSE(window->keeper().othersUse(name())) << "the bridge is no stranger";
    window->close();
    window.reset();
    for (const char* program : {"RTBridge", "RTServer"})
        EXPECT_TRUE(childrenOf(::getpid(), QLatin1String(program)).isEmpty()) << program;
    EXPECT_TRUE(instance.segments().empty());
}

TEST_F(ShareTest, AnotherNetworkIsAChoiceThatSaysWhatItCosts) {
    OtherNetwork network(window->preferences());
    auto& [by, wanted] = network;
    ASSERT_TRUE(press(by, "Share"));
    EXPECT_TRUE(wanted && wanted->address.isEmpty()) << "this machine alone at first";
    field<QComboBox>(by, "From")->setCurrentIndex(1);
    field<QComboBox>(by, "Encryption")->setCurrentIndex(1);
    EXPECT_FALSE(press(by, "Share")) << "TLS without a certificate";
    field<QComboBox>(by, "Encryption")->setCurrentIndex(2);
    EXPECT_TRUE(says(by, "everybody in between can read images and links"));
    ASSERT_TRUE(press(by, "Share"));
    wanted->instance = name();

    BridgeProcess bridge;
    bridge.start(*wanted);
    ASSERT_TRUE(comes([&] { return !bridge.links().viewer.isEmpty(); }));
    const QUrl viewer(bridge.links().viewer);
    EXPECT_EQ(viewer.host(), QStringLiteral("127.0.0.2"));
    EXPECT_TRUE(fetched(viewer).startsWith("HTTP/1.1 200"));
    by.showLinks(*wanted, bridge.links());
    EXPECT_TRUE(says(by, "Not encrypted"));
    by.show();
    EXPECT_EQ(press(by, "QR code"), hasQrCodes());
    const auto* code = by.findChild<QrDialog*>();
    ASSERT_EQ(code != nullptr, hasQrCodes());
    if (code == nullptr) return;
    // Its three marks in the corners, and light around it.
    const QImage image = code->findChild<QLabel*>()->pixmap().toImage();
    ASSERT_EQ(image.width(), image.height());
    const int unit = 6, last = image.width() - 1;
    for (const QPoint& corner : {QPoint(0, 0), QPoint(last, 0), QPoint(0, last)}) {
        EXPECT_EQ(image.pixelColor(corner), QColor(Qt::white));
        const QPoint inwards(corner.x() == 0 ? 1 : -1, corner.y() == 0 ? 1 : -1);
        for (int i = 4; i < 11; ++i)
            EXPECT_EQ(image.pixelColor(corner + inwards * (i * unit + 1)),
                      i == 5 || i == 9 ? QColor(Qt::white) : QColor(Qt::black));
    }
}

// One that is made, and kept for the next time.
TEST_F(ShareTest, ACertificateIsMadeForOtherNetworks) {
    const QString state = file("state");
    qputenv("XDG_STATE_HOME", state.toUtf8());
    OtherNetwork network(window->preferences());
    auto& [by, wanted] = network;
    field<QComboBox>(by, "From")->setCurrentIndex(1);
    ASSERT_TRUE(press(by, "Share"));
    ASSERT_TRUE(wanted && wanted->ownCertificate && wanted->encrypted());
    wanted->instance = name();
    QString known;
    for (int time = 0; time < 2; ++time) {
        BridgeProcess bridge;
        bridge.start(*wanted);
        ASSERT_TRUE(comes([&] { return !bridge.links().viewer.isEmpty(); }));
        EXPECT_EQ(QUrl(bridge.links().viewer).scheme(), QStringLiteral("https"));
        EXPECT_TRUE(bridge.links().certificate.startsWith(QStringLiteral("SHA-256 ")));
        EXPECT_TRUE(time == 0 || bridge.links().certificate == known);
        known = bridge.links().certificate;
        by.showLinks(*wanted, bridge.links());
        EXPECT_TRUE(says(by, "Browsers ask once"));
        EXPECT_FALSE(says(by, "Not encrypted"));
        const QList<QSslCertificate> made =
            QSslCertificate::fromPath(state + QStringLiteral("/rts/certificate.pem"));
        ASSERT_EQ(made.size(), 1);
        EXPECT_EQ("SHA-256 " + made.first().digest(QCryptographicHash::Sha256).toHex(':').toUpper(),
                  known.toLatin1());
        QSslSocket browser;
        QSslConfiguration trusting = QSslConfiguration::defaultConfiguration();
        trusting.setCaCertificates(made);
        browser.setSslConfiguration(trusting);
        const QUrl viewer(bridge.links().viewer);
        browser.connectToHostEncrypted(viewer.host(), static_cast<quint16>(viewer.port()));
        EXPECT_TRUE(comes([&] { return browser.isEncrypted(); })) << browser.errorString().toStdString();
    }
    const QFileInfo kept(state + QStringLiteral("/rts/certificate.pem"));
    EXPECT_EQ(kept.permissions() & (QFile::ReadGroup | QFile::ReadOther), QFile::Permissions());
    qunsetenv("XDG_STATE_HOME");
}

// A certificate of the user's own, as a browser sees it.
TEST_F(ShareTest, AnotherNetworkIsReachedByTls) {
    const TlsPair pair = makeCertificate(folder().path(), "IP:127.0.0.2");
    if (pair.key.empty() || !QSslSocket::supportsSsl()) GTEST_SKIP() << "skipped: there is no openssl";
    window->preferences().set(pref::shareCertificate, QString::fromStdString(pair.certificate));
    window->preferences().set(pref::shareKey, QString::fromStdString(pair.key));
    OtherNetwork network(window->preferences());
    auto& [by, wanted] = network;
    field<QComboBox>(by, "From")->setCurrentIndex(1);
    ASSERT_TRUE(press(by, "Share"));
    wanted->instance = name();
    BridgeProcess bridge;
    bridge.start(*wanted);
    ASSERT_TRUE(comes([&] { return !bridge.links().viewer.isEmpty(); }));
    const QUrl viewer(bridge.links().viewer);
    EXPECT_EQ(viewer.scheme(), QStringLiteral("https"));
    EXPECT_EQ(viewer.host(), QStringLiteral("127.0.0.2"));
    by.showLinks(*wanted, bridge.links());
    EXPECT_FALSE(says(by, "Not encrypted"));

    QSslSocket browser;
    const QList<QSslCertificate> known = QSslCertificate::fromPath(QString::fromStdString(pair.certificate));
    ASSERT_EQ(known.size(), 1);
    QSslConfiguration trusting = QSslConfiguration::defaultConfiguration();
    trusting.setCaCertificates(known);
    browser.setSslConfiguration(trusting);
    browser.connectToHostEncrypted(viewer.host(), static_cast<quint16>(viewer.port()));
    ASSERT_TRUE(browser.waitForEncrypted(kPatience)) << browser.errorString().toStdString();
    browser.write("GET / HTTP/1.1\r\nHost: " + viewer.authority().toUtf8() + "\r\nConnection: close\r\n\r\n");
    ASSERT_TRUE(browser.waitForReadyRead(kPatience));
    EXPECT_TRUE(browser.readAll().startsWith("HTTP/1.1 200"));
    EXPECT_FALSE(fetched(viewer).startsWith("HTTP/1.1 200")) << "not without TLS";
}

// Every bit of a link counts; no link is too long.
TEST(QrCode, DiffersWithTheText) {
    if (!hasQrCodes()) GTEST_SKIP() << "skipped: built without libqrencode";
    const QString link = QStringLiteral("https://viz.example/#t=") + QString(43, QLatin1Char('a'));
    EXPECT_NE(qrCode(link), qrCode(link.left(link.size() - 1) + QLatin1Char('b')));
    EXPECT_FALSE(qrCode(QStringLiteral("https://") + QString(255, QLatin1Char('h')) + link).isNull());
    EXPECT_TRUE(qrCode(QString(10'000, QLatin1Char('a'))).isNull());
}

TEST_F(ShareTest, WhatTheBridgeRefusesIsToldInItsWords) {
    QString told;
    BridgeProcess bridge;
    QObject::connect(&bridge, &BridgeProcess::ended, &bridge, [&](const QString& text) { told = text; });
    BridgeRequest request;
    request.instance = name();
    request.address = QStringLiteral("198.51.100.7"); // nobody's
    bridge.start(request);
    EXPECT_TRUE(comes([&] { return !bridge.running(); }));
    EXPECT_TRUE(told.contains(request.address)) << told.toStdString();
    request.address.clear();
    request.certificate = request.key = file("room.obj");
    bridge.start(request);
    EXPECT_TRUE(comes([&] { return !bridge.running(); }));
    EXPECT_TRUE(told.contains(QStringLiteral("room.obj"))) << told.toStdString();
}

TEST_F(ShareTest, AMissingOrOtherProgramIsTold) {
    for (const auto& [program, words] :
         {std::pair("RTBridgeThatIsNot", "was found neither"), {"false", "exit code 1"}}) {
        QString told;
        BridgeProcess bridge((QLatin1String(program)));
        QObject::connect(&bridge, &BridgeProcess::ended, &bridge, [&](const QString& text) { told = text; });
        BridgeRequest request;
        request.instance = name();
        bridge.start(request);
        EXPECT_TRUE(comes([&] { return !bridge.running(); }));
        EXPECT_TRUE(told.contains(QLatin1String(words))) << told.toStdString();
    }
}

TEST_F(ShareTest, VisitorsAreCounted) {
    ShareDialog* const by = dialog();
    ASSERT_NO_FATAL_FAILURE(share(*by));
    const QUrl viewer = link(*by, "Viewer's link");
    std::optional<PageVisitor> visitor(viewer);
    EXPECT_TRUE(comes([&] { return says(*by, "Visitors at the moment: 1"); })) << allTexts(*by);
    EXPECT_TRUE(says(*by, "Anna")) << allTexts(*by);
    EXPECT_TRUE(window->view().sharing().endsWith(QLatin1Char('1')));
    visitor.reset();
    EXPECT_TRUE(comes([&] { return says(*by, "No visitors"); }));
}

TEST(BridgeWatchTest, VisitorsAreReadFromAnyStatus) {
    EXPECT_EQ(readVisitors(R"({"instances": [{"sessions": [{"name": "Anna", "role": "driver"},
        {"name": "", "role": "viewer"}]}, {"sessions": [{"name": "Jan", "role": "viewer"}]}]})"),
              (QList<Visitor>{{QStringLiteral("Anna"), true}, {{}, false}, {QStringLiteral("Jan"), false}}));
    for (const char* broken : {"", "[]", "{", R"({"instances": 3})", R"({"instances": [{"sessions": {}}]})"})
        EXPECT_TRUE(readVisitors(broken).isEmpty()) << broken;
}

} // namespace
