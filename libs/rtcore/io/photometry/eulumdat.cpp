#include "rtcore/io/photometry/photometric_file.h"
#include "rtcore/io/photometry/photometric_numbers.h"
#include "rtcore/io/photometry/web_symmetry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace rtcore {

namespace {

constexpr NumberRange kPercent{0, 100};
constexpr double kMaxSourceSets = 20;

/// What the planes of the file mirror, by its number of symmetry.
enum class Symmetry { None, Axis, PlaneOf0, PlaneOf90, Both };

/// The planes that a file lists intensities of, by their numbers.
struct PlaneRange {
    std::size_t first, count;
};
PlaneRange planesOf(Symmetry symmetry, std::size_t all) {
    switch (symmetry) {
    case Symmetry::None:
        return {0, all};
    case Symmetry::Axis:
        return {0, 1};
    case Symmetry::PlaneOf0:
        return {0, all / 2 + 1};
    case Symmetry::PlaneOf90:
        return {3 * all / 4, all / 2 + 1};
    case Symmetry::Both:
        break;
    }
    return {0, all / 4 + 1};
}

class EulumdatReader {
  public:
    EulumdatReader(std::string_view text, const std::string& name) : lines_(text, name) {}

    PhotometricFile read() {
        readHead();
        const double scale = readSources();
        for (int i = 0; i < 10; ++i) number(form("a direct ratio"));
        const std::vector<double> planes = angles(planes_, {0, 360}, form("a plane's angle"));
        web_.gammas = angles(gammas_, {0, 180}, form("an angle of the axis"));
        choosePlanes(planes);
        readIntensities(scale);
        checkLit(lines_, web_.candela);
        if (!completeWeb(web_))
            lines_.fail(say("its planes do not go with its number of symmetry, {0}; correct one of them",
                            static_cast<int>(symmetry_)));
        return {std::move(web_), {}};
    }

  private:
    void readHead() {
        line(form("the maker"));
        number(form("the kind of luminaire"), {0, 3, true});
        symmetry_ =
            static_cast<Symmetry>(static_cast<int>(number(form("the number of symmetry"), {0, 4, true})));
        planes_ = static_cast<std::size_t>(number(form("the number of planes"), {1, kMaxPlanes, true}));
        number(form("the distance of planes"));
        gammas_ =
            static_cast<std::size_t>(number(form("the number of angles in a plane"), {2, kMaxGammas, true}));
        number(form("the distance of angles"));
        checkCounts(lines_, gammas_, planes_);
        for (int i = 0; i < 5; ++i) line(form("a name"));
        for (int i = 0; i < 9; ++i) number(form("a length"));
        number(form("the downward flux fraction"), kPercent);
        number(form("the light output ratio"), {0, 1000});
        factor_ = number(form("the conversion factor of intensities"), kFactorRange);
        number(form("the tilt of the luminaire"));
    }

    /// Intensities are those of light sources of 1000 lm. The first set of them counts.
    double readSources() {
        const double sets = number(form("the number of sets of light sources"), {1, kMaxSourceSets, true});
        double lumens = 0;
        for (double i = 0; i < sets; ++i) {
            number(form("the number of light sources")); // below 0: the luminaire was measured as a whole
            line(form("the kind of light sources"));
            const double flux = number(form("the lumens of the light sources"), kFactorRange);
            if (i == 0) lumens = flux;
            for (int k = 0; k < 2; ++k) line(form("the colour of the light sources"));
            number(form("the watts"));
        }
        return factor_ * lumens / 1000;
    }

    std::vector<double> angles(std::size_t count, const NumberRange& range, const char* wanted) {
        std::vector<double> all;
        for (std::size_t i = 0; i < count; ++i) {
            const double angle = number(wanted);
            checkAngle(lines_, all, angle, range);
            all.push_back(angle);
        }
        return all;
    }

    /// Those beyond 360 degrees go on counting.
    void choosePlanes(const std::vector<double>& all) {
        const PlaneRange range = planesOf(symmetry_, all.size());
        for (std::size_t i = range.first; i < range.first + range.count; ++i) {
            const bool around = i >= all.size();
            web_.planes.push_back(around ? all[i - all.size()] + 360 : all[i]);
        }
        if (web_.planes.back() > 360) // from -90 on
            for (double& plane : web_.planes) plane -= 360;
        for (std::size_t i = 1; i < web_.planes.size(); ++i)
            if (!(web_.planes[i] > web_.planes[i - 1]))
                lines_.fail(say("its planes do not go with its number of symmetry, {0}; correct one of them",
                                static_cast<int>(symmetry_)));
    }

    void readIntensities(double scale) {
        for (std::size_t i = 0; i < web_.planes.size() * gammas_; ++i) {
            const double candela = scale * number(form("an intensity"), kIntensityRange);
            checkNumber(lines_, candela, form("an intensity"), kIntensityRange);
            web_.candela.push_back(candela);
        }
        while (const auto more = lines_.next())
            if (!more->empty()) failBehindLast(lines_, *more);
    }

    std::string_view line(const char* wanted) {
        const auto next = lines_.next();
        if (!next) lines_.failCutOff(wanted);
        return *next;
    }

    /// With a point or a comma before the fraction.
    double number(const char* wanted, const NumberRange& range = {}) {
        std::string words(line(wanted));
        std::ranges::replace(words, ',', '.');
        const double value = lines_.number(words, wanted);
        checkNumber(lines_, value, wanted, range);
        return value;
    }

    PhotometricLines lines_;
    Symmetry symmetry_ = Symmetry::None;
    std::size_t planes_ = 0, gammas_ = 0;
    double factor_ = 1;
    PhotometricWeb web_;
};

} // namespace

PhotometricFile parseEulumdat(std::string_view text, const std::string& name) {
    return EulumdatReader(text, name).read();
}

} // namespace rtcore
