#include "gui/dialogs/render_dialog.h"

#include "gui/dialogs/fields.h"
#include "gui/dialogs/file_field.h"
#include "gui/dialogs/option_fields.h"
#include "gui/models/bookmark_store.h"
#include "gui/models/option_names.h"
#include "gui/models/output_file.h"
#include "gui/models/plain_text.h"
#include "gui/panels/value_box.h"
#include "gui/processes/private_folder.h"
#include "gui/processes/programs.h"
#include "gui/session/server_sentence.h"

#include "common/settings/image_size.h"

#include "renderer/film_format.h"
#include "renderer/renderer_spec.h"

#include "rtcore/neural/net_files.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLineEdit>
#include <QSpinBox>
#include <QStandardItemModel>

namespace gui {

namespace {

// Those with fields of their own, and those that make no sense here.
QStringList ownOptions() {
    static constexpr const char* kNames[] = {"output",       "width",       "height",
                                             "camera",       "list",        "frames",
                                             "video",        "integrator",  "samples",
                                             "antialiasing", "bloom",       "ambient-occlusion",
                                             "ao-samples",   "set",         "no-ambient-occlusion",
                                             "denoise",      "stand-by",    "format",
                                             "preview",      "run-id",      "linger",
                                             "progress",     "parent",      "requeue",
                                             "verify",       "debug-scene", "make-light",
                                             "light-time",   "light-size",  "flight",
                                             "fps",          "make-list",   "size"};
    QStringList names;
    for (const char* name : kNames) names.append(QLatin1String(name));
    return names;
}

enum Size { AsTheScene, Fixed };
enum Integrator { IntegratorAsTheScene, Whitted, Path };
/// In the order of their items.
enum Denoising { UsualNet, SmallNet, LargeNet, Filter, NotDenoised };
enum Occlusion { OcclusionAsTheScene, OcclusionOn, OcclusionOff };

/// Another machine, or a later version, makes the same images or none.
QStringList denoisedBy(rtcore::Net net) {
    const rtcore::NetFile& file = rtcore::fileOf(net);
    constexpr int kDigits = 8;
    return {
        QStringLiteral("--denoise=%1@%2").arg(QLatin1String(file.name), QLatin1String(file.sha256, kDigits))};
}

QString filmFilter() {
    QString names = QString::fromStdString(renderer::filmExtensions());
    names.replace(QStringLiteral(", "), QStringLiteral(" *")).prepend(QLatin1Char('*'));
    return RenderDialog::tr("Films (%1)").arg(names) + QStringLiteral(";;") +
           RenderDialog::tr("All files (*)");
}

QString pictureFilter() {
    return RenderDialog::tr("Images (%1)")
               .arg(QStringLiteral("*.png *.jpg *.bmp *.ppm *.tga *.tiff *.exr *.hdr *.pfm")) +
           QStringLiteral(";;") + RenderDialog::tr("All files (*)");
}

} // namespace

RenderDialog::RenderDialog(const RenderContext& context, QWidget* parent)
    : JobDialog(renderer::rendererSpec(), ownOptions(), parent), live_(context.live),
      proposedOutput_(context.output), files_(std::make_shared<PrivateFolder>("job")) {
    setWindowTitle(tr("Render"));
    makeFields(context);
    layOut();
    listen();
    list_->setPath(context.list);
    setSource(!context.list.isEmpty()     ? Source::List
              : !context.flight.isEmpty() ? Source::Flight
              : live_                     ? Source::View
                                          : Source::Scene);
    onSource();
    addCommonParts(tr("Render"));
}

void RenderDialog::makeFields(const RenderContext& context) {
    constexpr int kShortName = 20;    // letters
    constexpr double kMaxRate = 1000; // --fps
    const QString all = QStringLiteral(";;") + tr("All files (*)");
    source_ = new QComboBox;
    if (live_) source_->addItem(tr("current view"), static_cast<int>(Source::View));
    source_->addItem(tr("a scene or a model"), static_cast<int>(Source::Scene));
    source_->addItem(tr("a recorded list of cameras"), static_cast<int>(Source::List));
    if (live_ && !context.flights.isEmpty())
        source_->addItem(tr("a flight of the scene"), static_cast<int>(Source::Flight));
    flight_ = new QComboBox;
    flight_->addItems(context.flights);
    flight_->setCurrentIndex(static_cast<int>(context.flights.indexOf(context.flight)));
    flight_->setAccessibleName(tr("Flight"));
    flight_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    flight_->setMinimumContentsLength(kShortName);
    rate_ = new ValueBox(0, kMaxRate);
    rate_->setAccessibleName(tr("Frames per second"));
    scene_ = new FileField(FileField::Kind::Open, tr("Scene or model"), sceneFilter());
    scene_->setPath(context.scene);
    if (live_) scene_->edit()->setPlaceholderText(tr("as the server has it now"));
    camera_ = new FileField(FileField::Kind::Open, tr("Camera"), tr("Cameras (*.cam)") + all);
    camera_->edit()->setPlaceholderText(tr("from scene"));
    list_ = new FileField(FileField::Kind::Open, tr("List of cameras"), tr("Lists (*.lst *.txt)") + all);
    frames_ = new QLineEdit;
    frames_->setPlaceholderText(tr("all; or such as 1-100"));
    frames_->setAccessibleName(tr("Frames"));
    output_ = new FileField(FileField::Kind::Save, tr("Output file"), pictureFilter());
    film_ = new FileField(FileField::Kind::Save, tr("Film"), filmFilter());
    film_->edit()->setPlaceholderText(tr("no film"));
    settings_ = new FileField(FileField::Kind::Open, tr("Settings"), tr("Settings (*.set)") + all);
    settings_->edit()->setPlaceholderText(tr("from scene"));

    constexpr QSize kUsual(1920, 1080);
    const QSize size = context.size.isEmpty() ? kUsual : context.size;
    size_ = new QComboBox;
    size_->addItems({tr("from scene"), tr("custom")});
    addNamedSizes();
    size_->setAccessibleName(tr("Resolution"));
    size_->setSizeAdjustPolicy(QComboBox::AdjustToContents); // its words change
    width_ = numberField(1, maxOf("width"), size.width(), tr("Width"));
    height_ = numberField(1, maxOf("height"), size.height(), tr("Height"));
    sizeRow_ = rowOfFields({size_, width_, sign(QStringLiteral("×")), height_});
    integrator_ = new QComboBox;
    integrator_->addItems({tr("as in scene"), tr("fast"), tr("full light")});
    integrator_->setAccessibleName(tr("Quality"));
    samples_ = numberField(0, maxOf("path.samples"), 0, tr("Samples of path tracing"));
    samples_->setSpecialValueText(tr("from scene"));
    samples_->setSuffix(tr(" samples per pixel"));
    integratorRow_ = rowOfFields({integrator_, samples_});
    makeDenoising();
    newNoise_ = new QCheckBox(tr("&Vary noise per frame"));
    newNoise_->setChecked(true);
    newNoise_->setToolTip(tr("Noise that stands still in a film looks like dirt on the glass.") +
                          QStringLiteral("\npath.seedPerFrame"));
    antialiasing_ = numberField(0, maxOf("antialiasing"), context.antialiasing, tr("Anti-aliasing"));
    antialiasing_->setSpecialValueText(tr("from scene"));
    occlusion_ = new QComboBox;
    occlusion_->addItems({tr("from scene"), tr("on"), tr("off")});
    occlusion_->setAccessibleName(tr("Ambient occlusion"));
    occlusionRays_ =
        numberField(0, maxOf("ambientOcclusion.samples"), 0, tr("Rays of the ambient occlusion"));
    occlusionRays_->setSpecialValueText(tr("from scene"));
    occlusionRays_->setSuffix(tr(" rays per point"));
    occlusionRow_ = rowOfFields({occlusion_, occlusionRays_});
    bloom_ = numberField(-1, maxOf("bloom.radius"), -1, tr("Bloom"));
    bloom_->setSpecialValueText(tr("from scene"));
    bloom_->setSuffix(tr(" pixels"));
}

/// By a net, where its weights are: the image of few samples is finished then.
void RenderDialog::makeDenoising() {
    denoising_ = new QComboBox;
    denoising_->addItems({tr("by the net"), tr("by the small net, faster"), tr("by the large net, slower"),
                          tr("by the filter"), tr("off")});
    denoising_->setAccessibleName(tr("Denoise"));
    const rtcore::FoundNet net = rtcore::findNet(rtcore::fileOf(rtcore::Net::Base));
    if (!net.file.empty()) return;
    auto* items = qobject_cast<QStandardItemModel*>(denoising_->model());
    for (const int item : {UsualNet, SmallNet, LargeNet}) {
        items->item(item)->setEnabled(false);
        items->item(item)->setToolTip(plainTip(translated(net.missing)));
    }
    denoising_->setCurrentIndex(Filter);
}

void RenderDialog::layOut() {
    form().addRow(tr("&What:"), source_);
    form().addRow(tr("&Scene or model:"), scene_);
    form().addRow(tr("&Camera:"), camera_);
    form().addRow(tr("&List:"), list_);
    form().addRow(tr("Fli&ght:"), flight_);
    form().addRow(tr("&Frames:"), frames_);
    form().addRow(tr("Frames &per second:"), rate_);
    form().addRow(tr("F&ilm:"), film_);
    form().addRow(tr("&Output:"), output_);
    form().addRow(tr("&Resolution:"), sizeRow_);
    form().addRow(tr("&Quality:"), integratorRow_);
    form().addRow(tr("De&noise:"), denoising_);
    form().addRow(QString(), newNoise_);
    form().addRow(tr("&Anti-aliasing:"), antialiasing_);
    form().addRow(tr("Ambient occl&usion:"), occlusionRow_);
    form().addRow(tr("&Bloom:"), bloom_);
    form().addRow(tr("S&ettings:"), settings_);
    const std::pair<QWidget*, const char*> options[] = {{camera_, "camera"},
                                                        {list_, "list"},
                                                        {flight_, "flight"},
                                                        {frames_, "frames"},
                                                        {rate_, "fps"},
                                                        {film_, "video"},
                                                        {output_, "output"},
                                                        {integrator_, "integrator"},
                                                        {samples_, "samples"},
                                                        {denoising_, "denoise"},
                                                        {antialiasing_, "antialiasing"},
                                                        {occlusionRays_, "ao-samples"},
                                                        {occlusion_, "ambient-occlusion"},
                                                        {bloom_, "bloom"},
                                                        {settings_, "set"},
                                                        {width_, "width"},
                                                        {height_, "height"}};
    for (const auto& [field, option] : options) field->setToolTip(optionTip(spec(), option));
}

void RenderDialog::listen() {
    connect(source_, &QComboBox::currentIndexChanged, this, &RenderDialog::onSource);
    connect(list_, &FileField::pathChanged, this, &RenderDialog::proposeFilm);
    connect(flight_, &QComboBox::currentIndexChanged, this, [this] {
        proposeFilm();
        check();
    });
    connect(rate_, &ValueBox::valueChanged, this, &RenderDialog::check);
    for (FileField* field : {scene_, camera_, list_, output_, film_, settings_})
        connect(field, &FileField::pathChanged, this, &RenderDialog::check);
    for (QComboBox* box : {size_, integrator_, occlusion_, denoising_}) {
        connect(box, &QComboBox::currentIndexChanged, this, &RenderDialog::enableFields);
        connect(box, &QComboBox::currentIndexChanged, this, &RenderDialog::check);
    }
    for (QSpinBox* box : {width_, height_, samples_, antialiasing_, occlusionRays_, bloom_})
        connect(box, &QSpinBox::valueChanged, this, &RenderDialog::check);
    connect(newNoise_, &QCheckBox::toggled, this, &RenderDialog::check);
    connect(frames_, &QLineEdit::textChanged, this, &RenderDialog::check);
    enableFields();
}

// Some of those of the Renderer's --size; their pixels stand beside them.
void RenderDialog::addNamedSizes() {
    const auto add = [this](const QString& name, const app::ImageSize& size) {
        size_->addItem(name, QSize(size.width, size.height));
    };
    for (const app::NamedSize& screen : app::kScreenSizes)
        add(QString::fromLatin1(screen.title.data(), std::ssize(screen.title)), screen.size);
    for (const char* paper : {"A4", "A3"}) {
        if (const auto lying = app::imageSizeOf(paper)) add(QLatin1String(paper), *lying);
        if (const auto upright = app::imageSizeOf(std::string(paper) + "-upright"))
            add(tr("%1 upright").arg(QLatin1String(paper)), *upright);
    }
}

// Fields that an integrator does not use are disabled, and keep their values for the other one.
void RenderDialog::enableFields() {
    if (const QSize named = size_->currentData().toSize(); named.isValid()) {
        width_->setValue(named.width());
        height_->setValue(named.height());
    }
    width_->setEnabled(size_->currentIndex() == Fixed);
    height_->setEnabled(size_->currentIndex() == Fixed);
    samples_->setEnabled(byPaths());
    denoising_->setEnabled(byPaths());
    newNoise_->setEnabled(byPaths());
    antialiasing_->setEnabled(!byPaths());
    occlusion_->setEnabled(!byPaths());
    occlusionRays_->setEnabled(!byPaths() && occlusion_->currentIndex() == OcclusionOn);
    further().setOptionEnabled("ao-distance", !byPaths());
}

bool RenderDialog::byPaths() const { return integrator_->currentIndex() == Path; }

RenderDialog::Source RenderDialog::source() const {
    return static_cast<Source>(source_->currentData().toInt());
}

void RenderDialog::setSource(Source source) {
    const int index = source_->findData(static_cast<int>(source));
    if (index >= 0) source_->setCurrentIndex(index);
}

void RenderDialog::onSource() {
    const Source now = source();
    form().setRowVisible(camera_, now == Source::Scene);
    form().setRowVisible(scene_, now == Source::Scene || now == Source::List);
    form().setRowVisible(list_, now == Source::List);
    form().setRowVisible(flight_, now == Source::Flight);
    for (QWidget* field : std::initializer_list<QWidget*>{frames_, rate_, film_, newNoise_})
        form().setRowVisible(field, hasFrames());
    rate_->setSpecialValueText(now == Source::List ? tr("as recorded, else 25") : QStringLiteral("25"));
    size_->setItemText(AsTheScene, now == Source::View   ? tr("same as viewport")
                                   : now == Source::List ? tr("from recording")
                                                         : tr("from scene"));
    size_->setMinimumWidth(size_->sizeHint().width()); // its least width is that of the words before
    output_->edit()->setPlaceholderText(hasFrames() ? tr("no images; or such as frame_####.png") : QString());
    output_->setPath(hasFrames() ? QString() : proposedOutput_);
    proposeFilm();
    check();
    adjustSize();
}

void RenderDialog::proposeFilm() {
    if (film_->path() != proposedFilm_) return; // the user has chosen another
    film_->setPath(freeFilm());
    proposedFilm_ = film_->path();
}

QString RenderDialog::freeFilm() const {
    if (source() == Source::Flight)
        return nextFreeName(QFileInfo(proposedOutput_).path(), fileNameOf(flight_->currentText()),
                            QStringLiteral("mp4"));
    const QFileInfo list(list_->path());
    const QString name = list.isDir() ? QString() : list.completeBaseName();
    return name.isEmpty() ? QString() : list.dir().filePath(name + QStringLiteral(".mp4"));
}

bool RenderDialog::hasFrames() const { return source() == Source::List || source() == Source::Flight; }

bool RenderDialog::sceneOfServer() const {
    return source() == Source::View || source() == Source::Flight ||
           (source() == Source::List && live_ && scene_->path().isEmpty());
}

QString RenderDialog::exported(const QString& name) const { return files_->file(name); }
QString RenderDialog::sceneFile() const {
    return sceneOfServer() ? exported(QStringLiteral("view.scn")) : scene_->path();
}

QStringList RenderDialog::ownArguments() const {
    const Source now = source();
    QStringList words{sceneFile()};
    const auto option = [&words](const char* name, const QString& value) {
        if (!value.isEmpty()) words.append(QStringLiteral("--%1=%2").arg(QLatin1String(name), value));
    };
    if (now == Source::View) option("camera", exported(QStringLiteral("view.cam")));
    if (now == Source::Scene) option("camera", camera_->path());
    if (now == Source::List) option("list", list_->path());
    if (now == Source::Flight) option("flight", flight_->currentText());
    if (hasFrames()) words += filmArguments();
    option("output", output_->path());
    return words + qualityArguments();
}

QStringList RenderDialog::filmArguments() const {
    constexpr double kUsualRate = 25;
    QStringList words;
    if (!frames_->text().trimmed().isEmpty())
        words.append(QStringLiteral("--frames=") + frames_->text().trimmed());
    if (!film_->path().isEmpty()) words.append(QStringLiteral("--video=") + film_->path());
    const double rate = rate_->value() > 0 ? rate_->value() : kUsualRate;
    if (source() == Source::Flight || rate_->value() > 0) words.append(QStringLiteral("--fps=%1").arg(rate));
    return words;
}

QStringList RenderDialog::qualityArguments() const {
    QStringList words;
    const auto number = [&words](const char* name, int value) {
        words.append(QStringLiteral("--%1=%2").arg(QLatin1String(name)).arg(value));
    };
    if (size_->currentIndex() != AsTheScene) {
        number("width", width_->value());
        number("height", height_->value());
    }
    if (!settings_->path().isEmpty()) words.append(QStringLiteral("--set=") + settings_->path());
    if (bloom_->value() >= 0) number("bloom", bloom_->value());
    if (byPaths()) return words + integratorArguments();
    if (antialiasing_->value() > 0) number("antialiasing", antialiasing_->value());
    return words + integratorArguments() + occlusionArguments();
}

QStringList RenderDialog::integratorArguments() const {
    if (integrator_->currentIndex() == Whitted) return {QStringLiteral("--integrator=whitted")};
    if (!byPaths()) return {};
    QStringList words{QStringLiteral("--integrator=path")};
    if (samples_->value() > 0) words.append(QStringLiteral("--samples=%1").arg(samples_->value()));
    if (hasFrames() && newNoise_->isChecked())
        words.append(QStringLiteral("--setting=path.seedPerFrame=true"));
    return words + denoisingArguments();
}

QStringList RenderDialog::denoisingArguments() const {
    const auto off = [](int passes) {
        return QStringList{QStringLiteral("--denoise=off"),
                           QStringLiteral("--setting=path.filter=%1").arg(passes)};
    };
    constexpr int kPasses = 4; // as for the image at rest
    switch (denoising_->currentIndex()) {
    case UsualNet:
        return denoisedBy(rtcore::Net::Base);
    case SmallNet:
        return denoisedBy(rtcore::Net::Small);
    case LargeNet:
        return denoisedBy(rtcore::Net::Large);
    case Filter:
        return off(kPasses);
    default:
        return off(0) << QStringLiteral("--setting=denoise.passes=0");
    }
}

QStringList RenderDialog::occlusionArguments() const {
    QStringList words;
    if (occlusion_->currentIndex() == OcclusionOff) words.append(QStringLiteral("--no-ambient-occlusion"));
    if (occlusion_->currentIndex() == OcclusionOn) {
        words.append(QStringLiteral("--ambient-occlusion"));
        if (occlusionRays_->value() > 0)
            words.append(QStringLiteral("--ao-samples=%1").arg(occlusionRays_->value()));
    }
    return words;
}

QString RenderDialog::missing() const {
    if (!sceneOfServer() && !QFileInfo(scene_->path()).isFile()) return tr("Choose a scene or a model.");
    const auto gone = [](const FileField* field) {
        return !field->path().isEmpty() && !QFileInfo(field->path()).isFile();
    };
    if (source() == Source::Scene && gone(camera_)) return tr("The camera's file is not there.");
    if (gone(settings_)) return tr("The file of settings is not there.");
    if (source() == Source::List && !QFileInfo(list_->path()).isFile())
        return tr("Choose a list of cameras.");
    if (hasFrames()) {
        if (film_->path().isEmpty() && output_->path().isEmpty()) return tr("Name a film, images, or both.");
    } else if (output_->path().isEmpty()) {
        return tr("Name the file to write.");
    }
    return files_->trouble();
}

// A film before its images.
QString RenderDialog::result() const {
    return hasFrames() && !film_->path().isEmpty() ? film_->path() : output_->path();
}

void RenderDialog::finish() {
    RenderWish wish;
    wish.job = {QFileInfo(result()).fileName(), QStringLiteral("Renderer"), arguments(), result(), files_};
    if (sceneOfServer()) wish.sceneFile = sceneFile();
    if (source() == Source::View) wish.cameraFile = exported(QStringLiteral("view.cam"));
    emit wanted(wish);
}

} // namespace gui
