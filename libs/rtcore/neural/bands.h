/// Stages of work on rows, of which each follows the one before it closely, so that between them only some
/// rows are kept.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace rtcore {

/// One stage: rows of squares of 4 x 4 pixels, made by blocks of kBlockSquares.
struct BandStage {
    int rows = 0, columns = 0; ///< of squares
    /// The squares from `column` on of a row. Called by many threads; each has its own scratch. Needs the
    /// rows of the stage before up to one row of squares below. Does not throw.
    std::function<void(int row, int column, int squares, float* scratch)> work;
};

/// Memory of runBands(), kept from run to run.
using BandScratch = std::vector<std::vector<float>>;

/// The rows of squares that all threads make of each stage between two meetings: more for more threads.
int rowsOfBand(int threads);
/// The rows of pixels of a stage that have to be kept for the one behind it.
constexpr int keptRows(int bandRows) { return (2 * bandRows + 2) * 4; }

/// Runs all stages. `floats`: of the scratch memory of each thread, zeros at first. False: `stop` was set,
/// and the results are undefined.
bool runBands(std::span<const BandStage> stages, std::size_t floats, BandScratch& scratch, int threads,
              const std::atomic<bool>* stop);

} // namespace rtcore
