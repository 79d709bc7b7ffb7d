/// Messages of a server, as its command `messages` prints them: NUMBER warning|offer|event TEXT.
#pragma once

#include "gui/session/server_sentence.h"

#include <QList>
#include <QString>
#include <QStringList>

#include <optional>

namespace gui {

struct Message {
    quint64 number = 0;   ///< counts from 1
    bool warning = false; ///< else the effect of a key, or an offer
    QString text;         ///< in English
    bool offer = false;   ///< a decision for the user, who may want another one
    std::optional<ServerSentence> said = {};

    QString shown() const; ///< in the user's language
};

/// An offer of another up axis.
struct UpOffer {
    QString text;  ///< in the user's language
    QString other; ///< axis: "+y"
};
/// Nothing where the message is no such offer.
std::optional<UpOffer> readUpOffer(const Message& offer);

/// The text of an offer of another unit, in the user's language: "1 unit = 0.01 m (guessed, by its size).";
/// nothing where the message is no such offer.
std::optional<QString> readUnitOffer(const Message& offer);

/// The same of an offer to take guessed materials back.
std::optional<QString> readMaterialOffer(const Message& offer);

/// An offer to switch lights off that stand in for indirect light.
struct FillOffer {
    QString text;      ///< in the user's language
    QList<int> lights; ///< ids
};
/// Nothing where the message is no such offer.
std::optional<FillOffer> readFillOffer(const Message& offer);

/// Lines that are none are left out. `detail` is that of the answer.
QList<Message> readMessages(const QString& answer, const QString& detail);

/// The effect of a key, in the user's language: "Light 3: off".
QString eventText(const Message& event);
/// Many warnings, in the user's language, in a few lines: those of one kind are counted, files stand without
/// their folders.
QString warningsText(const QStringList& warnings);

} // namespace gui
