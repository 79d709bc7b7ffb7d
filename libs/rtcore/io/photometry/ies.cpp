#include "rtcore/io/photometry/photometric_file.h"
#include "rtcore/io/photometry/photometric_numbers.h"
#include "rtcore/io/photometry/web_symmetry.h"
#include "rtcore/settings/plain_text.h"

#include <algorithm>
#include <utility>

namespace rtcore {

namespace {

constexpr NumberRange kCount{1, 2000, true};

class IesReader {
  public:
    IesReader(std::string_view text, const std::string& name) : lines_(text, name) {}

    PhotometricFile read() {
        readLabels();
        const double scale = readHead();
        readAngles();
        readIntensities(scale);
        checkLit(lines_, web_.candela);
        if (!completeWeb(web_))
            lines_.fail(say("its horizontal angles end at {0} degrees; they span 0, 90, 180 or 360",
                            static_cast<int>(web_.planes.back())));
        return {std::move(web_), std::move(warnings_)};
    }

  private:
    /// Up to the line of the tilt.
    void readLabels() {
        bool first = true;
        for (;;) {
            const auto line = lines_.next();
            if (!line) lines_.failCutOff(form("a line TILT="));
            // The second factor of the ballast had another meaning from 2002 on.
            if (first) isNew_ = line->find("LM-63-20") != std::string_view::npos;
            first = false;
            if (line->starts_with("TILT=")) return readTilt(line->substr(5));
        }
    }

    void readTilt(std::string_view tilt) {
        if (tilt.starts_with("NONE")) return;
        if (!tilt.starts_with("INCLUDE")) {
            warnings_.push_back(
                say("its tilt is in a file of its own, {0}, which does not count", printable(tilt)));
            return;
        }
        number(form("the position of the light source"), {1, 3, true});
        const double pairs = number(form("the number of tilts"), kCount);
        for (double i = 0; i < 2 * pairs; ++i) number(form("a tilt"));
    }

    /// The factor on all intensities.
    double readHead() {
        number(form("the number of light sources"));
        number(form("the lumens of a light source"));
        double scale = number(form("the candela multiplier"), kFactorRange);
        gammas_ = countOf(form("the number of vertical angles"));
        planes_ = countOf(form("the number of horizontal angles"));
        if (gammas_ < 2) lines_.fail(say("it has one vertical angle; two or more are needed"));
        checkCounts(lines_, gammas_, planes_);
        const double type = number(form("the photometric type"), {1, 3, true});
        if (type != 1)
            lines_.fail(
                say("it is of the photometric type {0}; convert it to type C, in which luminaires for "
                    "rooms and streets are measured",
                    std::string(type == 2 ? "B" : "A")));
        number(form("the unit of lengths"), {1, 2, true});
        for (int i = 0; i < 3; ++i) number(form("a side of the luminaire"));
        scale *= number(form("the ballast factor"), kFactorRange);
        if (isNew_)
            number(form("a number for future use"));
        else
            scale *= number(form("the second factor of the ballast"), kFactorRange);
        number(form("the watts"));
        return scale;
    }

    void readAngles() {
        for (std::size_t i = 0; i < gammas_; ++i) addAngle(form("a vertical angle"), {0, 180}, web_.gammas);
        for (std::size_t i = 0; i < planes_; ++i) addAngle(form("a horizontal angle"), {0, 360}, web_.planes);
    }
    void addAngle(const char* wanted, const NumberRange& range, std::vector<double>& angles) {
        const double angle = number(wanted);
        checkAngle(lines_, angles, angle, range);
        angles.push_back(angle);
    }

    void readIntensities(double scale) {
        for (std::size_t i = 0; i < gammas_ * planes_; ++i) {
            const double candela = scale * number(form("an intensity"), kIntensityRange);
            checkNumber(lines_, candela, form("an intensity"), kIntensityRange);
            web_.candela.push_back(candela);
        }
        if (const auto more = word()) failBehindLast(lines_, *more);
    }

    std::size_t countOf(const char* wanted) { return static_cast<std::size_t>(number(wanted, kCount)); }

    double number(const char* wanted, const NumberRange& range = {}) {
        const auto next = word();
        if (!next) lines_.failCutOff(wanted);
        const double value = lines_.number(*next, wanted);
        checkNumber(lines_, value, wanted, range);
        return value;
    }

    /// Words end at white space, commas and ends of lines.
    std::optional<std::string_view> word() {
        constexpr std::string_view kEnds = " \t,";
        for (;;) {
            const std::size_t begin = std::min(rest_.find_first_not_of(kEnds), rest_.size());
            rest_.remove_prefix(begin);
            if (!rest_.empty()) break;
            const auto line = lines_.next();
            if (!line) return std::nullopt;
            rest_ = *line;
        }
        const std::string_view found = rest_.substr(0, rest_.find_first_of(kEnds));
        rest_.remove_prefix(found.size());
        return found;
    }

    PhotometricLines lines_;
    std::string_view rest_; ///< of the line
    bool isNew_ = false;
    std::size_t gammas_ = 0, planes_ = 0;
    PhotometricWeb web_;
    std::vector<Sentence> warnings_;
};

} // namespace

PhotometricFile parseIes(std::string_view text, const std::string& name) {
    return IesReader(text, name).read();
}

} // namespace rtcore
