/// The links of a server that is shared in web pages, and who looks.
#pragma once

#include "gui/processes/bridge_process.h"
#include "gui/processes/bridge_watch.h"

#include <QWidget>

class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace gui {

class PlainLabel;

class ShareLinksPage : public QWidget {
    Q_OBJECT

  public:
    explicit ShareLinksPage(QWidget* parent = nullptr);

    void show(const BridgeRequest& request, const BridgeLinks& links);
    void show(const QList<Visitor>& visitors);
    void tell(const QString& text); ///< about the last action

  signals:
    void openWanted(const QString& link);

  private:
    struct Row {
        QWidget* box;
        QLineEdit* link;
        PlainLabel* meaning;
        QPushButton* code; ///< shows the link as a QR code
    };
    struct RowTexts {
        QString title, copy, open, code, meaning;
    };
    Row addRow(const RowTexts& texts);

    QVBoxLayout* column_;
    Row driver_, viewer_;
    PlainLabel* way_; ///< how other machines get there
    PlainLabel* visitors_;
    PlainLabel* told_;
};

} // namespace gui
