#include "gui/dialogs/picture_dialog.h"

#include "gui/models/output_file.h"
#include "gui/models/plain_text.h"
#include "gui/view/picture_view.h"
#include "gui/view/plain_widgets.h"

#include <QAction>
#include <QClipboard>
#include <QDesktopServices>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QScreen>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

namespace gui {

namespace {

constexpr double kZoomStep = 1.25;

QString extensionOf(const QString& path) { return QFileInfo(path).suffix().toLower(); }

} // namespace

PictureDialog::PictureDialog(const QString& file, QWidget* parent)
    : QDialog(parent), file_(file), picture_(file), view_(new PictureView), state_(new PlainLabel) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowFlag(Qt::WindowMaximizeButtonHint);
    setWindowTitle(plainTitle(QFileInfo(file).fileName()));
    view_->setAccessibleName(tr("Image %1").arg(QFileInfo(file).fileName()));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(view_, 1);
    column->addWidget(makeButtons());
    connect(view_, &PictureView::zoomChanged, this, &PictureDialog::showState);
    chooseSize();
    view_->setPicture(picture_);
    view_->setFocus();
}

// As large as the image, as far as the screen has room.
void PictureDialog::chooseSize() {
    const QScreen* screen =
        parentWidget() != nullptr ? parentWidget()->screen() : QGuiApplication::primaryScreen();
    const QSize max = screen->availableSize() * 4 / 5;
    const QSize foot(0, layout()->itemAt(1)->sizeHint().height());
    QSize size = picture_.size() / devicePixelRatioF();
    if (!QRect(QPoint(), max - foot).contains(QRect(QPoint(), size)))
        size.scale(max - foot, Qt::KeepAspectRatio);
    resize((size + foot).expandedTo(QSize(minimumSizeHint().width(), 240)));
}

template <typename Act>
void PictureDialog::addButton(QHBoxLayout& row, const QString& text, const QString& tip,
                              const QList<QKeySequence>& keys, Act act) {
    auto* action = new QAction(text, this);
    action->setShortcuts(keys);
    const QString key = keys.isEmpty() ? QString() : keys.first().toString(QKeySequence::NativeText);
    action->setToolTip(plainTip(key.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, key)));
    connect(action, &QAction::triggered, this, act);
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setAccessibleName(tip);
    button->setFocusPolicy(Qt::TabFocus);
    row.addWidget(button);
}

QWidget* PictureDialog::makeButtons() {
    auto* foot = new QWidget;
    auto* row = new QHBoxLayout(foot);
    const auto zoomBy = [this](double factor) {
        return [this, factor] { view_->setZoom(view_->zoom() * factor); };
    };
    addButton(*row, tr("Fit"), tr("All of the image"), {Qt::Key_0}, [this] { view_->fit(); });
    addButton(*row, tr("1:1"), tr("A pixel for a pixel"), {Qt::Key_1}, [this] { view_->setZoom(1); });
    addButton(*row, QStringLiteral("−"), tr("Smaller"), {Qt::Key_Minus}, zoomBy(1 / kZoomStep));
    addButton(*row, QStringLiteral("+"), tr("Larger"), {Qt::Key_Plus, Qt::Key_Equal}, zoomBy(kZoomStep));
    row->addSpacing(6);
    row->addWidget(state_, 1);
    addButton(*row, tr("Copy"), tr("Copy the image"), {QKeySequence::Copy},
              [this] { QGuiApplication::clipboard()->setImage(picture_); });
    addButton(*row, tr("Save as…"), tr("Save a copy of the image"), {QKeySequence::Save},
              [this] { saveAs(); });
    addButton(*row, tr("Open folder"), tr("Open the folder of the image"), {},
              [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(file_).absolutePath())); });
    return foot;
}

void PictureDialog::showState() {
    constexpr double kPercent = 100;
    state_->setText(tr("%1 × %2, shown at %3 %")
                        .arg(picture_.width())
                        .arg(picture_.height())
                        .arg(qRound(view_->zoom() * kPercent)));
}

QString PictureDialog::saveTo(const QString& path) const {
    if (QFileInfo(path) == QFileInfo(file_)) return {};
    if (extensionOf(path) != extensionOf(file_)) return writeOutput(path, picture_);
    QFile in(file_);
    return in.open(QIODevice::ReadOnly) ? writeOutput(path, in.readAll()) : in.errorString();
}

void PictureDialog::saveAs() {
    auto* dialog = new QFileDialog(this, tr("Save image"), file_, tr("Images (*.png *.jpg *.bmp *.ppm)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->selectFile(file_);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        const QString trouble = saveTo(path);
        if (trouble.isEmpty()) return;
        auto* box = plainBox(QMessageBox::Warning, tr("Save image"),
                             tr("%1 was not written: %2").arg(path, trouble), this);
        box->addButton(QMessageBox::Ok);
        box->open();
    });
    dialog->open();
}

} // namespace gui
