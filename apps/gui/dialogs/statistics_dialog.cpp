#include "gui/dialogs/statistics_dialog.h"

#include "gui/view/plain_widgets.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLocale>
#include <QPushButton>

namespace gui {

namespace {

constexpr int kRefreshMilliseconds = 500;

QString number(double value, int decimals) { return QLocale().toString(value, 'f', decimals); }

} // namespace

StatisticsDialog::StatisticsDialog(Session& session, std::function<double()> delay,
                                   std::function<QString()> origin, QWidget* parent)
    : QDialog(parent), session_(session), delay_(std::move(delay)), origin_(std::move(origin)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Statistics"));
    auto* form = new QFormLayout(this);
    addRow(*form, tr("Server"), server_);
    addRow(*form, tr("State"), state_);
    addRow(*form, tr("Frames/s"), frames_);
    addRow(*form, tr("Frame time"), frameTime_);
    addRow(*form, tr("Displayed"), shown_);
    addRow(*form, tr("Display latency"), delayed_);
    addRow(*form, tr("Image"), image_);
    addRow(*form, tr("Rays/s"), rays_);
    addRow(*form, tr("Indirect light"), indirect_);
    addRow(*form, tr("Resolution"), resolution_);
    addRow(*form, tr("Triangles"), polygons_);
    addRow(*form, tr("Mode"), mode_);
    addRow(*form, tr("Eye"), eye_);
    addRow(*form, tr("Exposure"), exposure_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    form->addRow(buttons);
    constexpr int kWide = 340;
    setMinimumWidth(kWide);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(&session_, &Session::frameChanged, this, [this] { ++received_; });
    connect(&timer_, &QTimer::timeout, this, &StatisticsDialog::refresh);
    clock_.start();
    timer_.start(kRefreshMilliseconds);
    refresh();
}

void StatisticsDialog::addRow(QFormLayout& form, const QString& name, PlainLabel*& value) {
    value = new PlainLabel;
    value->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    value->setAccessibleName(name);
    form.addRow(name + QLatin1Char(':'), value);
}

QString StatisticsDialog::stateName() const {
    if (session_.state() == SessionState::Busy) return tr("busy");
    if (!session_.live()) return tr("not connected");
    const ServerStatus& status = session_.status();
    if (status.progress < 1) return tr("loading");
    if (status.paused) return tr("paused");
    return status.idle ? tr("complete") : tr("drawing");
}

void StatisticsDialog::refresh() {
    const ServerStatus& status = session_.status();
    constexpr double kMilli = 1e3, kMega = 1e6;
    const double seconds = static_cast<double>(clock_.restart()) / kMilli;
    server_->setText(
        session_.live()
            ? tr("%1 (process %2)").arg(session_.instance(), QString::number(session_.serverProcess()))
            : QStringLiteral("–"));
    state_->setText(stateName());
    frames_->setText(number(status.framesPerSecond, 1));
    frameTime_->setText(tr("%1 ms").arg(number(status.frameSeconds * kMilli, 1)));
    shown_->setText(tr("%1 frames/s").arg(seconds > 0 ? number(received_ / seconds, 1) : QString()));
    received_ = 0;
    delayed_->setText(tr("%1 ms").arg(number(delay_() * kMilli, 1)));
    image_->setText(origin_());
    rays_->setText(tr("%1 million").arg(number(status.raysPerSecond / kMega, 2)));
    constexpr double kPercent = 100;
    indirect_->setText(status.indirectError > 0 ? tr("±%1 %").arg(number(kPercent * status.indirectError, 1))
                                                : QStringLiteral("–"));
    resolution_->setText(
        QStringLiteral("%1 × %2").arg(status.resolution.width()).arg(status.resolution.height()));
    polygons_->setText(QLocale().toString(status.polygons));
    mode_->setText(status.view.walking ? tr("Walk") : tr("Fly"));
    const auto [x, y, z] = positionOf(status.view.eye, status.view);
    eye_->setText(QStringLiteral("%1  %2  %3").arg(number(x, 2), number(y, 2), number(z, 2)));
    exposure_->setText(QLocale().toString(static_cast<double>(status.exposure), 'g', 4));
}

} // namespace gui
