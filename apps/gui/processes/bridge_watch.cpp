#include "gui/processes/bridge_watch.h"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QNetworkAccessManager>
#include <QNetworkProxy>
#include <QNetworkReply>
#include <QNetworkRequest>

namespace gui {

namespace {

constexpr int kWatchPace = 2000, kWatchPatience = 5000; ///< milliseconds

} // namespace

QList<Visitor> readVisitors(const QByteArray& status) {
    QList<Visitor> visitors;
    const QJsonArray instances =
        QJsonDocument::fromJson(status).object().value(QLatin1String("instances")).toArray();
    for (const QJsonValue& instance : instances) {
        const QJsonArray sessions = instance.toObject().value(QLatin1String("sessions")).toArray();
        for (const QJsonValue& session : sessions)
            visitors.append(
                {session.toObject().value(QLatin1String("name")).toString(),
                 session.toObject().value(QLatin1String("role")).toString() == QLatin1String("driver")});
    }
    return visitors;
}

BridgeWatch::BridgeWatch(QObject* parent) : QObject(parent) {
    connect(&timer_, &QTimer::timeout, this, &BridgeWatch::ask);
}

BridgeWatch::~BridgeWatch() = default;

void BridgeWatch::start(const QString& link) {
    const QUrl page(link);
    const QByteArray token = page.fragment().section(QLatin1String("t="), 1).toUtf8();
    if (network_ && token == token_) return;
    stop();
    token_ = token;
    status_ = page.adjusted(QUrl::RemoveFragment).resolved(QUrl(QStringLiteral("status")));
    network_ = std::make_unique<QNetworkAccessManager>();
    network_->setProxy(QNetworkProxy::NoProxy); // it is this machine
    timer_.start(kWatchPace);
    ask();
}

void BridgeWatch::stop() {
    timer_.stop();
    network_.reset();
    become({});
}

void BridgeWatch::ask() {
    QNetworkRequest request(status_);
    request.setRawHeader("Authorization", "Bearer " + token_);
    request.setTransferTimeout(kWatchPatience);
    QNetworkReply* const reply = network_->get(request);
#if QT_CONFIG(ssl)
    // Its certificate need not name this address; we know whom we started here.
    connect(reply, &QNetworkReply::sslErrors, reply, [reply] { reply->ignoreSslErrors(); });
#endif
    connect(reply, &QNetworkReply::finished, this, [this, reply] { take(*reply); });
}

// One that is busy for a while has not lost its visitors.
void BridgeWatch::take(QNetworkReply& reply) {
    reply.deleteLater();
    if (reply.error() == QNetworkReply::NoError) become(readVisitors(reply.readAll()));
}

void BridgeWatch::become(const QList<Visitor>& visitors) {
    if (visitors == visitors_) return;
    visitors_ = visitors;
    emit visitorsChanged();
}

} // namespace gui
