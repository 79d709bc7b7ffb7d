#include "gui/view/hidden_measures.h"

#include "gui/session/session.h"

#include <QStringList>

#include <utility>

namespace gui {

namespace {

constexpr int kPause = 333; ///< milliseconds

} // namespace

HiddenPoints readHidden(const QString& answer) {
    HiddenPoints hidden;
    for (const QString& line : answer.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        const QStringList words = line.split(QLatin1Char(' '), Qt::SkipEmptyParts);
        std::size_t measure = 0;
        for (qsizetype i = 0; i < words.size(); ++i) {
            const uint number = words[i].toUInt(); // 0: none
            if (number == 0) break;
            if (i == 0)
                measure = number - 1;
            else
                hidden.insert({measure, number - 1});
        }
    }
    return hidden;
}

HiddenMeasures::HiddenMeasures(Session& session, QObject* parent) : QObject(parent), session_(session) {
    pause_.setSingleShot(true);
    pause_.setInterval(kPause);
    connect(&pause_, &QTimer::timeout, this, &HiddenMeasures::look);
    connect(&session_, &Session::statusChanged, this, &HiddenMeasures::look);
}

void HiddenMeasures::setWanted(bool wanted) {
    wanted_ = wanted;
    if (!wanted_) {
        asked_.reset();
        take({});
    }
    look();
}

void HiddenMeasures::look() {
    if (!wanted_ || asking_ || pause_.isActive() || !session_.live()) return;
    const Seen now{session_.status().view, session_.status().stateRevision};
    if (asked_ == now) return;
    asked_ = now;
    asking_ = true;
    pause_.start();
    session_.send(command::measureHidden(), this, [this](const Answer& answer) {
        asking_ = false;
        if (wanted_ && answer.done) take(readHidden(answer.text));
        if (!answer.done) asked_.reset(); // it is asked again after the pause
        look();
    });
}

void HiddenMeasures::take(HiddenPoints hidden) {
    if (std::exchange(hidden_, std::move(hidden)) != hidden_) emit changed();
}

} // namespace gui
