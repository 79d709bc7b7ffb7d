/// Shows what the server has to say: warnings in the notice bar, what keys did below the image, all of it
/// in the log.
#pragma once

#include "gui/models/messages.h"
#include "gui/operations/gui_context.h"

#include <QObject>
#include <QStringList>

class QAction;

namespace gui {

class MessageOperations : public QObject {
    Q_OBJECT

  public:
    MessageOperations(const GuiContext& context, QObject* parent);

  private:
    void onState();
    void onStatus();
    void take(const QList<Message>& messages);
    void warn(const QStringList& warnings);
    void offer(const Message& message);
    void switchOff(const QList<int>& lights);
    void forgetOffers();
    void forgetClosed();
    void notify();
    void hideNotice();
    void showLog();

    GuiContext context_;
    bool live_ = false;
    bool asking_ = false;
    quint64 known_ = 0;                  ///< number of the last one that was shown
    quint64 before_ = 0;                 ///< so many were there when we came
    QStringList heard_;                  ///< all of this server
    QStringList warnings_;               ///< of the notice that is shown
    QAction* turn_;                      ///< accepts offer_
    std::optional<UpOffer> upOffer_;     ///< of the notice that is shown
    QString unitOffer_;                  ///< the same
    QAction* takeBack_;                  ///< accepts materialOffer_
    QString materialOffer_;              ///< the same
    QAction* darken_;                    ///< accepts fillOffer_
    std::optional<FillOffer> fillOffer_; ///< the same
    QString shown_;                      ///< that notice
};

} // namespace gui
