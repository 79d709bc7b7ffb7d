#include "bench/rtbench/race.h"

#include "bench/rtbench/agreement.h"
#include "bench/rtbench/stopwatch.h"
#include "bench/rtbench/wave_runner.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace rtbench {

namespace {

constexpr std::size_t kPieceWaves = 2;
constexpr int kFewestRounds = 4;
constexpr double kHopeless = 1.5;

/// A contender's times so far.
struct Runner {
    const Contender* contender = nullptr;
    bool ours = false;
    bool racing = true;
    std::size_t differences = 0;
    std::vector<BestTimes> pieces;

    double best() const {
        double sum = 0;
        for (const BestTimes& piece : pieces) sum += piece.best;
        return sum;
    }
    double spread() const {
        double sum = 0;
        for (const BestTimes& piece : pieces) sum += piece.second;
        return sum / best() - 1;
    }
};

class Race {
  public:
    Race(const RaySet& rays, std::span<const Contender> contenders, const RaceOptions& options)
        : rays_(rays), options_(options), waves_(*rays.test, options.threads) {
        pieceWaves_ = options.threads == 1 ? kPieceWaves : rays.waves.size();
        const std::size_t pieces = (rays.waves.size() + pieceWaves_ - 1) / pieceWaves_;
        for (const Contender& contender : contenders) {
            runners_.push_back({&contender, runners_.empty(), true, 0, std::vector<BestTimes>(pieces)});
        }
    }

    RayFigures run() {
        compare();
        for (round_ = 0; round_ < options_.rounds; ++round_) {
            runRound();
            if (round_ == 0) dropHopeless();
            if (round_ + 1 >= std::min(kFewestRounds, options_.rounds) && spread() <= options_.spread) break;
        }
        return figures();
    }

  private:
    void tell(double fraction) const {
        if (options_.onProgress) options_.onProgress(fraction);
    }

    void compare() {
        std::vector<WaveAnswer> ours, theirs;
        for (Runner& runner : runners_) {
            std::vector<WaveAnswer>& answers = runner.ours ? ours : theirs;
            answers.resize(rays_.waves.size());
            for (std::size_t i = 0; i < answers.size(); ++i) {
                tell(0);
                waves_.run(*runner.contender->tracer, rays_.waves[i], answers[i]);
            }
            if (!runner.ours) runner.differences = countDifferences(*rays_.test, ours, theirs);
        }
    }

    void runRound() {
        const std::size_t pieces = runners_.front().pieces.size();
        for (std::size_t piece = 0; piece < pieces; ++piece) {
            tell((round_ + static_cast<double>(piece) / static_cast<double>(pieces)) / options_.rounds);
            // Another one begins each time, so that none always finds the caches as the same one left them.
            const std::size_t first = static_cast<std::size_t>(round_) + piece;
            for (std::size_t i = 0; i < runners_.size(); ++i) {
                runPiece(runners_[(first + i) % runners_.size()], piece);
            }
        }
    }

    void runPiece(Runner& runner, std::size_t piece) {
        if (!runner.racing) return;
        const std::size_t first = piece * pieceWaves_;
        const std::size_t count = std::min(pieceWaves_, rays_.waves.size() - first);
        const std::span<const rtcore::RayWave> all = rays_.waves;
        const Stopwatch stopwatch(options_.threads);
        waves_.run(*runner.contender->tracer, all.subspan(first, count));
        runner.pieces[piece].add(stopwatch.seconds());
    }

    void dropHopeless() {
        for (const bool robust : {false, true}) {
            const Runner* const best = fastest(robust);
            if (best == nullptr) continue;
            for (Runner& runner : runners_) {
                if (runner.ours || runner.contender->robust != robust) continue;
                runner.racing = runner.best() <= kHopeless * best->best();
            }
        }
    }

    /// The fastest of Embree's robust modes, or of the others; null when none is racing.
    const Runner* fastest(bool robust) const {
        const Runner* best = nullptr;
        for (const Runner& runner : runners_) {
            if (runner.ours || !runner.racing || runner.contender->robust != robust) continue;
            if (best == nullptr || runner.best() < best->best()) best = &runner;
        }
        return best;
    }

    /// The fastest of all of Embree's modes; null when none is racing.
    const Runner* fastest() const {
        const Runner* const robust = fastest(true);
        const Runner* const other = fastest(false);
        if (robust == nullptr || other == nullptr) return robust == nullptr ? other : robust;
        return robust->best() < other->best() ? robust : other;
    }

    double spread() const {
        double largest = runners_.front().spread();
        for (const Runner* rival : {fastest(), fastest(true)}) {
            if (rival != nullptr) largest = std::max(largest, rival->spread());
        }
        return largest;
    }

    double speed(const Runner& runner) const {
        return static_cast<double>(rays_.rays) / runner.best() * 1e-6;
    }

    std::optional<Rival> rival(const Runner* runner) const {
        if (runner == nullptr) return std::nullopt;
        return Rival{runner->contender->name, speed(*runner), runner->best() / runners_.front().best(),
                     runner->differences};
    }

    std::vector<Rival> modes() const {
        std::vector<Rival> all;
        for (const Runner& runner : runners_) {
            if (!runner.ours) all.push_back(*rival(&runner));
        }
        return all;
    }

    RayFigures figures() const {
        RayFigures figures;
        figures.test = rays_.test;
        figures.rays = rays_.rays;
        figures.speed = speed(runners_.front());
        figures.best = rival(fastest());
        figures.robust = rival(fastest(true));
        figures.modes = modes();
        figures.spread = spread();
        return figures;
    }

    const RaySet& rays_;
    const RaceOptions& options_;
    WaveRunner waves_;
    std::size_t pieceWaves_;
    std::vector<Runner> runners_;
    int round_ = 0;
};

} // namespace

RayFigures race(const RaySet& rays, std::span<const Contender> contenders, const RaceOptions& options) {
    return Race(rays, contenders, options).run();
}

} // namespace rtbench
