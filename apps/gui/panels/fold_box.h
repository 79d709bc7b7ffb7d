/// A titled group of fields that folds up: by a click on its title, Space, or the keys Left and Right.
#pragma once

#include <QWidget>

class QToolButton;

namespace gui {

class FoldBox : public QWidget {
    Q_OBJECT

  public:
    /// Takes `content` over. Open at first.
    FoldBox(const QString& title, QWidget* content, QWidget* parent = nullptr);

    void setFolded(bool folded);
    bool folded() const;
    /// A mark behind the title: something inside is not as usual.
    void setMarked(bool marked);
    QToolButton& header() { return *header_; }

  signals:
    /// By the user.
    void foldedChanged(bool folded);

  private:
    void show(bool open);
    bool eventFilter(QObject* watched, QEvent* event) override;

    QString title_;
    QToolButton* header_;
    QWidget* content_;
};

} // namespace gui
