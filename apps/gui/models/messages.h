/// What a server has to say, as its command `messages` prints it: NUMBER warning|offer|event TEXT.
#pragma once

#include <QList>
#include <QString>
#include <QStringList>

#include <optional>

namespace gui {

struct Message {
    quint64 number = 0;   ///< counts from 1
    bool warning = false; ///< else what a key did, or an offer
    QString text;         ///< in English
    bool offer = false;   ///< what was decided for the user, who may want it otherwise
};

/// What an offer of another up axis says.
struct UpOffer {
    QString text;  ///< in the user's language
    QString other; ///< axis: "+y"
};
/// Nothing where the text is none.
std::optional<UpOffer> readUpOffer(const QString& offer);

/// What an offer of another unit says, in the user's language: "1 unit = 0.01 m (guessed, by its size).";
/// nothing where the text is none.
std::optional<QString> readUnitOffer(const QString& offer);

/// What an offer to take guessed materials back says, in the user's language.
std::optional<QString> readMaterialOffer(const QString& offer);

/// Lines that are none are left out.
QList<Message> readMessages(const QString& answer);

/// What a key did, in the user's language as far as it is known: "Light 3: off".
QString eventText(const QString& event);
/// Many warnings in a few lines: those of one kind are counted, files stand without their folders.
QString warningsText(const QStringList& warnings);

} // namespace gui
