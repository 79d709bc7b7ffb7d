#include "rtcore/neural/bands.h"

#include "rtcore/neural/convolution.h"
#include "rtcore/platform/threads.h"

#include <algorithm>

namespace rtcore {

namespace {

struct BandBlock {
    const BandStage* stage;
    int row, column;
};

/// The blocks of one step: each stage is a band and a row behind the one before it, since its 3 x 3 pixels
/// reach a row further.
void listBlocks(std::span<const BandStage> stages, int step, int bandRows, std::vector<BandBlock>& blocks) {
    blocks.clear();
    int first = step * bandRows;
    for (const BandStage& stage : stages) {
        const int last = std::min(first + bandRows, stage.rows);
        for (int row = std::max(first, 0); row < last; ++row)
            for (int column = 0; column < stage.columns; column += kBlockSquares)
                blocks.push_back({&stage, row, column});
        first -= bandRows + 1;
    }
}

int stepCount(std::span<const BandStage> stages, int bandRows) {
    int steps = 0, behind = 0;
    for (const BandStage& stage : stages) {
        steps = std::max(steps, (stage.rows + behind + bandRows - 1) / bandRows);
        behind += bandRows + 1;
    }
    return steps;
}

} // namespace

int rowsOfBand(int threads) {
    constexpr int kThreadsOfRow = 4, kMaxRowsOfBand = 8;
    return std::clamp((threadsFor(threads) + kThreadsOfRow - 1) / kThreadsOfRow, 1, kMaxRowsOfBand);
}

bool runBands(std::span<const BandStage> stages, std::size_t floats, BandScratch& scratch, int threads,
              const std::atomic<bool>* stop) {
    const int team = threadsFor(threads), bandRows = rowsOfBand(threads);
    const int steps = stepCount(stages, bandRows);
    if (scratch.size() < static_cast<std::size_t>(team)) scratch.resize(static_cast<std::size_t>(team));
    for (std::vector<float>& each : scratch)
        if (each.size() < floats) each.assign(floats, 0.0F);
    std::vector<BandBlock> blocks;
    bool stopped = false;
#pragma omp parallel num_threads(team)
    {
        float* const mine = scratch[static_cast<std::size_t>(threadNumber())].data();
        for (int step = 0; step < steps; ++step) {
#pragma omp single
            {
                stopped = stop != nullptr && stop->load(std::memory_order_relaxed);
                listBlocks(stages, step, bandRows, blocks);
            }
            if (stopped) break;
            const int count = static_cast<int>(blocks.size());
#pragma omp for schedule(dynamic, 1)
            for (int i = 0; i < count; ++i) {
                const BandBlock& block = blocks[static_cast<std::size_t>(i)];
                const BandStage& stage = *block.stage;
                stage.work(block.row, block.column, std::min(kBlockSquares, stage.columns - block.column),
                           mine);
            }
        }
    }
    return !stopped;
}

} // namespace rtcore
